// SPDX-License-Identifier: Apache-2.0
#include "deform/wire_system.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace inkflate {
namespace {

// What the constraints before leave of the compliance of one. Where weights are about 1 it is the square of a distance in edges:
// constraints nearer to each other than a thousandth of an edge are at one place.
constexpr double kLeastCompliance = 1e-6;

bool is_same_place(WireConstraint const& a, WireConstraint const& b) {
  return a.vertices == b.vertices && a.weights == b.weights;
}

Vec2 place_of(WireConstraint const& constraint, std::span<Vec2 const> pose) {
  Vec2 sum;
  for (int k = 0; k < 3; ++k) sum += pose[constraint.vertices[k]] * constraint.weights[k];
  return sum;
}

}  // namespace

WireSystem::WireSystem(std::span<WireEdge const> edges, std::vector<int> components,
                       std::vector<char> is_fixed)
    : components_(std::move(components)), is_fixed_(std::move(is_fixed)) {
  CHECK(components_.size() == is_fixed_.size(), "one per vertex");
  number_unknowns();
  factor_ = factored(edges);
}

void WireSystem::number_unknowns() {
  has_fixed_.assign(components_.size(), 0);
  for (int v = 0; v < std::ssize(components_); ++v) {
    unknowns_.push_back(is_fixed_[v] ? -1 : unknown_count_++);
    if (is_fixed_[v]) has_fixed_[components_[v]] = 1;
  }
  is_held_ = has_fixed_;
}

SparseCholesky WireSystem::factored(std::span<WireEdge const> edges) const {
  std::vector<double> diagonal(components_.size(), 0);
  std::vector<MatrixEntry> entries;
  for (auto const& [a, b, weight, rest] : edges) {
    diagonal[a] += weight;
    diagonal[b] += weight;
    // Unknowns are in the order of the vertices, and a < b.
    if (!is_fixed_[a] && !is_fixed_[b]) entries.push_back({unknowns_[b], unknowns_[a], -weight});
  }
  for (int v = 0; v < std::ssize(components_); ++v) {
    if (is_fixed_[v]) continue;
    // A component that could be shifted is tied to where it is at its lowest vertex.
    bool const is_tied = components_[v] == v && !has_fixed_[v];
    double const tie = diagonal[v] > 0 ? diagonal[v] : 1;
    entries.push_back({unknowns_[v], unknowns_[v], diagonal[v] + (is_tied ? tie : 0)});
  }
  auto factor = SparseCholesky::factor(unknown_count_, entries);
  CHECK(factor.has_value(), "weights are positive, and every component is fixed or tied somewhere");
  return *std::move(factor);
}

void WireSystem::hold(std::span<WireConstraint const> constraints) {
  bool const is_as_before = std::equal(constraints.begin(), constraints.end(), constraints_.begin(),
                                       constraints_.end(), is_same_place);
  auto const before = std::exchange(constraints_, {constraints.begin(), constraints.end()});
  if (is_as_before) return;
  auto old = std::exchange(columns_, {});
  compliance_ = {};
  is_held_ = has_fixed_;
  for (int i = static_cast<int>(std::ssize(constraints)) - 1; i >= 0; --i) {
    auto const is_here = [&](WireConstraint const& other) {
      return is_same_place(other, constraints[i]);
    };
    if (std::any_of(constraints.begin() + i + 1, constraints.end(), is_here)) continue;
    auto const same = std::find_if(old.begin(), old.end(), [&](Column const& column) {
      return is_here(before[column.constraint]);
    });
    append({i, same == old.end() ? response_to(constraints[i]) : std::move(same->response)});
  }
  unit_forces_.assign(columns_.size(), 1);
  compliance_.solve(unit_forces_);
}

