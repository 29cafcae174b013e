// SPDX-License-Identifier: Apache-2.0
#include "mesh/dynamic_triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"
#include "geometry/polyline.h"
#include "geometry/predicates.h"
#include "mesh/hilbert.h"

namespace inkflate {
namespace {

std::vector<int> near_order(std::span<Vec2 const> points, Rect const& box) {
  double const scale = kLatticeSize / std::max(box.longer_side(), 1e-300);
  std::vector<LatticePoint> lattice;
  lattice.reserve(points.size());
  for (auto const p : points) {
    auto const place = (p - box.min) * scale;
    lattice.push_back({static_cast<std::int32_t>(std::min<double>(place.x, kLatticeSize)),
                       static_cast<std::int32_t>(std::min<double>(place.y, kLatticeSize))});
  }
  return hilbert_order(lattice);
}

}  // namespace

DynamicTriangulation::DynamicTriangulation(std::span<Vec2 const> points)
    : points_(points.begin(), points.end()), given_count_(static_cast<int>(points.size())) {
  auto const box = bounds(points);
  // Far enough away that the given points' hull is seen almost as a whole from each corner.
  double const margin = std::max(1.0, 2 * box.longer_side());
  Vec2 const low = box.min - Vec2{margin, margin};
  Vec2 const high = box.max + Vec2{margin, margin};
  for (auto const corner : {low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}})
    points_.push_back(corner);
  leaving_.assign(points_.size(), -1);
  is_rim_.assign(points_.size(), 0);
  is_fixed_.assign(points_.size(), 0);
  corners_.reserve(6 * points_.size());
  twins_.reserve(6 * points_.size());
  kinds_.reserve(6 * points_.size());
  int const n = given_count_;
  new_triangles(2);
  set_triangle(0, n, n + 1, n + 2);
  set_triangle(1, n, n + 2, n + 3);
  join(2, 3, EdgeKind::Free);
}

int DynamicTriangulation::new_triangles(int count) {
  int const first = triangle_count();
  auto const size = corners_.size() + 3 * static_cast<std::size_t>(count);
  corners_.resize(size, -1);
  twins_.resize(size, -1);
  kinds_.resize(size, EdgeKind::Free);
  return first;
}

void DynamicTriangulation::set_triangle(int t, int a, int b, int c) {
  std::array<int, 3> const corners = {a, b, c};
  for (int i = 0; i < 3; ++i) {
    corners_[3 * t + i] = corners[i];
    leaving_[corners[i]] = 3 * t + i;
  }
}

void DynamicTriangulation::join(int e, int f, EdgeKind kind) {
  twins_[e] = f;
  kinds_[e] = kind;
  if (f < 0) return;
  twins_[f] = e;
  kinds_[f] = kind;
}

bool DynamicTriangulation::is_in_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  auto const p = a - d;
  auto const q = b - d;
  auto const r = c - d;
  double const pp = squared_norm(p);
  double const qq = squared_norm(q);
  double const rr = squared_norm(r);
  double const determinant = pp * cross(q, r) + qq * cross(r, p) + rr * cross(p, q);
  double const permanent = pp * (std::abs(q.x * r.y) + std::abs(q.y * r.x)) +
                           qq * (std::abs(r.x * p.y) + std::abs(r.y * p.x)) +
                           rr * (std::abs(p.x * q.y) + std::abs(p.y * q.x));
  // (10 + 96 u) u with u = 2^-53, rounded up: the error bound of Shewchuk 1997.
  return determinant > 1.2e-15 * permanent;
}

std::optional<int> DynamicTriangulation::insert_all() {
  auto const given = std::span(points_).first(static_cast<std::size_t>(given_count_));
  for (int const v : near_order(given, bounds(given))) {
    if (auto const twice = insert_given(v)) return twice;
  }
  return std::nullopt;
}

std::optional<int> DynamicTriangulation::insert_given(int v) {
  auto place = locate(points_[v], last_);
  if (place.triangle < 0) place = search(points_[v]);
  if (place.vertex >= 0) return v;
  last_ = place.triangle;
  if (place.edge >= 0) {
    split_edge(place.edge, v);
  } else {
    split_triangle(place.triangle, v);
  }
  legalise();
  return std::nullopt;
}

DynamicTriangulation::Place DynamicTriangulation::place_in(int t, Vec2 p) const {
  Place place = {t, -1, -1};
  for (int e = 3 * t; e < 3 * t + 3; ++e) {
    if (start(e) == p) place.vertex = corners_[e];
    if (orientation_sign(start(e), points_[end_corner(e)], p) == 0) place.edge = e;
  }
  return place;
}

