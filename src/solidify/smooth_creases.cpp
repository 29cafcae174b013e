// SPDX-License-Identifier: Apache-2.0
#include "solidify/smooth_creases.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/check_mesh.h"

namespace inkflate {
namespace {

// Facets of the model's own mesh turn by less than the angle with this cosine, 25 degrees.
constexpr double kCreaseCosine = 0.9;
constexpr int kRings = 3;
constexpr int kRounds = 12;
constexpr double kPull = 0.5;
constexpr double kPush = -0.53;  // every other round, for balls
// Half the side of the cells in which triangles that may meet are looked for.
constexpr double kCell = 4;
// Twice the area of a triangle; one of a lattice with cuts in the middle of the steps has 0.5 or more.
constexpr double kLeastArea = 1e-3;

class CreaseSmoother {
  static constexpr std::uint8_t kCrease = 1;
  static constexpr std::uint8_t kBall = 2;

 public:
  CreaseSmoother(MarchedMesh& marched, double base)
      : marched_(marched), mesh_(marched.mesh), base_(base), marks_(mesh_.points.size(), 0) {
    collect_triangles();
  }

  void run() {
    mark();
    auto const before = mesh_.points;
    for (int round = 0; round < kRounds; ++round) move_all(round, false);
    if (is_good()) return;
    mesh_.points = before;
    for (int round = 0; round < kRounds; ++round) move_all(round, true);
  }

 private:
  void collect_triangles() {
    begin_.assign(mesh_.points.size() + 1, 0);
    for (auto const& triangle : mesh_.triangles) {
      for (int const p : triangle) ++begin_[p + 1];
    }
    for (std::size_t p = 1; p < begin_.size(); ++p) begin_[p] += begin_[p - 1];
    triangles_.resize(3 * mesh_.triangles.size());
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
      for (int const p : mesh_.triangles[t]) triangles_[next[p]++] = t;
    }
  }

  Vec3 area_vector(int t) const {
    auto const& [a, b, c] = mesh_.triangles[t];
    auto const& p = mesh_.points;
    return cross(p[b] - p[a], p[c] - p[a]);
  }

  void mark() {
    for (int p = 0; p < std::ssize(mesh_.points); ++p) {
      if (is_crease(p)) marked_.push_back(p);
    }
    for (int const p : marked_) marks_[p] = kCrease;
    for (int ring = 0; ring < kRings; ++ring) add_ring();
    for (int p = 0; p < std::ssize(mesh_.points); ++p) {
      if (!marched_.anchors[p].is_of_ball || marks_[p] != 0) continue;
      marks_[p] = kBall;
      marked_.push_back(p);
    }
  }

  /// The mean of the neighbours: each one belongs to two triangles of the fan.
  Vec3 middle_around(int p) const {
    Vec3 sum;
    for (int i = begin_[p]; i < begin_[p + 1]; ++i) {
      for (int const q : mesh_.triangles[triangles_[i]]) sum += mesh_.points[q];
    }
    int const count = begin_[p + 1] - begin_[p];
    return (sum - mesh_.points[p] * count) / (2 * count);
  }

  /// Whether the surface bends inwards here, and sharply.
  bool is_crease(int p) const {
    Vec3 sum;
    for (int i = begin_[p]; i < begin_[p + 1]; ++i) sum += area_vector(triangles_[i]);
    Vec3 const normal = normalized(sum);
    if (dot(middle_around(p) - mesh_.points[p], normal) <= 0) return false;
    for (int i = begin_[p]; i < begin_[p + 1]; ++i) {
      if (dot(normalized(area_vector(triangles_[i])), normal) < kCreaseCosine) return true;
    }
    return false;
  }

  void add_ring() {
    for (std::size_t m = 0, count = marked_.size(); m < count; ++m) {
      for (int i = begin_[marked_[m]]; i < begin_[marked_[m] + 1]; ++i) {
        for (int const q : mesh_.triangles[triangles_[i]]) {
          if (marks_[q] != 0) continue;
          marks_[q] = kCrease;
          marked_.push_back(q);
        }
      }
    }
  }

  void move_all(int round, bool is_bound) {
    std::vector<Vec3> places;
    places.reserve(marked_.size());
    for (int const p : marked_) {
      Vec3 const now = mesh_.points[p];
      double const share = marks_[p] == kBall && round % 2 != 0 ? kPush : kPull;
      Vec3 const wanted = now + (middle_around(p) - now) * share;
      if (now.z <= base_ || wanted.z <= base_)
        places.push_back(now);
      else
        places.push_back(is_bound ? nearest_allowed(marched_.anchors[p], wanted) : wanted);
    }
    for (std::size_t m = 0; m < marked_.size(); ++m) mesh_.points[marked_[m]] = places[m];
  }

  bool is_moved(int t) const {
    auto const& [a, b, c] = mesh_.triangles[t];
    return marks_[a] != 0 || marks_[b] != 0 || marks_[c] != 0;
  }

  /// Whether all triangles that moved have an area and cross no other.
  bool is_good() const {
    std::vector<int> moved;
    for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
      if (!is_moved(t)) continue;
      if (!(norm(area_vector(t)) > kLeastArea)) return false;
      moved.push_back(t);
    }
    return count_self_crossings(near(moved), 1) == 0;
  }

  /// The triangles that lie in a cell with one of these.
  TriMesh near(std::vector<int> const& triangles) const {
    Vec3 low = mesh_.points[0];
    Vec3 high = low;
    for (auto const& p : mesh_.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    auto const cells = [](double size) { return static_cast<int>(size / kCell) + 1; };
    int const columns = cells(high.x - low.x);
    int const rows = cells(high.y - low.y);
    std::vector<bool> is_near(static_cast<std::size_t>(columns) * rows * cells(high.z - low.z));
    // Triangles are smaller than a cell, so their corners' cells and those between are at most eight.
    auto const visit = [&](int t, auto const& on_cell) {
      auto const& [a, b, c] = mesh_.triangles[t];
      std::array<Vec3, 3> const p = {mesh_.points[a] - low, mesh_.points[b] - low,
                                     mesh_.points[c] - low};
      for (int z = cells(std::min({p[0].z, p[1].z, p[2].z})) - 1;
           z < cells(std::max({p[0].z, p[1].z, p[2].z})); ++z) {
        for (int y = cells(std::min({p[0].y, p[1].y, p[2].y})) - 1;
             y < cells(std::max({p[0].y, p[1].y, p[2].y})); ++y) {
          for (int x = cells(std::min({p[0].x, p[1].x, p[2].x})) - 1;
               x < cells(std::max({p[0].x, p[1].x, p[2].x})); ++x)
            on_cell((z * rows + y) * columns + x);
        }
      }
    };
    for (int const t : triangles) visit(t, [&](int cell) { is_near[cell] = true; });
    TriMesh result;
    result.points = mesh_.points;
    for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
      bool is_wanted = false;
      visit(t, [&](int cell) { is_wanted = is_wanted || is_near[cell]; });
      if (is_wanted) result.triangles.push_back(mesh_.triangles[t]);
    }
    return result;
  }

  MarchedMesh& marched_;
  TriMesh& mesh_;
  double base_;
  std::vector<std::uint8_t> marks_;
  std::vector<int> marked_;
  std::vector<int> begin_;      // per point, into triangles_
  std::vector<int> triangles_;  // around each point
};

}  // namespace

void smooth_creases(MarchedMesh& marched, double base) {
  if (!marched.mesh.points.empty()) CreaseSmoother(marched, base).run();
}

}  // namespace inkflate
