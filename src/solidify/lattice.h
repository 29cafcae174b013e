// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vec3.h"

namespace inkflate {

/// A node of the body-centred lattice: all three coordinates even, or all three odd.
struct LatticeNode {
  int i = 0;
  int j = 0;
  int k = 0;

  friend bool operator==(LatticeNode const&, LatticeNode const&) = default;
};

constexpr LatticeNode operator+(LatticeNode a, LatticeNode b) {
  return {a.i + b.i, a.j + b.j, a.k + b.k};
}
constexpr LatticeNode operator-(LatticeNode a, LatticeNode b) {
  return {a.i - b.i, a.j - b.j, a.k - b.k};
}
inline Vec3 place_of(LatticeNode a) {
  return {static_cast<double>(a.i), static_cast<double>(a.j), static_cast<double>(a.k)};
}

/// A node's neighbours: six at distance 2 along the axes, then eight at distance sqrt 3 along the diagonals.
constexpr int kDirections = 14;
constexpr int kLongDirections = 6;
constexpr std::array<LatticeNode, kDirections> kSteps = {{{2, 0, 0},
                                                          {-2, 0, 0},
                                                          {0, 2, 0},
                                                          {0, -2, 0},
                                                          {0, 0, 2},
                                                          {0, 0, -2},
                                                          {-1, -1, -1},
                                                          {1, -1, -1},
                                                          {-1, 1, -1},
                                                          {1, 1, -1},
                                                          {-1, -1, 1},
                                                          {1, -1, 1},
                                                          {-1, 1, 1},
                                                          {1, 1, 1}}};
constexpr int opposite_direction(int d) { return d < kLongDirections ? d ^ 1 : 19 - d; }

/// The lines through nodes run in seven directions: the axes, then the diagonals that rise in k.
constexpr int kFamilies = 7;
constexpr std::array<int, kFamilies> kFamilyDirections = {0, 2, 4, 10, 11, 12, 13};
/// The family of lines that a step runs along.
constexpr int family_of(int d) {
  if (d < kLongDirections) return d / 2;
  return (d >= 10 ? d : opposite_direction(d)) - 7;
}
/// Whether the step runs the way its family's lines do.
constexpr bool is_forward(int d) { return d < kLongDirections ? d % 2 == 0 : d >= 10; }
constexpr double kLongStep = 2;
constexpr double kShortStep = 1.7320508075688772;
constexpr double step_length(int d) { return d < kLongDirections ? kLongStep : kShortStep; }

/// The nodes of a box of the lattice, numbered in rows along i.
struct Lattice {
  int columns = 0;  // nodes in a row
  int rows = 0;     // rows in a plane
  int planes = 0;

  int node_count() const { return columns * rows * planes; }
  int size_i() const { return 2 * columns; }
  int size_j() const { return 2 * rows; }
  int size_k() const { return planes; }
  int index(LatticeNode a) const { return (a.k * rows + (a.j >> 1)) * columns + (a.i >> 1); }
  LatticeNode node(int index) const {
    int const row = index / columns;
    int const k = row / rows;
    return {2 * (index % columns) + (k & 1), 2 * (row % rows) + (k & 1), k};
  }
  /// What to add to an index to go one step; it depends on the parity of the node's plane.
  std::array<std::array<int, kDirections>, 2> offsets() const {
    std::array<std::array<int, kDirections>, 2> result{};
    for (int parity = 0; parity < 2; ++parity) {
      LatticeNode const from{2 + parity, 2 + parity, 2 + parity};
      for (int d = 0; d < kDirections; ++d)
        result[parity][d] = index(from + kSteps[d]) - index(from);
    }
    return result;
  }
};

}  // namespace inkflate
