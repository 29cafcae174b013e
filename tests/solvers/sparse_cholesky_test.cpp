// SPDX-License-Identifier: Apache-2.0
#include "solvers/sparse_cholesky.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"
#include "base/rng.h"

namespace inkflate {
namespace {

/// The five-point Laplacian of a square grid with zero outside of it.
std::vector<MatrixEntry> grid_laplacian(int side) {
  std::vector<MatrixEntry> entries;
  for (int i = 0; i < side * side; ++i) {
    entries.push_back({i, i, 4});
    if (i % side > 0) entries.push_back({i, i - 1, -1});
    if (i >= side) entries.push_back({i, i - side, -1});
  }
  return entries;
}

std::vector<double> product(std::span<MatrixEntry const> entries, std::span<double const> x) {
  std::vector<double> result(x.size(), 0);
  for (auto const& e : entries) {
    result[e.row] += e.value * x[e.column];
    if (e.row != e.column) result[e.column] += e.value * x[e.row];
  }
  return result;
}

std::vector<double> random_values(int count) {
  Rng rng(7);
  std::vector<double> values(count);
  for (auto& v : values) v = rng.uniform(-1, 1);
  return values;
}

TEST(SparseCholesky, SolutionTimesMatrixIsTheRightHandSide) {
  auto const entries = grid_laplacian(20);
  auto const solver = SparseCholesky::factor(400, entries);
  ASSERT_TRUE(solver);
  auto const b = random_values(400);
  auto x = b;
  solver->solve(x);
  auto const back = product(entries, x);
  for (int i = 0; i < 400; ++i) EXPECT_NEAR(back[i], b[i], 1e-12);
}

TEST(SparseCholesky, RepeatedEntriesAreAdded) {
  std::vector<MatrixEntry> const entries = {
      {0, 0, 1}, {0, 0, 3}, {1, 1, 2}, {1, 0, 0.5}, {1, 0, 0.5}};
  auto const solver = SparseCholesky::factor(2, entries);
  ASSERT_TRUE(solver);
  std::vector<double> x = {6, 5};  // of 4 x + y = 6, x + 2 y = 5
  solver->solve(x);
  EXPECT_NEAR(x[0], 1, 1e-15);
  EXPECT_NEAR(x[1], 2, 1e-15);
}

TEST(SparseCholesky, RightHandSidesSideBySideAreSolvedAsIfAlone) {
  auto const solver = SparseCholesky::factor(100, grid_laplacian(10));
  ASSERT_TRUE(solver);
  auto together = random_values(300);
  std::vector<std::vector<double>> alone(3, std::vector<double>(100));
  for (int i = 0; i < 300; ++i) alone[i % 3][i / 3] = together[i];
  solver->solve(together, 3);
  for (auto& values : alone) solver->solve(values);
  for (int i = 0; i < 300; ++i) EXPECT_EQ(together[i], alone[i % 3][i / 3]);
}

TEST(SparseCholesky, RefusesWhatIsNotPositiveDefinite) {
  EXPECT_FALSE(SparseCholesky::factor(1, std::vector<MatrixEntry>{{0, 0, -1}}));
  EXPECT_FALSE(SparseCholesky::factor(1, std::vector<MatrixEntry>{{0, 0, 0}}));
  EXPECT_FALSE(SparseCholesky::factor(2, std::vector<MatrixEntry>{{0, 0, 1}}));
  EXPECT_FALSE(
      SparseCholesky::factor(2, std::vector<MatrixEntry>{{0, 0, 1}, {1, 0, 2}, {1, 1, 1}}));
  EXPECT_FALSE(SparseCholesky::factor(1, std::vector<MatrixEntry>{{0, 0, std::nan("")}}));
}

TEST(SparseCholesky, NoEquationsHaveNoSolution) {
  auto const solver = SparseCholesky::factor(0, {});
  ASSERT_TRUE(solver);
  std::vector<double> none;
  solver->solve(none);
  EXPECT_EQ(solver->size(), 0);
}

TEST(SparseCholesky, GivesTheSameBitsOnEveryMachine) {
  auto const solver = SparseCholesky::factor(900, grid_laplacian(30));
  ASSERT_TRUE(solver);
  auto x = random_values(900);
  solver->solve(x);
  Hash hash;
  for (double const v : x) hash.add(v);
  EXPECT_EQ(hash.value(), 0xf68d41ccdd0b3fc8U) << std::hex << hash.value();
}

}  // namespace
}  // namespace inkflate
