// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace inkflate {

/// The pixels of a picture, row by row, with their 4 neighbours; nothing is stored per pixel. For MinCut.
///
/// The right end of a row is joined to the left end of the next: asking for the row's end would cost a division
/// per step. The capacities of those arcs, and of the ones that leave the picture, must be 0.
class GridTopology {
 public:
  static constexpr int kDegree = 4;
  enum Direction : int { Right = 0, Down = 1, Left = 2, Up = 3 };

  GridTopology(int width, int height)
      : node_count_(width * height), offsets_{1, width, -1, -width} {}

  int node_count() const { return node_count_; }
  static int arc(int node, Direction direction) { return node * kDegree + direction; }
  int reverse(int arc) const {
    int const direction = arc & 3;
    int const neighbour = arc / kDegree + offsets_[direction];
    // One comparison for both ends.
    if (static_cast<unsigned>(neighbour) >= static_cast<unsigned>(node_count_)) return -1;
    return neighbour * kDegree + (direction ^ 2);
  }

 private:
  int node_count_;
  int offsets_[4];
};

}  // namespace inkflate
