// SPDX-License-Identifier: Apache-2.0
#include "mesh/delaunay.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "mesh/hilbert.h"

namespace inkflate {

std::int64_t in_circle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  std::int64_t const ax = a.x - d.x;
  std::int64_t const ay = a.y - d.y;
  std::int64_t const bx = b.x - d.x;
  std::int64_t const by = b.y - d.y;
  std::int64_t const cx = c.x - d.x;
  std::int64_t const cy = c.y - d.y;
  return (ax * ax + ay * ay) * (bx * cy - by * cx) - (bx * bx + by * by) * (ax * cy - ay * cx) +
         (cx * cx + cy * cy) * (ax * by - ay * bx);
}

namespace {

/// Inserts points one by one. Outside of the hull lie ghost triangles, each with a hull edge and the ghost corner "infinitely
/// far away": so every half-edge has a twin, and a point outside is inserted like one inside.
class Builder {
 public:
  /// points: distinct, so ordered that consecutive ones are close.
  explicit Builder(std::vector<LatticePoint> points)
      : points_(std::move(points)), ghost_(static_cast<int>(points_.size())) {}

  void build() {
    int const third = first_off_line();
    if (third == ghost_) return;
    // By Euler's formula n points and the ghost have 2 n - 2 triangles.
    corners_.resize(6 * points_.size() - 6);
    twins_.resize(6 * points_.size() - 6);
    start_with(third);
    for (int p = 2; p < ghost_; ++p) {
      if (p != third) insert(p);
    }
  }

  /// The triangles without ghosts; names[p] is the caller's number of point p.
  void export_to(std::vector<int> const& names, Triangulation& result) const {
    int const count = used_ / 3;
    std::vector<int> new_index(static_cast<std::size_t>(count), -1);
    int kept = 0;
    for (int t = 0; t < count; ++t) {
      if (!is_ghost(t)) new_index[t] = kept++;
    }
    result.corners.resize(3 * static_cast<std::size_t>(kept));
    result.twins.resize(result.corners.size());
    for (int e = 0; e < 3 * count; ++e) {
      int const t = new_index[e / 3];
      if (t < 0) continue;
      int const twin = twins_[e];
      int const other = new_index[twin / 3];
      result.corners[3 * t + e % 3] = names[corners_[e]];
      result.twins[3 * t + e % 3] = other < 0 ? -1 : 3 * other + twin % 3;
    }
  }

 private:
  /// The first point that is not on the line through points 0 and 1; ghost_ if there is none.
  int first_off_line() const {
    for (int p = 2; p < ghost_; ++p) {
      if (orientation(points_[0], points_[1], points_[p]) != 0) return p;
    }
    return ghost_;
  }

  void start_with(int third) {
    std::array<int, 3> corner = {0, 1, third};
    if (orientation(points_[0], points_[1], points_[third]) < 0) std::swap(corner[1], corner[2]);
    auto const [a, b, c] = corner;
    std::array<int, 12> const first = {a, b, c, b, a, ghost_, c, b, ghost_, a, c, ghost_};
    std::copy(first.begin(), first.end(), corners_.begin());
    used_ = 12;
    for (int i = 0; i < 3; ++i) {
      int const ghost_edge = 3 * (i + 1);
      join(i, ghost_edge);
      // The ghost behind edge i meets the one behind edge i + 1 at the edge's end, which is its own first corner.
      join(ghost_edge + 2, 3 * ((i + 1) % 3 + 1) + 1);
    }
  }

  void join(int e, int f) {
    twins_[e] = f;
    twins_[f] = e;
  }

  void set_corners(int e0, int a, int b, int c) {
    corners_[e0] = a;
    corners_[e0 + 1] = b;
    corners_[e0 + 2] = c;
  }

  bool is_ghost(int t) const {
    int const first = 3 * t;
    return corners_[first] == ghost_ || corners_[first + 1] == ghost_ ||
           corners_[first + 2] == ghost_;
  }

  /// Whether p lies inside the circle of the triangle of e. A ghost's circle is the open half-plane beyond its hull edge
  /// together with the open edge itself.
  bool circle_holds(int e, LatticePoint p) const {
    int const first = e - e % 3;
    int const a = corners_[first];
    int const b = corners_[first + 1];
    int const c = corners_[first + 2];
    if (a == ghost_) return is_beyond(points_[b], points_[c], p);
    if (b == ghost_) return is_beyond(points_[c], points_[a], p);
    if (c == ghost_) return is_beyond(points_[a], points_[b], p);
    return in_circle(points_[a], points_[b], points_[c], p) > 0;
  }

  /// Whether p lies beyond the hull edge of a ghost, given as the ghost runs it, or strictly between its ends.
  static bool is_beyond(LatticePoint a, LatticePoint b, LatticePoint p) {
    auto const side = orientation(a, b, p);
    if (side != 0) return side > 0;
    auto const from_a =
        std::int64_t{p.x - a.x} * (b.x - a.x) + std::int64_t{p.y - a.y} * (b.y - a.y);
    auto const from_b =
        std::int64_t{p.x - b.x} * (a.x - b.x) + std::int64_t{p.y - b.y} * (a.y - b.y);
    return from_a > 0 && from_b > 0;
  }

