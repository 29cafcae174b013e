// SPDX-License-Identifier: Apache-2.0
#include "solvers/sparse_cholesky.h"

#include <cmath>

#include "solvers/eigen.h"

namespace inkflate {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

Matrix lower_part(int size, std::span<MatrixEntry const> entries) {
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(entries.size());
  for (auto const& e : entries) {
    CHECK(e.column >= 0 && e.column <= e.row && e.row < size, "an entry in the lower part");
    triplets.push_back({e.row, e.column, e.value});
  }
  Matrix matrix(size, size);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

Error not_positive_definite(int row) {
  return {ErrorCode::BadInput, "A system of equations has no single solution.", row};
}

}  // namespace

Result<SparseCholesky> SparseCholesky::factor(int size, std::span<MatrixEntry const> entries) {
  SparseCholesky result;
  if (size == 0) return result;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> const ldlt(lower_part(size, entries));
  if (ldlt.info() != Eigen::Success) return not_positive_definite(-1);
  auto const& factor = ldlt.matrixL().nestedExpression();
  auto const diagonal = ldlt.vectorD();
  auto const& order = ldlt.permutationPinv().indices();
  result.order_.assign(order.data(), order.data() + size);
  result.diagonal_.assign(diagonal.data(), diagonal.data() + size);
  for (int i = 0; i < size; ++i) {
    bool const is_positive = diagonal[i] > 0 && std::isfinite(diagonal[i]);
    if (!is_positive) return not_positive_definite(result.order_[i]);
  }
  result.starts_.reserve(size + 1);
  result.rows_.reserve(factor.nonZeros());
  result.numbers_.reserve(factor.nonZeros());
  for (int column = 0; column < size; ++column) {
    result.starts_.push_back(static_cast<int>(result.rows_.size()));
    for (int k = factor.outerIndexPtr()[column]; k < factor.outerIndexPtr()[column + 1]; ++k) {
      if (factor.innerIndexPtr()[k] == column) continue;  // the diagonal of L is 1
      result.rows_.push_back(factor.innerIndexPtr()[k]);
      result.numbers_.push_back(factor.valuePtr()[k]);
    }
  }
  result.starts_.push_back(static_cast<int>(result.rows_.size()));
  return result;
}

void SparseCholesky::solve(std::span<double> values, int columns) const {
  CHECK(columns >= 1 && std::ssize(values) == std::ptrdiff_t{size()} * columns,
        "one number per row and column");
  std::vector<double> x(values.size());
  for (int i = 0; i < size(); ++i) {
    for (int c = 0; c < columns; ++c) x[i * columns + c] = values[order_[i] * columns + c];
  }
  for (int j = 0; j < size(); ++j) {
    for (int k = starts_[j]; k < starts_[j + 1]; ++k) {
      for (int c = 0; c < columns; ++c) {
        x[rows_[k] * columns + c] -= numbers_[k] * x[j * columns + c];
      }
    }
  }
  for (int j = size() - 1; j >= 0; --j) {
    for (int c = 0; c < columns; ++c) x[j * columns + c] /= diagonal_[j];
    for (int k = starts_[j]; k < starts_[j + 1]; ++k) {
      for (int c = 0; c < columns; ++c) {
        x[j * columns + c] -= numbers_[k] * x[rows_[k] * columns + c];
      }
    }
  }
  for (int i = 0; i < size(); ++i) {
    for (int c = 0; c < columns; ++c) values[order_[i] * columns + c] = x[i * columns + c];
  }
}

}  // namespace inkflate
