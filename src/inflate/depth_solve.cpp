// SPDX-License-Identifier: Apache-2.0
#include "inflate/depth_solve.h"

#include <algorithm>

#include "solvers/growing_cholesky.h"

namespace inkflate {
namespace {

/// A rule that is broken by less is left alone: well below the margin between layers.
constexpr double kGoodEnoughPx = 0.01;

/// Twenty rounds are usual; this many end the work should layers be tangled beyond all reason.
constexpr int kMostRounds = 400;
constexpr int kMostPushing = 1000;

constexpr std::size_t kSolvedAtOnce = 16;

/// How much a rule lacks, px.
double lack(DepthRule const& rule, std::span<double const> x) {
  return rule.gap - (rule.near(x) - rule.far(x));
}

template <typename Visit>
void for_each_term(DepthRule const& rule, Visit visit) {
  for (int i = 0; i < 9; ++i) visit(rule.near.nodes[i], rule.near.weights[i]);
  for (int i = 0; i < 9; ++i) visit(rule.far.nodes[i], -rule.far.weights[i]);
}

/// Adds weight / 2 * (near - far - gap)^2.
void add_equality(DepthRule const& rule, std::vector<MatrixEntry>& energy, std::vector<double>& b) {
  for_each_term(rule, [&](int i, double a) {
    b[i] += rule.weight * rule.gap * a;
    for_each_term(rule, [&](int j, double c) {
      if (i >= j) energy.push_back({i, j, rule.weight * a * c});
    });
  });
}

/// The rules that push, how hard they do, and where the plates are because of it.
class Contacts {
 public:
  /// goal: the right-hand side without any pushing
  Contacts(SparseCholesky const& solver, std::span<DepthRule const> rules, std::vector<double> goal)
      : solver_(solver), rules_(rules), goal_(std::move(goal)), is_pushing_(rules.size(), 0) {
    place();
    free_ = x_;
  }

  std::vector<double> const& x() const { return x_; }
  bool is_pushing(int rule) const { return is_pushing_[rule] != 0; }
  int size() const { return static_cast<int>(pushing_.size()); }

  void add(std::span<int const> more);
  /// Finds the forces with which all pushing rules hold; lets go those that would pull. False: nothing moved.
  bool settle();

 private:
  void release(int k);
  void place();

  SparseCholesky const& solver_;
  std::span<DepthRule const> rules_;
  std::vector<double> goal_;
  std::vector<char> is_pushing_;
  std::vector<int> pushing_;
  std::vector<double> forces_;
  std::vector<double> free_;    // x without any pushing
  std::vector<double> x_;       // with it
  GrowingCholesky compliance_;  // by how much each pushing rule is fulfilled by a force of each
};

void Contacts::add(std::span<int const> more) {
  int const columns = static_cast<int>(more.size());
  std::vector<double> answers(x_.size() * more.size(), 0);
  for (int c = 0; c < columns; ++c) {
    for_each_term(rules_[more[c]], [&](int i, double a) { answers[i * columns + c] += a; });
  }
  solver_.solve(answers, columns);
  for (int c = 0; c < columns; ++c) {
    auto const fulfilled = [&](int rule) {
      double sum = 0;
      for_each_term(rules_[rule], [&](int i, double a) { sum += a * answers[i * columns + c]; });
      return sum;
    };
    std::vector<double> row;
    for (int const other : pushing_) row.push_back(fulfilled(other));
    row.push_back(fulfilled(more[c]) + 1 / rules_[more[c]].weight);
    if (!compliance_.append(std::move(row))) continue;
    pushing_.push_back(more[c]);
    is_pushing_[more[c]] = 1;
    forces_.push_back(0);
  }
}

void Contacts::release(int k) {
  is_pushing_[pushing_[k]] = 0;
  compliance_.remove(k);
  pushing_.erase(pushing_.begin() + k);
  forces_.erase(forces_.begin() + k);
}

void Contacts::place() {
  x_ = goal_;
  for (int k = 0; k < size(); ++k) {
    for_each_term(rules_[pushing_[k]], [&](int i, double a) { x_[i] += forces_[k] * a; });
  }
  solver_.solve(x_);
}

bool Contacts::settle() {
  bool has_moved = false;
  while (size() > 0) {
    std::vector<double> wanted;
    for (int const rule : pushing_) wanted.push_back(lack(rules_[rule], free_));
    compliance_.solve(wanted);
    // As far towards the wanted forces as all stay pushes.
    double step = 1;
    int first = -1;
    for (int k = 0; k < size(); ++k) {
      if (wanted[k] > 0) continue;
      double const limit = forces_[k] > 0 ? forces_[k] / (forces_[k] - wanted[k]) : 0;
      if (first >= 0 && limit >= step) continue;
      step = limit;
      first = k;
    }
    for (int k = 0; k < size(); ++k) forces_[k] += step * (wanted[k] - forces_[k]);
    has_moved = has_moved || step > 0;
    if (first < 0) break;
    release(first);
  }
  place();
  return has_moved;
}

/// The worst broken rule of each group; only the worst of all if `single`.
std::vector<int> worst_rules(Contacts const& contacts, std::span<DepthRule const> rules,
                             bool single) {
  std::vector<int> worst;
  double most = 0;
  int group = -1;
  for (int i = 0; i < std::ssize(rules); ++i) {
    if (rules[i].is_equality || contacts.is_pushing(i)) continue;
    double const missing = lack(rules[i], contacts.x());
    if (!(missing > kGoodEnoughPx)) continue;
    bool const is_new_group = !single && rules[i].group != group;
    if (worst.empty() || is_new_group) {
      worst.push_back(i);
    } else if (missing > most) {
      worst.back() = i;
    } else {
      continue;
    }
    group = rules[i].group;
    most = missing;
  }
  return worst;
}

}  // namespace

std::vector<double> solve_depths(int unknown_count, std::vector<MatrixEntry> energy,
                                 std::span<DepthRule const> rules) {
  std::vector<double> goal(unknown_count, 0);
  for (auto const& rule : rules) {
    if (rule.is_equality) add_equality(rule, energy, goal);
  }
  auto const solver = SparseCholesky::factor(unknown_count, energy);
  if (!solver) return std::vector<double>(unknown_count, 0);  // numbers beyond double
  Contacts contacts(*solver, rules, std::move(goal));
  bool single = false;
  for (int round = 0; round < kMostRounds && contacts.size() < kMostPushing; ++round) {
    auto const worst = worst_rules(contacts, rules, single);
    if (worst.empty()) break;
    for (std::size_t i = 0; i < worst.size(); i += kSolvedAtOnce) {
      contacts.add(std::span(worst).subspan(i, std::min(kSolvedAtOnce, worst.size() - i)));
    }
    bool const has_moved = contacts.settle();
    if (!has_moved && single) break;  // as good as rounding allows
    single = !has_moved;
  }
  return contacts.x();
}

}  // namespace inkflate