  /// The triangle that holds p, or a ghost beyond whose edge p lies. A walk across edges that have p on their far side ends
  /// in every Delaunay triangulation.
  int locate(LatticePoint p) const {
    int t = last_;
    while (true) {
      int crossing = -1;
      for (int i = 0; i < 3; ++i) {
        int const e = 3 * t + i;
        int const a = corners_[e];
        int const b = corners_[next_half_edge(e)];
        if (a == ghost_ || b == ghost_) continue;
        if (orientation(points_[a], points_[b], p) < 0) {
          crossing = e;
          break;
        }
      }
      if (crossing >= 0) {
        t = twins_[crossing] / 3;
      } else if (!is_ghost(t) || circle_holds(3 * t, p)) {
        return t;
      } else {
        t = next_ghost_towards(t, p);
      }
    }
  }

  /// p lies on the line of the ghost's hull edge, outside of the edge: the neighbouring ghost on that side.
  int next_ghost_towards(int t, LatticePoint p) const {
    int e = 3 * t;
    while (corners_[e] == ghost_ || corners_[next_half_edge(e)] == ghost_) ++e;
    auto const a = points_[corners_[e]];
    auto const b = points_[corners_[next_half_edge(e)]];
    auto const past_b =
        std::int64_t{p.x - b.x} * (b.x - a.x) + std::int64_t{p.y - b.y} * (b.y - a.y);
    return twins_[past_b >= 0 ? next_half_edge(e) : previous_half_edge(e)] / 3;
  }

  /// Splits the triangle that holds p into three and flips until every circle is empty again.
  void insert(int p) {
    int const t = locate(points_[p]);
    int const e0 = 3 * t;
    int const a = corners_[e0];
    int const b = corners_[e0 + 1];
    int const c = corners_[e0 + 2];
    int const outer_bc = twins_[e0 + 1];
    int const outer_ca = twins_[e0 + 2];
    int const f0 = used_;
    int const g0 = f0 + 3;
    used_ += 6;
    set_corners(e0, a, b, p);
    set_corners(f0, b, c, p);
    set_corners(g0, c, a, p);
    join(f0, outer_bc);
    join(g0, outer_ca);
    join(e0 + 1, f0 + 2);
    join(f0 + 1, g0 + 2);
    join(g0 + 1, e0 + 2);
    // Each pending half-edge lies opposite of p; its triangle's last corner in order is p.
    pending_ = {e0, f0, g0};
    while (!pending_.empty()) {
      int const e = pending_.back();
      pending_.pop_back();
      if (circle_holds(twins_[e], points_[p])) flip(e);
    }
    last_ = corners_[e0 + 1] == ghost_ || corners_[e0] == ghost_ ? last_real_beside(e0) : t;
  }

  int last_real_beside(int e0) const {
    // A ghost may start a walk as well, but a real triangle decides at once which way to go.
    for (int i = 0; i < 3; ++i) {
      int const t = twins_[e0 + i] / 3;
      if (!is_ghost(t)) return t;
    }
    return e0 / 3;
  }

  /// Turns edge e = x y of the triangle x y p, whose other side is y x q, into the edge q p: x q p and q y p remain.
  void flip(int e) {
    int const f = twins_[e];
    int const e1 = next_half_edge(e);
    int const e2 = next_half_edge(e1);
    int const f1 = next_half_edge(f);
    int const f2 = next_half_edge(f1);
    int const outer_yp = twins_[e1];
    int const outer_qy = twins_[f2];
    int const q = corners_[f2];
    // e's triangle becomes x q p: half-edge e runs x q, e1 runs q p.
    int const outer_xq = twins_[f1];
    corners_[e1] = q;
    join(e, outer_xq);
    // f's triangle becomes q y p: f runs q y, f1 runs y p, f2 runs p q.
    int const p = corners_[e2];
    int const y = corners_[f];
    corners_[f] = q;
    corners_[f1] = y;
    corners_[f2] = p;
    join(f, outer_qy);
    join(f1, outer_yp);
    join(f2, e1);
    pending_.push_back(e);
    pending_.push_back(f);
  }

  std::vector<LatticePoint> points_;
  int ghost_;
  std::vector<int> corners_;
  std::vector<int> twins_;
  int used_ = 0;  // half-edges made so far
  std::vector<int> pending_;
  int last_ = 0;
};

}  // namespace

Triangulation delaunay(std::span<LatticePoint const> points) {
  Triangulation result;
  result.same_as.resize(points.size());
  auto const order = hilbert_order(points);
  std::vector<int> names;
  std::vector<LatticePoint> distinct;
  names.reserve(points.size());
  distinct.reserve(points.size());
  for (int const i : order) {
    auto const p = points[i];
    CHECK(p.x >= 0 && p.y >= 0 && p.x <= kLatticeSize && p.y <= kLatticeSize,
          "point off the lattice");
    if (distinct.empty() || !(distinct.back() == p)) {
      names.push_back(i);
      distinct.push_back(p);
    }
    result.same_as[i] = names.back();
  }
  Builder builder(std::move(distinct));
  builder.build();
  builder.export_to(names, result);
  return result;
}

}  // namespace inkflate
