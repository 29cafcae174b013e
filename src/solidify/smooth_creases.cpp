// SPDX-License-Identifier: Apache-2.0
#include "solidify/smooth_creases.h"

#include <cstdint>

namespace inkflate {
namespace {

// Facets of the model's own mesh turn by less than the angle with this cosine, 25 degrees.
constexpr double kCreaseCosine = 0.9;
constexpr int kRings = 2;
constexpr int kRounds = 10;
constexpr double kPull = 0.5;

class CreaseSmoother {
 public:
  CreaseSmoother(MarchedMesh& marched, double base)
      : marched_(marched), mesh_(marched.mesh), base_(base), marks_(mesh_.points.size(), 0) {
    collect_triangles();
  }

  void run() {
    for (int p = 0; p < std::ssize(mesh_.points); ++p) {
      if (is_crease(p)) marked_.push_back(p);
    }
    for (int const p : marked_) marks_[p] = 1;
    for (int ring = 0; ring < kRings; ++ring) add_ring();
    for (int round = 0; round < kRounds; ++round) move_all();
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
          marks_[q] = 1;
          marked_.push_back(q);
        }
      }
    }
  }

  void move_all() {
    std::vector<Vec3> places;
    places.reserve(marked_.size());
    for (int const p : marked_) {
      Vec3 const now = mesh_.points[p];
      Vec3 const wanted = now + (middle_around(p) - now) * kPull;
      places.push_back(now.z <= base_ ? now : nearest_allowed(marched_.anchors[p], wanted));
    }
    for (std::size_t m = 0; m < marked_.size(); ++m) mesh_.points[marked_[m]] = places[m];
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

void smooth_creases(MarchedMesh& marched, double base) { CreaseSmoother(marched, base).run(); }

}  // namespace inkflate
