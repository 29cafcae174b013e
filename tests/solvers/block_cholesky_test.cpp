// SPDX-License-Identifier: Apache-2.0
#include "solvers/block_cholesky.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"
#include "base/rng.h"
#include "support/extremes.h"

namespace inkflate {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

Pairs grid_pairs(int side) {
  Pairs pairs;
  for (int i = 0; i < side * side; ++i) {
    if (i % side > 0) pairs.push_back({i, i - 1});
    if (i >= side) pairs.push_back({i - side, i});
  }
  return pairs;
}

/// A matrix in full, row by row.
struct Dense {
  int size = 0;
  std::vector<double> numbers;
  double& at(int row, int column) { return numbers[row * size + column]; }
};

/// Random numbers on a pattern, with so much on the diagonal that it is positive definite; given to the matrix and in full.
Dense fill_at_random(BlockCholesky& matrix, Pairs const& pairs, Rng& rng) {
  Dense dense{2 * matrix.size(), std::vector<double>(4 * matrix.size() * matrix.size())};
  matrix.clear();
  auto const add = [&](int row, int column, std::array<double, 4> const& block) {
    for (int k = 0; k < 4; ++k) {
      matrix.numbers()[matrix.start_of(row, column) + k] += block[k];
      dense.at(2 * row + k / 2, 2 * column + k % 2) += block[k];
      if (row != column) dense.at(2 * column + k % 2, 2 * row + k / 2) += block[k];
    }
  };
  for (auto const& [a, b] : pairs) {
    std::array<double, 4> block{};
    for (auto& v : block) v = rng.uniform(-1, 1);
    bool const is_kept = matrix.is_kept(a, b);
    add(is_kept ? a : b, is_kept ? b : a, block);
  }
  for (int i = 0; i < matrix.size(); ++i) {
    double const beside = rng.uniform(-1, 1);
    add(i, i, {12, beside, beside, 12});
  }
  return dense;
}

double largest_error(Dense& matrix, std::vector<double> const& x, std::vector<double> const& b) {
  double largest = 0;
  for (int i = 0; i < matrix.size; ++i) {
    double sum = -b[i];
    for (int j = 0; j < matrix.size; ++j) sum += matrix.at(i, j) * x[j];
    largest = support::larger(largest, std::abs(sum));
  }
  return largest;
}

std::vector<double> random_values(int count, Rng& rng) {
  std::vector<double> values(count);
  for (auto& v : values) v = rng.uniform(-1, 1);
  return values;
}

TEST(BlockCholesky, SolutionTimesMatrixIsTheRightHandSideHoweverOftenTheNumbersChange) {
  auto const pairs = grid_pairs(9);
  BlockCholesky matrix(81, pairs);
  Rng rng(1);
  for (int k = 0; k < 3; ++k) {
    auto dense = fill_at_random(matrix, pairs, rng);
    ASSERT_TRUE(matrix.factor());
    auto const b = random_values(162, rng);
    auto x = b;
    matrix.solve(x);
    EXPECT_LT(largest_error(dense, x, b), 1e-13);
  }
}

TEST(BlockCholesky, PairsInAnyOrderAndRepeatedAreTheSamePattern) {
  Pairs const pairs = {{0, 1}, {1, 0}, {2, 1}, {1, 2}, {1, 2}};
  BlockCholesky matrix(3, pairs);
  Rng rng(2);
  auto dense = fill_at_random(matrix, {{0, 1}, {1, 2}}, rng);
  ASSERT_TRUE(matrix.factor());
  auto const b = random_values(6, rng);
  auto x = b;
  matrix.solve(x);
  EXPECT_LT(largest_error(dense, x, b), 1e-14);
}

TEST(BlockCholesky, OneOfTwoMirroredBlocksIsKept) {
  BlockCholesky const matrix(4, Pairs{{0, 1}, {3, 2}, {1, 3}});
  EXPECT_NE(matrix.is_kept(0, 1), matrix.is_kept(1, 0));
  EXPECT_NE(matrix.is_kept(3, 1), matrix.is_kept(1, 3));
}

TEST(BlockCholesky, SaysWhatIsNotPositiveDefinite) {
  BlockCholesky matrix(2, Pairs{{0, 1}});
  auto const factors = [&](std::array<double, 3> first, double beside) {
    matrix.clear();
    auto const numbers = matrix.numbers();
    for (int i = 0; i < 2; ++i) {
      numbers[matrix.start_of(i, i)] = first[0];
      numbers[matrix.start_of(i, i) + 2] = first[1];
      numbers[matrix.start_of(i, i) + 3] = first[2];
    }
    int const row = matrix.is_kept(0, 1) ? 0 : 1;
    numbers[matrix.start_of(row, 1 - row)] = beside;
    return matrix.factor();
  };
  EXPECT_TRUE(factors({2, 1, 2}, 0.5));
  EXPECT_FALSE(factors({0, 0, 1}, 0));
  EXPECT_FALSE(factors({1, 0, 0}, 0));
  EXPECT_FALSE(factors({-1, 0, 1}, 0));
  EXPECT_FALSE(factors({1, 2, 1}, 0));
  EXPECT_FALSE(factors({1, 0, 1}, 2));
  EXPECT_FALSE(factors({std::nan(""), 0, 1}, 0));
  EXPECT_TRUE(factors({2, 1, 2}, 0.5));
}

TEST(BlockCholesky, RowsWithoutPairsStandAlone) {
  BlockCholesky matrix(3, {});
  matrix.clear();
  for (int i = 0; i < 3; ++i) {
    matrix.numbers()[matrix.start_of(i, i)] = 4;
    matrix.numbers()[matrix.start_of(i, i) + 3] = i + 1;
  }
  ASSERT_TRUE(matrix.factor());
  std::vector<double> x = {4, 1, 8, 4, 12, 9};
  matrix.solve(x);
  std::vector<double> const expected = {1, 1, 2, 2, 3, 3};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(x[i], expected[i], 1e-14);
}

TEST(BlockCholesky, NoEquationsHaveNoSolution) {
  BlockCholesky matrix(0, {});
  matrix.clear();
  EXPECT_TRUE(matrix.factor());
  std::vector<double> none;
  matrix.solve(none);
  EXPECT_EQ(matrix.size(), 0);
}

TEST(BlockCholesky, GivesTheSameBitsOnEveryMachine) {
  auto const pairs = grid_pairs(20);
  BlockCholesky matrix(400, pairs);
  Rng rng(7);
  fill_at_random(matrix, pairs, rng);
  ASSERT_TRUE(matrix.factor());
  auto x = random_values(800, rng);
  matrix.solve(x);
  Hash hash;
  for (double const v : x) hash.add(v);
  EXPECT_EQ(hash.value(), 0x3e282df856bf2bb7U) << std::hex << hash.value();
}

}  // namespace
}  // namespace inkflate
