// SPDX-License-Identifier: Apache-2.0
#include "solvers/block_cholesky.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "solvers/eigen.h"

namespace inkflate {
namespace {

/// Two numbers with which processors reckon at once, each as it would be by itself.
using Pair [[gnu::vector_size(16)]] = double;

}  // namespace

BlockCholesky::BlockCholesky(int size, std::span<std::array<int, 2> const> pairs)
    : order_(size), place_(size), target_(size, 0), right_side_(2L * size) {
  for (auto const& [a, b] : pairs) {
    CHECK(a != b && a >= 0 && b >= 0 && a < size && b < size, "a pair of different rows");
  }
  find_order(pairs);
  find_pattern(pairs);
  find_left_blocks();
  find_left_together();
  numbers_.assign(4 * rows_.size(), 0);
}

void BlockCholesky::find_order(std::span<std::array<int, 2> const> pairs) {
  if (size() == 0) return;
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(2 * pairs.size() + order_.size());
  // Eigen orders rows without a diagonal last, as if they were dense.
  for (int i = 0; i < size(); ++i) triplets.push_back({i, i, 1});
  for (auto const& [a, b] : pairs) {
    triplets.push_back({a, b, 1});
    triplets.push_back({b, a, 1});
  }
  Eigen::SparseMatrix<double> matrix(size(), size());
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>{}(matrix, order);
  for (int i = 0; i < size(); ++i) {
    order_[i] = order.indices()[i];
    place_[order_[i]] = i;
  }
}

/// The rows of a column of L are those of A and those of the columns whose first row below the diagonal is this column.
void BlockCholesky::find_pattern(std::span<std::array<int, 2> const> pairs) {
  std::vector<std::vector<int>> below(size());
  for (auto const& [a, b] : pairs) {
    below[std::min(place_[a], place_[b])].push_back(std::max(place_[a], place_[b]));
  }
  for (int column = 0; column < size(); ++column) {
    auto& rows = below[column];
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    starts_.push_back(static_cast<int>(rows_.size()));
    rows_.push_back(column);
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    if (rows.empty()) continue;
    auto& parent = below[rows.front()];
    parent.insert(parent.end(), rows.begin() + 1, rows.end());
  }
  starts_.push_back(static_cast<int>(rows_.size()));
}

void BlockCholesky::find_left_blocks() {
  left_starts_.assign(size() + 1, 0);
  for (int const row : rows_) ++left_starts_[row + 1];
  for (int i = 0; i < size(); ++i) left_starts_[i + 1] += left_starts_[i] - 1;  // diagonals apart
  left_.resize(rows_.size() - size());
  auto next = left_starts_;
  for (int column = 0; column < size(); ++column) {
    for (int k = starts_[column] + 1; k < starts_[column + 1]; ++k) {
      left_[next[rows_[k]]++] = {k, starts_[column + 1]};
    }
  }
}

/// Columns of a dense part of L come in rows one after the other, and have the same rows below.
void BlockCholesky::find_left_together() {
  auto const has_same_rows = [&](LeftBlock const& a, LeftBlock const& b) {
    return std::equal(rows_.begin() + a.position, rows_.begin() + a.end, rows_.begin() + b.position,
                      rows_.begin() + b.end);
  };
  for (int row = 0; row < size(); ++row) {
    int const end = left_starts_[row + 1];
    for (int m = left_starts_[row]; m < end; m += left_[m].together) {
      int same = 1;
      while (same < 4 && m + same < end && has_same_rows(left_[m], left_[m + same])) ++same;
      left_[m].together = same == 3 ? 2 : same;
    }
  }
}

int BlockCholesky::start_of(int row, int column) const {
  int const to = place_[row];
  int const from = place_[column];
  auto const begin = rows_.begin() + starts_[from];
  auto const end = rows_.begin() + starts_[from + 1];
  auto const found = std::lower_bound(begin, end, to);
  CHECK(to >= from && found != end && *found == to, "a block that is kept");
  return 4 * static_cast<int>(found - rows_.begin());
}

void BlockCholesky::clear() { std::fill(numbers_.begin(), numbers_.end(), 0); }

bool BlockCholesky::factor() {
  for (int column = 0; column < size(); ++column) {
    for (int k = starts_[column]; k < starts_[column + 1]; ++k) target_[rows_[k]] = 4 * k;
    subtract_left_columns(column);
    if (!divide_by_diagonal(column)) return false;
  }
  return true;
}

/// Takes L_ik L_jk^T from each block (i, j) of column j, for every column k on the left that has a block in row j.
void BlockCholesky::subtract_left_columns(int column) {
  for (int m = left_starts_[column]; m < left_starts_[column + 1]; m += left_[m].together) {
    auto const* const left = &left_[m];
    if (left->together == 4) {
      subtract_together<4>(left);
    } else if (left->together == 2) {
      subtract_together<2>(left);
    } else {
      subtract_together<1>(left);
    }
  }
}

/// Each sum is read and written once for all of the columns, in which it goes on in their order.
template <int kCount>
void BlockCholesky::subtract_together(LeftBlock const* left) {
  std::array<double const*, kCount> from;
  std::array<Pair, kCount> first;
  std::array<Pair, kCount> second;
  for (int c = 0; c < kCount; ++c) {
    from[c] = &numbers_[4L * left[c].position];
    first[c] = Pair{from[c][0], from[c][2]};
    second[c] = Pair{from[c][1], from[c][3]};
  }
  int const* const rows = &rows_[left->position];
  int const* const target = target_.data();
  double* const numbers = numbers_.data();
  int const count = left->end - left->position;
  for (int k = 0; k < count; ++k) {
    double* const to = numbers + target[rows[k]];
    Pair upper = {to[0], to[1]};
    Pair lower = {to[2], to[3]};
    for (int c = 0; c < kCount; ++c) {
      double const* const block = from[c] + 4 * k;
      upper -= block[0] * first[c] + block[1] * second[c];
      lower -= block[2] * first[c] + block[3] * second[c];
    }
    to[0] = upper[0];
    to[1] = upper[1];
    to[2] = lower[0];
    to[3] = lower[1];
  }
}

/// Of the diagonal, the inverses of its two numbers are kept: they are only ever divided by.
bool BlockCholesky::divide_by_diagonal(int column) {
  double* const diagonal = &numbers_[4L * starts_[column]];
  bool const is_first_positive = diagonal[0] > 0;
  if (!is_first_positive) return false;
  double const first = 1 / std::sqrt(diagonal[0]);
  double const below = diagonal[2] * first;
  double const rest = diagonal[3] - below * below;
  bool const is_positive = rest > 0 && std::isfinite(first) && std::isfinite(rest);
  if (!is_positive) return false;
  double const second = 1 / std::sqrt(rest);
  diagonal[0] = first;
  diagonal[1] = 0;
  diagonal[2] = below;
  diagonal[3] = second;
  for (int k = starts_[column] + 1; k < starts_[column + 1]; ++k) {
    double* const block = &numbers_[4L * k];
    block[0] *= first;
    block[1] = (block[1] - block[0] * below) * second;
    block[2] *= first;
    block[3] = (block[3] - block[2] * below) * second;
  }
  return true;
}

void BlockCholesky::solve(std::span<double> values) {
  CHECK(std::ssize(values) == std::ptrdiff_t{2} * size(), "two numbers per block row");
  auto& x = right_side_;
  for (int i = 0; i < size(); ++i) {
    x[2L * i] = values[2L * order_[i]];
    x[2L * i + 1] = values[2L * order_[i] + 1];
  }
  for (int j = 0; j < size(); ++j) {
    double const* block = &numbers_[4L * starts_[j]];
    double const first = x[2L * j] * block[0];
    double const second = (x[2L * j + 1] - block[2] * first) * block[3];
    x[2L * j] = first;
    x[2L * j + 1] = second;
    for (int k = starts_[j] + 1; k < starts_[j + 1]; ++k) {
      block = &numbers_[4L * k];
      x[2L * rows_[k]] -= block[0] * first + block[1] * second;
      x[2L * rows_[k] + 1] -= block[2] * first + block[3] * second;
    }
  }
  for (int j = size() - 1; j >= 0; --j) {
    double first = x[2L * j];
    double second = x[2L * j + 1];
    for (int k = starts_[j] + 1; k < starts_[j + 1]; ++k) {
      double const* const block = &numbers_[4L * k];
      first -= block[0] * x[2L * rows_[k]] + block[2] * x[2L * rows_[k] + 1];
      second -= block[1] * x[2L * rows_[k]] + block[3] * x[2L * rows_[k] + 1];
    }
    double const* const diagonal = &numbers_[4L * starts_[j]];
    x[2L * j + 1] = second * diagonal[3];
    x[2L * j] = (first - diagonal[2] * x[2L * j + 1]) * diagonal[0];
  }
  for (int i = 0; i < size(); ++i) {
    values[2L * order_[i]] = x[2L * i];
    values[2L * order_[i] + 1] = x[2L * i + 1];
  }
}

}  // namespace inkflate
