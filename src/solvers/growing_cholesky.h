// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace inkflate {

/// A small dense symmetric positive definite matrix that gains and loses rows, kept factored as L L^T.
class GrowingCholesky {
 public:
  int size() const { return static_cast<int>(rows_.size()); }

  /// Adds a last row. row: its size() + 1 numbers up to the diagonal
  /// out     false: the matrix would not be positive definite any more and stays as it was
  /// cost    O(n^2)
  [[nodiscard]] bool append(std::vector<double> row);

  /// Takes a row and its column away. cost: O((n - row)^2)
  void remove(int row);

  /// Replaces the right-hand side by the solution. O(n^2)
  void solve(std::span<double> values) const;

 private:
  std::vector<std::vector<double>> rows_;  // of L, each up to the diagonal
};

}  // namespace inkflate
