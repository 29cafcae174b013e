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
// A triangle folded back onto all of its neighbours turns by more than 120 degrees to each.
constexpr double kFoldedCosine = -0.5;
// After so many attempts without bounds nothing more is left to them.
constexpr int kFreeAttempts = 4;
// Cells in which triangles that may meet are looked for: larger than a triangle.
constexpr double kCell = 4;
// Twice the area of a triangle; one of a lattice with cuts in the middle of the steps has 0.5 or more.
constexpr double kLeastArea = 1e-3;

/// Marks on cells of space, seen from the triangles that touch them.
class CellMarks {
 public:
  explicit CellMarks(TriMesh const& mesh) : mesh_(mesh), low_(mesh.points[0]) {
    Vec3 high = low_;
    for (auto const& p : mesh.points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    size_ = cell_of(high);
    for (int& size : size_) ++size;
    marks_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], false);
  }

  void mark(int t) {
    visit(t, [&](std::size_t cell) { marks_[cell] = true; });
  }
  bool is_marked(int t) const {
    bool result = false;
    visit(t, [&](std::size_t cell) { result = result || marks_[cell]; });
    return result;
  }

 private:
  using Cell = std::array<int, 3>;

  Cell cell_of(Vec3 p) const {
    auto const whole = [](double x) { return static_cast<int>(x / kCell); };
    return {whole(p.x - low_.x), whole(p.y - low_.y), whole(p.z - low_.z)};
  }

  template <typename OnCell>
  void visit(int t, OnCell const& on_cell) const {
    auto const& corners = mesh_.triangles[t];
    Cell first = cell_of(mesh_.points[corners[0]]);
    Cell last = first;
    for (int const p : corners) {
      Cell const cell = cell_of(mesh_.points[p]);
      for (int axis = 0; axis < 3; ++axis) {
        first[axis] = std::min(first[axis], cell[axis]);
        last[axis] = std::max(last[axis], cell[axis]);
      }
    }
    for (int z = first[2]; z <= last[2]; ++z) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int x = first[0]; x <= last[0]; ++x)
          on_cell((static_cast<std::size_t>(z) * size_[1] + y) * size_[0] + x);
      }
    }
  }

  TriMesh const& mesh_;
  Vec3 low_;
  Cell size_{};
  std::vector<bool> marks_;
};

class CreaseSmoother {
  static constexpr std::uint8_t kCrease = 1;
  static constexpr std::uint8_t kBall = 2;

 public:
  CreaseSmoother(MarchedMesh& marched, double base)
      : marched_(marched),
        mesh_(marched.mesh),
        base_(base),
        marks_(mesh_.points.size(), 0),
        is_bound_(mesh_.points.size(), false) {
    collect_triangles();
  }

  void run() {
    mark();
    auto const before = mesh_.points;
    for (int attempt = 0; attempt < kFreeAttempts; ++attempt) {
      for (int round = 0; round < kRounds; ++round) move_all(round);
      auto const bad = bad_triangles();
      if (bad.empty() && count_self_crossings(near_moved(), 1) == 0) return;
      mesh_.points = before;
      if (bad.empty()) break;
      bind_around(bad);
    }
    is_bound_.assign(is_bound_.size(), true);
    for (int round = 0; round < kRounds; ++round) move_all(round);
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

  void move_all(int round) {
    std::vector<Vec3> places;
    places.reserve(marked_.size());
    for (int const p : marked_) {
      Vec3 const now = mesh_.points[p];
      double const share = marks_[p] == kBall && round % 2 != 0 ? kPush : kPull;
      Vec3 const wanted = now + (middle_around(p) - now) * share;
      if (now.z <= base_ || wanted.z <= base_)
        places.push_back(now);
      else
        places.push_back(is_bound_[p] ? nearest_allowed(marched_.anchors[p], wanted) : wanted);
    }
    for (std::size_t m = 0; m < marked_.size(); ++m) mesh_.points[marked_[m]] = places[m];
  }

  bool is_moved(int t) const {
    auto const& [a, b, c] = mesh_.triangles[t];
    return marks_[a] != 0 || marks_[b] != 0 || marks_[c] != 0;
  }

  /// Whether a triangle is folded back onto all of its neighbours.
  bool is_folded(int t) const {
    Vec3 const normal = normalized(area_vector(t));
    auto const& corners = mesh_.triangles[t];
    int folds = 0;
    for (int c = 0; c < 3; ++c) {
      int const a = corners[c];
      int const b = corners[(c + 1) % 3];
      for (int i = begin_[a]; i < begin_[a + 1]; ++i) {
        auto const& other = mesh_.triangles[triangles_[i]];
        if (triangles_[i] == t || std::find(other.begin(), other.end(), b) == other.end()) continue;
        if (dot(normalized(area_vector(triangles_[i])), normal) < kFoldedCosine) ++folds;
      }
    }
    return folds == 3;
  }

  std::vector<int> bad_triangles() const {
    std::vector<int> bad;
    for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
      if (is_moved(t) && (!(norm(area_vector(t)) > kLeastArea) || is_folded(t))) bad.push_back(t);
    }
    return bad;
  }

  /// From now on the points around these triangles only go where they cannot do harm.
  void bind_around(std::vector<int> const& triangles) {
    std::vector<int> points;
    for (int const t : triangles) {
      for (int const p : mesh_.triangles[t]) points.push_back(p);
    }
    for (int ring = 0; ring <= kRings; ++ring) {
      for (std::size_t m = 0, count = points.size(); m < count; ++m) {
        if (ring > 0) {
          for (int i = begin_[points[m]]; i < begin_[points[m] + 1]; ++i) {
            for (int const q : mesh_.triangles[triangles_[i]]) {
              if (!is_bound_[q]) points.push_back(q);
              is_bound_[q] = true;
            }
          }
        }
        is_bound_[points[m]] = true;
      }
    }
  }

  /// The triangles that lie in a cell with one that moved.
  TriMesh near_moved() const {
    CellMarks cells(mesh_);
    TriMesh result;
    result.points = mesh_.points;
    for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
      if (is_moved(t)) cells.mark(t);
    }
    for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
      if (cells.is_marked(t)) result.triangles.push_back(mesh_.triangles[t]);
    }
    return result;
  }

  MarchedMesh& marched_;
  TriMesh& mesh_;
  double base_;
  std::vector<std::uint8_t> marks_;
  std::vector<bool> is_bound_;
  std::vector<int> marked_;
  std::vector<int> begin_;      // per point, into triangles_
  std::vector<int> triangles_;  // around each point
};

}  // namespace

void smooth_creases(MarchedMesh& marched, double base) {
  if (!marched.mesh.points.empty()) CreaseSmoother(marched, base).run();
}

}  // namespace inkflate