DynamicTriangulation::Place DynamicTriangulation::locate(Vec2 p, int from_triangle) const {
  // Walks are short; but where the triangles are not quite Delaunay one may go in circles.
  int const most_steps = 50 + triangle_count();
  int t = from_triangle;
  for (int step = 0; step < most_steps; ++step) {
    int crossing = -1;
    for (int i = 0; i < 3 && crossing < 0; ++i) {
      int const e = 3 * t + (i + step) % 3;
      if (orientation_sign(start(e), points_[end_corner(e)], p) < 0) crossing = e;
    }
    if (crossing < 0) return place_in(t, p);
    if (!is_free(crossing) || twins_[crossing] < 0) return {};
    t = twins_[crossing] / 3;
  }
  return {};
}

DynamicTriangulation::Place DynamicTriangulation::search(Vec2 p) const {
  for (int t = 0; t < triangle_count(); ++t) {
    bool holds = true;
    for (int e = 3 * t; e < 3 * t + 3; ++e)
      holds = holds && orientation_sign(start(e), points_[end_corner(e)], p) >= 0;
    if (holds) return place_in(t, p);
  }
  CHECK(false, "the box holds every point");
  return {};
}

int DynamicTriangulation::insert(Vec2 p, Place const& place) {
  int const v = vertex_count();
  points_.push_back(p);
  leaving_.push_back(-1);
  is_rim_.push_back(0);
  is_fixed_.push_back(0);
  if (place.edge >= 0) {
    split_edge(place.edge, v);
  } else {
    split_triangle(place.triangle, v);
  }
  legalise();
  return v;
}

void DynamicTriangulation::split_triangle(int t, int v) {
  int const e = 3 * t;
  std::array<int, 3> const corner = {corners_[e], corners_[e + 1], corners_[e + 2]};
  std::array<int, 3> const outer = {twins_[e], twins_[e + 1], twins_[e + 2]};
  std::array<EdgeKind, 3> const kind = {kinds_[e], kinds_[e + 1], kinds_[e + 2]};
  int const first = new_triangles(2);
  std::array<int, 3> const parts = {t, first, first + 1};
  for (int i = 0; i < 3; ++i) {
    set_triangle(parts[i], corner[i], corner[(i + 1) % 3], v);
    join(3 * parts[i], outer[i], kind[i]);
    pending_.push_back(3 * parts[i]);
  }
  for (int i = 0; i < 3; ++i) join(3 * parts[i] + 1, 3 * parts[(i + 1) % 3] + 2, EdgeKind::Free);
}

void DynamicTriangulation::split_edge(int e, int v) {
  int const f = twins_[e];
  CHECK(f >= 0 && is_free(e), "only free edges are split");
  // a, d, b, c around the quadrilateral; its sides in that order.
  std::array<int, 4> const corner = {corners_[e], apex(f), corners_[f], apex(e)};
  std::array<int, 4> const side = {next_half_edge(f), previous_half_edge(f), next_half_edge(e),
                                   previous_half_edge(e)};
  std::array<int, 4> outer = {};
  std::array<EdgeKind, 4> kind = {};
  for (int i = 0; i < 4; ++i) {
    outer[i] = twins_[side[i]];
    kind[i] = kinds_[side[i]];
  }
  int const first = new_triangles(2);
  std::array<int, 4> const parts = {f / 3, first, e / 3, first + 1};
  for (int i = 0; i < 4; ++i) {
    set_triangle(parts[i], corner[i], corner[(i + 1) % 4], v);
    join(3 * parts[i], outer[i], kind[i]);
    pending_.push_back(3 * parts[i]);
  }
  for (int i = 0; i < 4; ++i) join(3 * parts[i] + 1, 3 * parts[(i + 1) % 4] + 2, EdgeKind::Free);
}

// With e from a to b, c beside it and d beyond: a b c and b a d become a d c and b c d.
void DynamicTriangulation::flip(int e) {
  int const f = twins_[e];
  int const e1 = next_half_edge(e);
  int const e2 = previous_half_edge(e);
  int const f1 = next_half_edge(f);
  int const f2 = previous_half_edge(f);
  int const beyond_bc = twins_[e1];
  auto const kind_bc = kinds_[e1];
  corners_[e1] = corners_[f2];
  corners_[f1] = corners_[e2];
  join(e, twins_[f1], kinds_[f1]);
  join(f, beyond_bc, kind_bc);
  join(e1, f1, EdgeKind::Free);
  for (int const half : {e, e2, f, f2}) leaving_[corners_[half]] = half;
}

bool DynamicTriangulation::should_flip(int e) const {
  int const f = twins_[e];
  if (f < 0 || !is_free(e)) return false;
  int const c = apex(e);
  int const d = apex(f);
  if (keeps_rim_apart_ && is_rim(c) && is_rim(d)) return false;
  return is_in_circle(start(e), start(f), points_[c], points_[d]);
}

void DynamicTriangulation::legalise() {
  while (!pending_.empty()) {
    int const e = pending_.back();
    pending_.pop_back();
    if (!should_flip(e)) continue;
    int const f = twins_[e];
    flip(e);
    for (int const half : {e, previous_half_edge(e), f, previous_half_edge(f)})
      pending_.push_back(half);
  }
}

