// SPDX-License-Identifier: Apache-2.0
#include "inflate/depth_solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/rng.h"

namespace inkflate {
namespace {

constexpr double kWeight = 1e6;

/// A plate of one unknown.
PlateRow only(int node) {
  PlateRow row;
  row.nodes.fill(node);
  row.weights[0] = 1;
  return row;
}

DepthRule at_least(int near, int far, double gap, int group = 0) {
  return {only(near), only(far), gap, kWeight, false, group};
}

double cost(std::span<MatrixEntry const> energy, std::span<DepthRule const> rules,
            std::span<double const> x) {
  double sum = 0;
  for (auto const& e : energy) sum += e.value * x[e.row] * x[e.column] / 2;
  for (auto const& rule : rules) {
    double const lack = rule.gap - rule.near(x) + rule.far(x);
    if (rule.is_equality || lack > 0) sum += rule.weight * lack * lack / 2;
  }
  return sum;
}

/// The least cost by trying which rules push, for diagonal energies.
double least_cost(std::vector<MatrixEntry> const& energy, std::span<DepthRule const> rules) {
  double least = std::numeric_limits<double>::infinity();
  auto const size = static_cast<int>(energy.size());
  for (int chosen = 0; chosen < 1 << rules.size(); ++chosen) {
    auto entries = energy;
    std::vector<double> x(size, 0);
    for (std::size_t i = 0; i < rules.size(); ++i) {
      if ((chosen >> i) % 2 == 0) continue;
      int const near = rules[i].near.nodes[0];
      int const far = rules[i].far.nodes[0];
      entries.push_back({near, near, kWeight});
      entries.push_back({far, far, kWeight});
      entries.push_back({std::max(near, far), std::min(near, far), -kWeight});
      x[near] += kWeight * rules[i].gap;
      x[far] -= kWeight * rules[i].gap;
    }
    SparseCholesky::factor(size, entries).value().solve(x);
    least = std::min(least, cost(energy, rules, x));
  }
  return least;
}

TEST(DepthSolve, TwoPlatesGiveWayInProportionToTheirSoftness) {
  std::vector<MatrixEntry> const energy = {{0, 0, 3}, {1, 1, 1}};
  std::vector<DepthRule> const rules = {at_least(1, 0, 40)};
  auto const x = solve_depths(2, energy, rules);
  EXPECT_NEAR(x[0], -10, 1e-4);
  EXPECT_NEAR(x[1], 30, 1e-4);
}

TEST(DepthSolve, RulesThatHoldDoNothing) {
  std::vector<MatrixEntry> const energy = {{0, 0, 3}, {1, 1, 1}};
  std::vector<DepthRule> const rules = {at_least(1, 0, -5)};
  EXPECT_EQ(solve_depths(2, energy, rules), (std::vector<double>{0, 0}));
}

TEST(DepthSolve, EqualitiesPullAsWellAsPush) {
  std::vector<MatrixEntry> const energy = {{0, 0, 1}, {1, 1, 1}};
  std::vector<DepthRule> const rules = {{only(1), only(0), -8, kWeight, true, 0}};
  auto const x = solve_depths(2, energy, rules);
  EXPECT_NEAR(x[1] - x[0], -8, 1e-4);
  EXPECT_NEAR(x[1], -4, 1e-4);
}

TEST(DepthSolve, IsAsCheapAsTheBestOfAllChoicesOfRules) {
  Rng rng(5);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<MatrixEntry> energy;
    for (int i = 0; i < 5; ++i) energy.push_back({i, i, rng.uniform(0.1, 10)});
    std::vector<DepthRule> rules;
    for (int i = 0; i < 8; ++i) {
      int const far = rng.below(4);
      int const near = far + 1 + rng.below(4 - far);
      rules.push_back(at_least(near, far, rng.uniform(-20, 50), i / 2));
    }
    auto const x = solve_depths(5, energy, rules);
    double const least = least_cost(energy, rules);
    // Rules may stay broken by a hundredth of a px.
    EXPECT_LE(cost(energy, rules, x), least * 1.001 + kWeight * 1e-4) << trial;
    for (auto const& rule : rules)
      EXPECT_GE(x[rule.near.nodes[0]] - x[rule.far.nodes[0]], rule.gap - 0.011);
  }
}

TEST(DepthSolve, WhatCannotBeEndsInACompromise) {
  std::vector<MatrixEntry> const energy = {{0, 0, 1}, {1, 1, 1}, {2, 2, 1}};
  std::vector<DepthRule> const rules = {at_least(1, 0, 10, 0), at_least(2, 1, 10, 1),
                                        at_least(0, 2, 10, 2)};
  auto const x = solve_depths(3, energy, rules);
  for (double const z : x) EXPECT_NEAR(z, 0, 0.1);  // each rule lacks the same
}

TEST(DepthSolve, OfNothingIsNothing) { EXPECT_TRUE(solve_depths(0, {}, {}).empty()); }

}  // namespace
}  // namespace inkflate
