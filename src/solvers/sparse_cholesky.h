// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/result.h"

namespace inkflate {

/// A number in a symmetric matrix. Only row >= column is given; what is given twice is added.
struct MatrixEntry {
  int row = 0;
  int column = 0;
  double value = 0;
};

/// A symmetric positive definite sparse matrix, factored once to be solved many times: P A P^T = L D L^T.
///
/// The same bits on every machine: all sums are made one after the other.
class SparseCholesky {
 public:
  /// in      entries: 0 <= column <= row < size, finite
  /// errors  BadInput (not positive definite)
  /// cost    about 1 us per number in L: 3 ms for a mesh of 3000 vertices
  /// source  Davis, "Direct Methods for Sparse Linear Systems", 2006; ordering: Amestoy, Davis, Duff 1996 (by Eigen)
  static Result<SparseCholesky> factor(int size, std::span<MatrixEntry const> entries);

  int size() const { return static_cast<int>(diagonal_.size()); }

  /// Replaces the right-hand sides by the solutions. Several are given side by side: all numbers of row 0, then of row 1.
  /// values: size() * columns; columns >= 1
  void solve(std::span<double> values, int columns = 1) const;

 private:
  SparseCholesky() = default;

  std::vector<int> order_;   // the row of A that became row i of L
  std::vector<int> starts_;  // per column of L where its numbers below the diagonal start
  std::vector<int> rows_;
  std::vector<double> numbers_;
  std::vector<double> diagonal_;  // of D
};

}  // namespace inkflate
