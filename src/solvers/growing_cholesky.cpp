// SPDX-License-Identifier: Apache-2.0
#include "solvers/growing_cholesky.h"

#include <cmath>

#include "base/check.h"

namespace inkflate {

/// The row of L for the matrix's row after those that are factored; its last number is 0 if there is none.
std::vector<double> GrowingCholesky::factor_row(std::vector<double> const& row) const {
  auto result = row;
  auto const last = row.size() - 1;
  for (std::size_t j = 0; j <= last; ++j) {
    auto const& other = j < last ? factors_[j] : result;
    double sum = row[j];
    for (std::size_t k = 0; k < j; ++k) sum -= result[k] * other[k];
    if (j < last) {
      result[j] = sum / other[j];
    } else {
      result[j] = sum > 0 ? std::sqrt(sum) : 0;
    }
  }
  return result;
}

bool GrowingCholesky::append(std::vector<double> row) {
  CHECK(row.size() == rows_.size() + 1, "a row up to its diagonal");
  auto factor = factor_row(row);
  if (!(factor.back() > 0) || !std::isfinite(factor.back())) return false;
  rows_.push_back(std::move(row));
  factors_.push_back(std::move(factor));
  return true;
}

void GrowingCholesky::remove(int row) {
  CHECK(row >= 0 && row < size(), "a row that there is");
  rows_.erase(rows_.begin() + row);
  factors_.resize(row);
  for (int i = row; i < size(); ++i) {
    rows_[i].erase(rows_[i].begin() + row);
    factors_.push_back(factor_row(rows_[i]));
    // A part of a positive definite matrix is positive definite; only rounding could say otherwise.
    if (!(factors_.back().back() > 0)) factors_.back().back() = std::sqrt(rows_[i].back());
  }
}

void GrowingCholesky::solve(std::span<double> values) const {
  CHECK(std::ssize(values) == size(), "a number for each row");
  for (int i = 0; i < size(); ++i) {
    for (int k = 0; k < i; ++k) values[i] -= factors_[i][k] * values[k];
    values[i] /= factors_[i][i];
  }
  for (int i = size() - 1; i >= 0; --i) {
    values[i] /= factors_[i][i];
    for (int k = 0; k < i; ++k) values[k] -= factors_[i][k] * values[i];
  }
}

}  // namespace inkflate
