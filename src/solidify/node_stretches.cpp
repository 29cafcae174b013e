// SPDX-License-Identifier: Apache-2.0
#include "solidify/node_stretches.h"

#include <cstddef>
#include <numeric>

namespace inkflate {

NodeStretches::NodeStretches(Lattice const& lattice, std::vector<NodeSide> const& sides,
                             NodeSide side)
    : lattice_(lattice) {
  int const row_count = lattice.rows * lattice.planes;
  for (int row = 0; row < row_count; ++row) {
    begin_.push_back(static_cast<int>(stretches_.size()));
    add_row(sides, side, row);
  }
  begin_.push_back(static_cast<int>(stretches_.size()));
  parents_.resize(stretches_.size());
  std::iota(parents_.begin(), parents_.end(), 0);
  join_neighbours();
  number_pieces();
}

void NodeStretches::add_row(std::vector<NodeSide> const& sides, NodeSide side, int row) {
  auto const* const nodes = sides.data() + std::ptrdiff_t{row} * lattice_.columns;
  for (int c = 0; c < lattice_.columns; ++c) {
    if (nodes[c] != side) continue;
    int const first = c;
    while (c + 1 < lattice_.columns && nodes[c + 1] == side) ++c;
    stretches_.push_back({row, first, c});
  }
}

void NodeStretches::join_neighbours() {
  for (int k = 0; k < lattice_.planes; ++k) {
    int const shift = k & 1;
    for (int r = 0; r < lattice_.rows; ++r) {
      int const row = k * lattice_.rows + r;
      if (r + 1 < lattice_.rows) join_rows(row, row + 1, 0, 0);
      if (k + 2 < lattice_.planes) join_rows(row, row + 2 * lattice_.rows, 0, 0);
      if (k + 1 == lattice_.planes) continue;
      // A diagonal step from an even plane leads to the same column or one less, from an odd one to the same or one more.
      for (int const other : {r + shift - 1, r + shift}) {
        if (other < 0 || other >= lattice_.rows) continue;
        join_rows(row, (k + 1) * lattice_.rows + other, shift - 1, shift);
      }
    }
  }
}

void NodeStretches::join_rows(int row, int other_row, int least_shift, int most_shift) {
  int b = begin_[other_row];
  for (int a = begin_[row]; a < begin_[row + 1]; ++a) {
    int const first = stretches_[a].first + least_shift;
    int const last = stretches_[a].last + most_shift;
    while (b < begin_[other_row + 1] && stretches_[b].last < first) ++b;
    for (int c = b; c < begin_[other_row + 1] && stretches_[c].first <= last; ++c)
      parents_[root(c)] = root(a);
  }
}

void NodeStretches::number_pieces() {
  std::vector<int> number_of_root(stretches_.size(), -1);
  for (int r = 0; r < std::ssize(stretches_); ++r) {
    int& number = number_of_root[root(r)];
    if (number < 0) number = piece_count_++;
    pieces_.push_back(number);
  }
}

int NodeStretches::root(int stretch) {
  while (parents_[stretch] != stretch) stretch = parents_[stretch] = parents_[parents_[stretch]];
  return stretch;
}

}  // namespace inkflate
