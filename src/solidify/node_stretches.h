// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solidify/lattice.h"

namespace inkflate {

/// What a lattice node is: outside, on the surface (once it was moved there) or inside.
enum class NodeSide : std::int8_t { Outside = -1, On = 0, Inside = 1 };

/// Consecutive nodes of one row that are on the same side.
struct NodeStretch {
  int row = 0;
  int first = 0;  // columns
  int last = 0;
};

/// The nodes on one side as stretches, and which of them hang together by steps of the lattice.
class NodeStretches {
 public:
  /// cost    O(nodes)
  NodeStretches(Lattice const& lattice, std::vector<NodeSide> const& sides, NodeSide side);

  std::vector<NodeStretch> const& stretches() const { return stretches_; }
  /// The number of the piece that a stretch belongs to: 0 is that of the first one.
  int piece(int stretch) const { return pieces_[stretch]; }
  int piece_count() const { return piece_count_; }

 private:
  void add_row(std::vector<NodeSide> const& sides, NodeSide side, int row);
  void join_neighbours();
  void join_rows(int row, int other_row, int least_shift, int most_shift);
  void number_pieces();
  int root(int stretch);

  Lattice lattice_;
  std::vector<NodeStretch> stretches_;
  std::vector<int> begin_;  // per row
  std::vector<int> parents_;
  std::vector<int> pieces_;
  int piece_count_ = 0;
};

}  // namespace inkflate
