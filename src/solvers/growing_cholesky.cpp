// SPDX-License-Identifier: Apache-2.0
#include "solvers/growing_cholesky.h"

#include <cmath>
#include <utility>

#include "base/check.h"

namespace inkflate {

bool GrowingCholesky::append(std::vector<double> row) {
  CHECK(row.size() == rows_.size() + 1, "a row up to its diagonal");
  double rest = row.back();
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    auto const& other = rows_[j];
    double sum = row[j];
    for (std::size_t k = 0; k < j; ++k) sum -= row[k] * other[k];
    row[j] = sum / other[j];
    rest -= row[j] * row[j];
  }
  bool const is_positive = rest > 0 && std::isfinite(rest);
  if (!is_positive) return false;
  row.back() = std::sqrt(rest);
  rows_.push_back(std::move(row));
  return true;
}

void GrowingCholesky::remove(int row) {
  CHECK(row >= 0 && row < size(), "a row that there is");
  rows_.erase(rows_.begin() + row);
  // What the column held is added to the rest of the factor: a rank-one update.
  std::vector<double> column;
  for (int i = row; i < size(); ++i) {
    column.push_back(rows_[i][row]);
    rows_[i].erase(rows_[i].begin() + row);
  }
  for (int k = row; k < size(); ++k) {
    double const before = rows_[k][k];
    double const here = column[k - row];
    double const after = std::sqrt(before * before + here * here);
    double const cosine = before / after;
    double const sine = here / after;
    rows_[k][k] = after;
    for (int i = k + 1; i < size(); ++i) {
      double const old = rows_[i][k];
      rows_[i][k] = cosine * old + sine * column[i - row];
      column[i - row] = cosine * column[i - row] - sine * old;
    }
  }
}

void GrowingCholesky::solve(std::span<double> values) const {
  CHECK(std::ssize(values) == size(), "a number for each row");
  for (int i = 0; i < size(); ++i) {
    for (int k = 0; k < i; ++k) values[i] -= rows_[i][k] * values[k];
    values[i] /= rows_[i][i];
  }
  for (int i = size() - 1; i >= 0; --i) {
    values[i] /= rows_[i][i];
    for (int k = 0; k < i; ++k) values[k] -= rows_[i][k] * values[i];
  }
}

}  // namespace inkflate