void DynamicTriangulation::make_delaunay() {
  for (int e = 0; e < std::ssize(corners_); ++e) {
    if (e < twins_[e]) pending_.push_back(e);
  }
  legalise();
}

bool DynamicTriangulation::is_convex_around(int e) const {
  int const f = twins_[e];
  auto const c = points_[apex(e)];
  auto const d = points_[apex(f)];
  return orientation_sign(start(e), d, c) > 0 && orientation_sign(start(f), c, d) > 0;
}

void DynamicTriangulation::mark_fixed(int e, EdgeKind kind) {
  kinds_[e] = kind;
  kinds_[twins_[e]] = kind;
  for (int const v : {corners_[e], end_corner(e)}) {
    is_fixed_[v] = 1;
    if (kind == EdgeKind::Rim) is_rim_[v] = 1;
  }
}

int DynamicTriangulation::find_edge(int a, int b) const {
  // No fan around a corner of the box is whole; and no free edge joins two of them, as all points lie in its middle.
  bool const is_given = a < given_count_ || a >= given_count_ + 4;
  int found = -1;
  around(is_given ? a : b, [&](int e) {
    if (end_corner(e) == (is_given ? b : a)) found = e;
  });
  return is_given || found < 0 ? found : twins_[found];
}

/// The edges between a and b, which are not joined, in order.
DynamicTriangulation::Fix DynamicTriangulation::find_crossed(int a, int b,
                                                             std::vector<Ends>& crossed) const {
  auto const from = points_[a];
  auto const to = points_[b];
  int e = -1;  // the edge opposite of a through which the way leaves
  bool touches = false;
  around(a, [&](int spoke) {
    auto const x = points_[end_corner(spoke)];
    int const side = orientation_sign(from, to, x);
    if (side == 0 && dot(x - from, to - from) > 0) touches = true;
    if (side < 0 && orientation_sign(from, to, points_[apex(spoke)]) > 0) e = next_half_edge(spoke);
  });
  if (touches || e < 0) return Fix::Touches;
  while (true) {
    if (!is_free(e)) return Fix::Crosses;
    crossed.push_back({corners_[e], end_corner(e)});
    int const f = twins_[e];
    if (apex(f) == b) return Fix::Done;
    int const side = orientation_sign(from, to, points_[apex(f)]);
    if (side == 0) return Fix::Touches;
    // The way on is through the side whose ends lie on both sides of it.
    e = side > 0 ? next_half_edge(f) : previous_half_edge(f);
  }
}

DynamicTriangulation::Fix DynamicTriangulation::fix_edge(int a, int b, EdgeKind kind) {
  int e = find_edge(a, b);
  if (e >= 0 && !is_free(e)) return Fix::Crosses;
  if (e < 0) {
    std::vector<Ends> crossed;
    auto const outcome = find_crossed(a, b, crossed);
    if (outcome != Fix::Done) return outcome;
    if (!turn_away(a, b, std::move(crossed))) return Fix::Touches;
    e = find_edge(a, b);
  }
  mark_fixed(e, kind);
  return Fix::Done;
}

/// Turns the crossed edges until none crosses the line from a to b. Each is turned when the quadrilateral around it is convex; else it
/// waits until others are turned.
bool DynamicTriangulation::turn_away(int a, int b, std::vector<Ends> crossed) {
  auto const most_turns = 64 + 8 * crossed.size() * crossed.size();
  for (std::size_t next = 0; next < crossed.size(); ++next) {
    if (next > most_turns) return false;
    auto const ends = crossed[next];
    int const e = find_edge(ends.from, ends.to);
    if (!is_convex_around(e)) {
      crossed.push_back(ends);
      continue;
    }
    Ends const turned = {apex(e), apex(twins_[e])};
    flip(e);
    if (separates(a, b, turned)) crossed.push_back(turned);
  }
  return true;
}

/// Whether the ends of an edge lie on different sides of the line from a to b, none of them on it.
bool DynamicTriangulation::separates(int a, int b, Ends ends) const {
  return orientation_sign(points_[a], points_[b], points_[ends.from]) *
             orientation_sign(points_[a], points_[b], points_[ends.to]) <
         0;
}

bool DynamicTriangulation::can_move(int v, Vec2 p) const {
  bool can = true;
  around(v, [&](int e) {
    can = can && orientation_sign(p, points_[end_corner(e)], points_[apex(e)]) > 0;
  });
  return can;
}

bool DynamicTriangulation::can_split(int e, Vec2 p) const {
  int const f = twins_[e];
  for (int const side :
       {next_half_edge(e), previous_half_edge(e), next_half_edge(f), previous_half_edge(f)}) {
    if (orientation_sign(start(side), points_[end_corner(side)], p) <= 0) return false;
  }
  return true;
}

}  // namespace inkflate
