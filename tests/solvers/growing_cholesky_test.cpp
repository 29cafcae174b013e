// SPDX-License-Identifier: Apache-2.0
#include "solvers/growing_cholesky.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rng.h"

namespace inkflate {
namespace {

/// A symmetric positive definite matrix: random products, and 1 on the diagonal.
std::vector<std::vector<double>> random_matrix(int size) {
  Rng rng(11);
  std::vector<std::vector<double>> b(size, std::vector<double>(size));
  for (auto& row : b) {
    for (auto& value : row) value = rng.uniform(-1, 1);
  }
  std::vector<std::vector<double>> a(size, std::vector<double>(size, 0));
  for (int i = 0; i < size; ++i) {
    a[i][i] = 1;
    for (int j = 0; j < size; ++j) {
      for (int k = 0; k < size; ++k) a[i][j] += b[i][k] * b[j][k];
    }
  }
  return a;
}

/// The factor of the rows and columns of a that are chosen.
GrowingCholesky factor_of(std::vector<std::vector<double>> const& a,
                          std::vector<int> const& chosen) {
  GrowingCholesky factor;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    std::vector<double> row;
    for (std::size_t j = 0; j <= i; ++j) row.push_back(a[chosen[i]][chosen[j]]);
    EXPECT_TRUE(factor.append(row));
  }
  return factor;
}

std::vector<double> counted(int size) {
  std::vector<double> values;
  for (int i = 0; i < size; ++i) values.push_back(i - 2.5);
  return values;
}

TEST(GrowingCholesky, SolutionTimesMatrixIsTheRightHandSide) {
  auto const a = random_matrix(6);
  auto x = counted(6);
  factor_of(a, {0, 1, 2, 3, 4, 5}).solve(x);
  for (int i = 0; i < 6; ++i) {
    double sum = 0;
    for (int j = 0; j < 6; ++j) sum += a[i][j] * x[j];
    EXPECT_NEAR(sum, i - 2.5, 1e-12);
  }
}

TEST(GrowingCholesky, WithoutARowIsAsIfItHadNeverBeen) {
  auto const a = random_matrix(6);
  for (int gone = 0; gone < 6; ++gone) {
    auto shrunk = factor_of(a, {0, 1, 2, 3, 4, 5});
    shrunk.remove(gone);
    std::vector<int> rest = {0, 1, 2, 3, 4, 5};
    rest.erase(rest.begin() + gone);
    auto const fresh = factor_of(a, rest);
    auto x = counted(5);
    auto y = counted(5);
    shrunk.solve(x);
    fresh.solve(y);
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(x[i], y[i], 1e-12);
  }
}

TEST(GrowingCholesky, RefusesARowThatRepeatsAnother) {
  GrowingCholesky factor;
  ASSERT_TRUE(factor.append({4}));
  EXPECT_FALSE(factor.append({4, 4}));
  EXPECT_FALSE(factor.append({0, -1}));
  EXPECT_FALSE(factor.append({0, std::nan("")}));
  EXPECT_EQ(factor.size(), 1);
  std::vector<double> x = {2};
  factor.solve(x);
  EXPECT_EQ(x[0], 0.5);
}

}  // namespace
}  // namespace inkflate
