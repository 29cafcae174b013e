// SPDX-License-Identifier: Apache-2.0
#include "inflate/depth_solve.h"

#include <algorithm>

namespace inkflate {
namespace {

/// Ten are usual.
constexpr int kMostSteps = 30;
constexpr int kMostHalvings = 12;

/// What is missing to fulfil a rule; 0 if it holds.
double violation(DepthRule const& rule, std::vector<double> const& x) {
  double const missing = rule.gap - (rule.near(x) - rule.far(x));
  return rule.is_equality ? missing : std::max(missing, 0.0);
}

double total_energy(std::span<MatrixEntry const> energy, std::span<DepthRule const> rules,
                    std::vector<double> const& x) {
  double sum = 0;
  for (auto const& e : energy) {
    sum += e.value * x[e.row] * x[e.column] * (e.row == e.column ? 1 : 2);
  }
  for (auto const& rule : rules) {
    double const missing = violation(rule, x);
    sum += rule.weight * missing * missing;
  }
  return sum;
}

bool is_active(DepthRule const& rule, std::vector<double> const& x) {
  return rule.is_equality || violation(rule, x) > 0;
}

void add_rule(DepthRule const& rule, std::vector<MatrixEntry>& entries, std::vector<double>& b) {
  std::array<int, 18> nodes = {};
  std::array<double, 18> weights = {};
  for (int i = 0; i < 9; ++i) {
    nodes[i] = rule.near.nodes[i];
    nodes[i + 9] = rule.far.nodes[i];
    weights[i] = rule.near.weights[i];
    weights[i + 9] = -rule.far.weights[i];
  }
  for (int i = 0; i < 18; ++i) {
    b[nodes[i]] += rule.weight * rule.gap * weights[i];
    for (int j = 0; j < 18; ++j) {
      if (nodes[i] < nodes[j]) continue;
      entries.push_back({nodes[i], nodes[j], rule.weight * weights[i] * weights[j]});
    }
  }
}

std::vector<double> blend(std::vector<double> const& a, std::vector<double> const& b, double t) {
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] + (b[i] - a[i]) * t;
  return result;
}

}  // namespace

std::vector<double> solve_depths(int unknown_count, std::span<MatrixEntry const> energy,
                                 std::span<DepthRule const> rules) {
  std::vector<double> x(unknown_count, 0);
  double least = total_energy(energy, rules, x);
  std::vector<char> last_active;
  for (int step = 0; step < kMostSteps; ++step) {
    std::vector<MatrixEntry> entries(energy.begin(), energy.end());
    std::vector<double> goal(unknown_count, 0);
    std::vector<char> active;
    for (auto const& rule : rules) {
      active.push_back(is_active(rule, x) ? 1 : 0);
      if (active.back()) add_rule(rule, entries, goal);
    }
    if (active == last_active) break;
    last_active = active;
    auto const solver = SparseCholesky::factor(unknown_count, entries);
    if (!solver) break;  // numbers beyond double: what was reached is kept
    solver->solve(goal);
    double t = 1;
    auto next = goal;
    double sum = total_energy(energy, rules, next);
    for (int i = 0; i < kMostHalvings && !(sum < least); ++i) {
      t /= 2;
      next = blend(x, goal, t);
      sum = total_energy(energy, rules, next);
    }
    if (!(sum < least)) break;
    least = sum;
    x = next;
  }
  return x;
}

}  // namespace inkflate
