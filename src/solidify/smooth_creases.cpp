// SPDX-License-Identifier: Apache-2.0
#include "solidify/smooth_creases.h"

#include "mesh/check_mesh.h"
#include "solidify/cell_marks.h"
#include "solidify/point_fans.h"

namespace inkflate {
namespace {

// Facets of the model's own mesh turn by less than the angle with this cosine, 25 degrees.
constexpr double kCreaseCosine = 0.9;
constexpr int kRings = 3;
constexpr int kRounds = 12;
constexpr double kPull = 0.5;
constexpr double kPush = -0.53;  // every other round, for balls
// Twice the area of a triangle; one between the middles of steps has 0.5 or more.
constexpr double kLeastArea = 1e-3;
// As check_mesh has it: 120 degrees.
constexpr double kFoldedCosine = -0.5;
// After so many attempts no point is left free.
constexpr int kFreeAttempts = 4;
// Of the cells in which triangles that may meet are looked for: larger than a triangle.
constexpr double kCellUnits = 4;

class CreaseSmoother {
 public:
  CreaseSmoother(MarchedMesh& marched, double base)
      : marched_(marched),
        mesh_(marched.mesh),
        fans_(mesh_),
        base_(base),
        is_moved_(mesh_.points.size(), false),
        is_ball_(mesh_.points.size(), false),
        is_bound_(mesh_.points.size(), false) {}

  /// Tries to move all points freely. Where that does harm they are bound to places that cannot do any.
  void run() {
    choose_points();
    if (moved_.empty()) return;
    auto const before = mesh_.points;
    for (int attempt = 0; attempt < kFreeAttempts; ++attempt) {
      move_all();
      auto const bad = bad_triangles();
      if (bad.empty() && count_self_crossings(near_moved(), 1) == 0) return;
      mesh_.points = before;
      if (bad.empty()) break;
      bind_around(bad);
    }
    is_bound_.assign(is_bound_.size(), true);
    move_all();
  }

 private:
  void choose_points() {
    for (int p = 0; p < std::ssize(mesh_.points); ++p) {
      if (!is_crease(p)) continue;
      moved_.push_back(p);
      is_moved_[p] = true;
    }
    for (int ring = 0; ring < kRings; ++ring) fans_.add_ring(moved_, is_moved_);
    for (int p = 0; p < std::ssize(mesh_.points); ++p) {
      if (!marched_.anchors[p].is_of_ball || is_moved_[p]) continue;
      moved_.push_back(p);
      is_moved_[p] = true;
      is_ball_[p] = true;
    }
  }

  /// Whether the surface bends inwards here, and sharply.
  bool is_crease(int p) const {
    Vec3 const normal = fans_.normal_at(p);
    if (dot(fans_.middle_around(p) - mesh_.points[p], normal) <= 0) return false;
    for (int const t : fans_.around(p)) {
      if (dot(normalized(fans_.area_vector(t)), normal) < kCreaseCosine) return true;
    }
    return false;
  }

  void move_all() {
    std::vector<Vec3> places(moved_.size());
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t m = 0; m < moved_.size(); ++m) places[m] = next_place(moved_[m], round);
      for (std::size_t m = 0; m < moved_.size(); ++m) mesh_.points[moved_[m]] = places[m];
    }
  }

  Vec3 next_place(int p, int round) const {
    Vec3 const now = mesh_.points[p];
    double const share = is_ball_[p] && round % 2 != 0 ? kPush : kPull;
    Vec3 const wanted = now + (fans_.middle_around(p) - now) * share;
    if (now.z <= base_ || wanted.z <= base_) return now;
    return is_bound_[p] ? nearest_allowed(marched_.anchors[p], wanted) : wanted;
  }

  bool has_moved(int t) const {
    auto const& [a, b, c] = mesh_.triangles[t];
    return is_moved_[a] || is_moved_[b] || is_moved_[c];
  }

  std::vector<int> bad_triangles() const {
    std::vector<int> bad;
    for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
      if (!has_moved(t)) continue;
      bool const has_area = norm(fans_.area_vector(t)) > kLeastArea;
      if (!has_area || fans_.is_folded(t, kFoldedCosine)) bad.push_back(t);
    }
    return bad;
  }

  void bind_around(std::vector<int> const& triangles) {
    std::vector<int> points;
    for (int const t : triangles) {
      for (int const p : mesh_.triangles[t]) points.push_back(p);
    }
    std::vector<bool> is_known(mesh_.points.size(), false);
    for (int ring = 0; ring < kRings; ++ring) fans_.add_ring(points, is_known);
    for (int const p : points) is_bound_[p] = true;
  }

  /// The triangles that lie in a cell with one that moved.
  TriMesh near_moved() const {
    CellMarks cells(mesh_, kCellUnits);
    for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
      if (has_moved(t)) cells.mark(t);
    }
    TriMesh result;
    result.points = mesh_.points;
    for (int t = 0; t < std::ssize(mesh_.triangles); ++t) {
      if (cells.is_marked(t)) result.triangles.push_back(mesh_.triangles[t]);
    }
    return result;
  }

  MarchedMesh& marched_;
  TriMesh& mesh_;
  PointFans fans_;
  double base_;
  std::vector<int> moved_;
  std::vector<bool> is_moved_;
  std::vector<bool> is_ball_;   // made of balls, not at a crease
  std::vector<bool> is_bound_;  // only moves to where it can do no harm
};

}  // namespace

void smooth_creases(MarchedMesh& marched, double base) {
  if (!marched.mesh.points.empty()) CreaseSmoother(marched, base).run();
}

}  // namespace inkflate
