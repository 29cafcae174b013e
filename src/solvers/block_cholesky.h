// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

namespace inkflate {

/// A symmetric positive definite sparse matrix of 2 x 2 blocks whose pattern stays while its numbers change: P A P^T = L L^T.
///
/// The pattern is analysed once. Then, as often as wanted: clear, add to the blocks, factor, solve. The numbers of A are put where
/// those of L will be, so factoring neither searches nor allocates.
///
/// The same bits on every machine: all sums are made one after the other.
///
/// source  Davis, "Direct Methods for Sparse Linear Systems", 2006, sections 4.4 (pattern) and 4.10 (left-looking factor);
///         ordering: Amestoy, Davis, Duff 1996 (by Eigen)
class BlockCholesky {
 public:
  /// in      size: number of block rows; pairs: of different rows < size whose block may be other than zero, in any order, repeated at
  ///         will
  /// cost    about 1 ms for a mesh of 1200 vertices
  BlockCholesky(int size, std::span<std::array<int, 2> const> pairs);

  int size() const { return static_cast<int>(order_.size()); }

  /// Whether the matrix keeps block (row, column) rather than (column, row); row != column.
  bool is_kept(int row, int column) const { return place_[row] > place_[column]; }

  /// Where the numbers of a kept block or of one on the diagonal start in numbers(): row by row. Of a diagonal block, the second is not
  /// read.
  int start_of(int row, int column) const;

  /// All numbers of the blocks, to be added to between clear() and factor().
  std::span<double> numbers() { return numbers_; }
  void clear();

  /// Replaces the numbers of A by those of L.
  /// out     false: not positive definite, to rounding; clear and add again
  /// cost    about 0.5 ms for a mesh of 1200 vertices
  [[nodiscard]] bool factor();

  /// Replaces the right-hand side by the solution. values: 2 * size(); after factor() has gone well
  void solve(std::span<double> values);

 private:
  /// A block left of the diagonal: where it is in its column.
  struct LeftBlock {
    int position = 0;  // index into rows_
    int end = 0;       // of its column in rows_
    int together = 1;  // 1, 2 or 4: this block and those that follow have the same rows below
  };

  void find_order(std::span<std::array<int, 2> const> pairs);
  void find_pattern(std::span<std::array<int, 2> const> pairs);
  void find_left_blocks();
  void find_left_together();
  void subtract_left_columns(int column);
  template <int kCount>
  void subtract_together(LeftBlock const* left);
  [[nodiscard]] bool divide_by_diagonal(int column);

  std::vector<int> order_;          // the row of A that became row i of L
  std::vector<int> place_;          // the row of L that row i of A became
  std::vector<int> starts_;         // per column of L where its blocks start: the diagonal first
  std::vector<int> rows_;           // of each block
  std::vector<double> numbers_;     // 4 for each block
  std::vector<int> left_starts_;    // per row of L
  std::vector<LeftBlock> left_;     // the blocks of each row left of the diagonal
  std::vector<int> target_;         // while a column is made: where the block of a row is
  std::vector<double> right_side_;  // while solving
};

}  // namespace inkflate
