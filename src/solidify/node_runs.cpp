// SPDX-License-Identifier: Apache-2.0
#include "solidify/node_runs.h"

#include <cstddef>
#include <numeric>

namespace inkflate {

NodeRuns::NodeRuns(Lattice const& lattice, std::vector<Side> const& sides, Side side)
    : lattice_(lattice) {
  int const row_count = lattice.rows * lattice.planes;
  for (int row = 0; row < row_count; ++row) {
    begin_.push_back(static_cast<int>(runs_.size()));
    add_row(sides, side, row);
  }
  begin_.push_back(static_cast<int>(runs_.size()));
  parents_.resize(runs_.size());
  std::iota(parents_.begin(), parents_.end(), 0);
  join_neighbours();
  number_pieces();
}

void NodeRuns::add_row(std::vector<Side> const& sides, Side side, int row) {
  auto const* const nodes = sides.data() + std::ptrdiff_t{row} * lattice_.columns;
  for (int c = 0; c < lattice_.columns; ++c) {
    if (nodes[c] != side) continue;
    int const first = c;
    while (c + 1 < lattice_.columns && nodes[c + 1] == side) ++c;
    runs_.push_back({row, first, c});
  }
}

void NodeRuns::join_neighbours() {
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

void NodeRuns::join_rows(int row, int other_row, int least_shift, int most_shift) {
  int b = begin_[other_row];
  for (int a = begin_[row]; a < begin_[row + 1]; ++a) {
    int const first = runs_[a].first + least_shift;
    int const last = runs_[a].last + most_shift;
    while (b < begin_[other_row + 1] && runs_[b].last < first) ++b;
    for (int c = b; c < begin_[other_row + 1] && runs_[c].first <= last; ++c)
      parents_[root(c)] = root(a);
  }
}

void NodeRuns::number_pieces() {
  std::vector<int> number_of_root(runs_.size(), -1);
  for (int r = 0; r < std::ssize(runs_); ++r) {
    int& number = number_of_root[root(r)];
    if (number < 0) number = piece_count_++;
    pieces_.push_back(number);
  }
}

int NodeRuns::root(int run) {
  while (parents_[run] != run) run = parents_[run] = parents_[parents_[run]];
  return run;
}

}  // namespace inkflate
