// SPDX-License-Identifier: Apache-2.0
#include "inflate/depth_solve.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "solvers/growing_cholesky.h"

namespace inkflate {
namespace {

/// A rule that is broken by less is left alone: well below the margin between layers.
constexpr double kGoodEnoughPx = 0.01;

/// Twenty rounds are usual; this many end the work should layers be tangled beyond all reason.
constexpr int kMostRounds = 400;
constexpr int kMostPushing = 1500;

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
  Contacts(SparseCholesky const& solver, std::span<DepthRule const> rules, std::vector<double> x)
      : solver_(solver), rules_(rules), x_(std::move(x)), is_pushing_(rules.size(), 0) {}

  std::vector<double> const& x() const { return x_; }
  bool is_pushing(int rule) const { return is_pushing_[rule] != 0; }
  int size() const { return static_cast<int>(pushing_.size()); }

  void add(std::vector<int> const& more);
  /// Finds the forces with which all pushing rules hold; lets go those that would pull. False: nothing moved.
  bool settle();

 private:
  void release(int k);

  SparseCholesky const& solver_;
  std::span<DepthRule const> rules_;
  std::vector<double> x_;
  std::vector<char> is_pushing_;
  std::vector<int> pushing_;
  std::vector<double> forces_;
  std::vector<std::vector<double>> answers_;  // how x changes with each force
  GrowingCholesky compliance_;
};

void Contacts::add(std::vector<int> const& more) {
  int const columns = static_cast<int>(more.size());
  std::vector<double> block(x_.size() * more.size(), 0);
  for (int c = 0; c < columns; ++c) {
    for_each_term(rules_[more[c]], [&](int i, double a) { block[i * columns + c] += a; });
  }
  solver_.solve(block, columns);
  for (int c = 0; c < columns; ++c) {
    auto const& rule = rules_[more[c]];
    std::vector<double> answer(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) answer[i] = block[i * columns + c];
    std::vector<double> row;
    for (int const other : pushing_) {
      row.push_back(rules_[other].near(answer) - rules_[other].far(answer));
    }
    row.push_back(rule.near(answer) - rule.far(answer) + 1 / rule.weight);
    if (!compliance_.append(std::move(row))) continue;
    pushing_.push_back(more[c]);
    is_pushing_[more[c]] = 1;
    forces_.push_back(0);
    answers_.push_back(std::move(answer));
  }
}

void Contacts::release(int k) {
  is_pushing_[pushing_[k]] = 0;
  compliance_.remove(k);
  pushing_.erase(pushing_.begin() + k);
  forces_.erase(forces_.begin() + k);
  answers_.erase(answers_.begin() + k);
}

bool Contacts::settle() {
  bool has_moved = false;
  while (size() > 0) {
    std::vector<double> change;
    for (int k = 0; k < size(); ++k) {
      auto const& rule = rules_[pushing_[k]];
      change.push_back(lack(rule, x_) - forces_[k] / rule.weight);
    }
    compliance_.solve(change);
    double step = 1;
    int first = -1;
    for (int k = 0; k < size(); ++k) {
      if (forces_[k] + change[k] > 0) continue;
      double const limit = change[k] < 0 ? forces_[k] / -change[k] : 0;
      if (limit < step || first < 0) {
        step = limit;
        first = k;
      }
    }
    for (int k = 0; k < size() && step > 0; ++k) {
      double const force = step * change[k];
      forces_[k] += force;
      for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += force * answers_[k][i];
    }
    has_moved = has_moved || step > 0;
    if (first < 0) return has_moved;
    release(first);
  }
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
  std::vector<double> x(unknown_count, 0);
  for (auto const& rule : rules) {
    if (rule.is_equality) add_equality(rule, energy, x);
  }
  auto const solver = SparseCholesky::factor(unknown_count, energy);
  if (!solver) return std::vector<double>(unknown_count, 0);  // numbers beyond double
  solver->solve(x);
  Contacts contacts(*solver, rules, std::move(x));
  bool single = false;
  int round = 0;
  for (; round < kMostRounds && contacts.size() < kMostPushing; ++round) {
    auto const worst = worst_rules(contacts, rules, single);
    if (worst.empty()) break;
    contacts.add(worst);
    bool const has_moved = contacts.settle();
    if (!has_moved && single) break;  // as good as rounding allows
    single = !has_moved;
  }
  if (getenv("DBG"))
    fprintf(stderr, "rounds %d pushing %d unknowns %d rules %zd\n", round, contacts.size(),
            unknown_count, rules.size());
  return contacts.x();
}

}  // namespace inkflate
