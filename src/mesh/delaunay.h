// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace inkflate {

/// A point of the integer lattice on which triangulation is exact.
struct LatticePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(LatticePoint const&, LatticePoint const&) = default;
};

/// Coordinates lie in 0 .. kLatticeSize: then the in-circle determinant, at most 12 * 2^56, fits in 64 bits.
constexpr std::int32_t kLatticeSize = 1 << 14;

/// Triangles as half-edges: triangle t has the half-edges 3t, 3t + 1, 3t + 2, each from its own corner to the next one.
struct Triangulation {
  std::vector<int>
      corners;  // the point from which each half-edge starts; positive shoelace area in every triangle
  std::vector<int> twins;  // the half-edge on the other side; -1 on the hull
  std::vector<int>
      same_as;  // per point: the first point at the same place, itself if there is none earlier

  int triangle_count() const { return static_cast<int>(corners.size() / 3); }
};

inline int next_half_edge(int e) { return e % 3 == 2 ? e - 2 : e + 1; }
inline int previous_half_edge(int e) { return e % 3 == 0 ? e + 2 : e - 1; }

/// Twice the signed area of a b c: positive when c lies to the right of a -> b on the screen (y down). Exact.
inline std::int64_t orientation(LatticePoint a, LatticePoint b, LatticePoint c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

/// Positive when d lies inside the circle through a, b, c (given with positive area), 0 on it. Exact.
std::int64_t in_circle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d);

/// The Delaunay triangulation of a point set: no circle through a triangle's corners holds another point.
///
/// in      points: any number, on the lattice, in any order; equal points are merged
/// out     triangles that cover the convex hull; none when all points lie on one line. Where more than three points share an
///         empty circle, one of the possible triangulations, always the same for the same input
/// cost    O(n log n) expected, about 0.3 us per point for the samples of strokes
/// source  Lawson 1977 (incremental insertion with flips); Devillers, Pion, Teillaud 2002 (walking); ghost triangles as in
///         Shewchuk, "Lecture Notes on Delaunay Mesh Generation", 2012, section 3.4
Triangulation delaunay(std::span<LatticePoint const> points);

}  // namespace inkflate