std::vector<double> WireSystem::response_to(WireConstraint const& constraint) const {
  std::vector<double> response(static_cast<std::size_t>(unknown_count_), 0);
  for (int k = 0; k < 3; ++k) {
    int const unknown = unknowns_[constraint.vertices[k]];
    if (unknown >= 0) response[unknown] += constraint.weights[k];
  }
  factor_->solve(response);
  return response;
}

double WireSystem::along(WireConstraint const& constraint, std::span<double const> response) const {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    int const unknown = unknowns_[constraint.vertices[k]];
    if (unknown >= 0) sum += constraint.weights[k] * response[unknown];
  }
  return sum;
}

int WireSystem::component_of(Column const& column) const {
  return components_[constraints_[column.constraint].vertices[0]];
}

void WireSystem::append(Column column) {
  std::vector<double> row;
  for (auto const& other : columns_)
    row.push_back(along(constraints_[other.constraint], column.response));
  auto forces = row;
  compliance_.solve(forces);
  double const whole = along(constraints_[column.constraint], column.response);
  double left = whole;
  for (std::size_t i = 0; i < row.size(); ++i) left -= row[i] * forces[i];
  row.push_back(whole);
  if (!(left > kLeastCompliance) || !compliance_.append(std::move(row))) return;
  is_held_[component_of(column)] = 1;
  columns_.push_back(std::move(column));
}

std::vector<Vec2> WireSystem::free_moves(std::span<Vec2 const> values) const {
  std::vector<double> moves;
  moves.reserve(static_cast<std::size_t>(unknown_count_) * 2);
  for (int v = 0; v < std::ssize(values); ++v) {
    if (is_fixed_[v]) continue;
    Vec2 const value = is_held_[components_[v]] ? values[v] : Vec2{};
    moves.push_back(value.x);
    moves.push_back(value.y);
  }
  factor_->solve(moves, 2);
  std::vector<Vec2> result(values.size());
  for (int v = 0; v < std::ssize(values); ++v) {
    int const unknown = unknowns_[v];
    if (unknown >= 0) result[v] = {moves[2L * unknown], moves[2L * unknown + 1]};
  }
  return result;
}

std::vector<Vec2> WireSystem::forces_on(std::span<Vec2 const> moves, std::span<Vec2 const> pose,
                                        std::span<Vec2> shifts) const {
  std::vector<double> x;
  std::vector<double> y;
  for (auto const& column : columns_) {
    auto const& constraint = constraints_[column.constraint];
    Vec2 const miss = place_of(constraint, moves) + place_of(constraint, pose) - constraint.target;
    x.push_back(miss.x);
    y.push_back(miss.y);
  }
  compliance_.solve(x);
  compliance_.solve(y);
  // The forces on a component that nothing fixes have to cancel: it is shifted until they do.
  std::vector<double> stiffness(shifts.size(), 0);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    int const component = component_of(columns_[i]);
    shifts[component] -= {x[i], y[i]};
    stiffness[component] += unit_forces_[i];
  }
  std::vector<Vec2> forces;
  for (int v = 0; v < std::ssize(shifts); ++v)
    shifts[v] = stiffness[v] > 0 && !has_fixed_[v] ? shifts[v] / stiffness[v] : Vec2{};
  for (std::size_t i = 0; i < columns_.size(); ++i)
    forces.push_back(Vec2{x[i], y[i]} + shifts[component_of(columns_[i])] * unit_forces_[i]);
  return forces;
}

void WireSystem::solve(std::span<Vec2> values, std::span<Vec2 const> pose) const {
  auto const moves = free_moves(values);
  std::vector<Vec2> shifts(values.size());
  auto const forces = forces_on(moves, pose, shifts);
  for (int v = 0; v < std::ssize(values); ++v) {
    int const unknown = unknowns_[v];
    values[v] = {};
    if (unknown < 0) continue;
    values[v] = moves[v] + shifts[components_[v]];
    for (std::size_t i = 0; i < columns_.size(); ++i)
      values[v] -= columns_[i].response[unknown] * forces[i];
  }
}

}  // namespace inkflate
