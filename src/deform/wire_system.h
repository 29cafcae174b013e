// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "deform/wire_edges.h"
#include "solvers/growing_cholesky.h"
#include "solvers/sparse_cholesky.h"

namespace inkflate {

/// A weighted sum of vertices that has to lie at its target.
struct WireConstraint {
  std::array<int, 3> vertices = {0, 0, 0};
  std::array<double, 3> weights = {1, 0, 0};  // their sum is 1
  Vec2 target;                                // canvas px
};

/// Solves L d = r for the moves d of the vertices, where L is the matrix of the edges' weights, some vertices are fixed and
/// constraints hold. L is factored once, without what is fixed; constraints come in by the Schur complement.
///
/// source  thesis, eq. 4.9 and 4.10; docs/algorithms/wire.md
class WireSystem {
 public:
  /// in      components: connected_vertices() of the mesh; is_fixed: per vertex
  /// cost    one factorisation
  WireSystem(std::span<WireEdge const> edges, std::vector<int> components,
             std::vector<char> is_fixed);

  std::vector<char> const& is_fixed() const { return is_fixed_; }

  /// Says what holds from now on. Of constraints that cannot hold together the last ones count; those of fixed vertices alone do not.
  /// cost    one back-solve for each that did not hold before, O(k^3) for k of them
  void hold(std::span<WireConstraint const> constraints);

  /// Replaces right-hand sides by moves, after which every constraint holds. A component with neither a constraint nor a fixed vertex
  /// does not move.
  /// cost    one back-solve, and O(n) for each constraint
  void solve(std::span<Vec2> values, std::span<Vec2 const> pose) const;

 private:
  /// A constraint that holds, with what a unit force along it does to each unknown.
  struct Column {
    int constraint = 0;  // index into constraints_
    std::vector<double> response;
  };

  void number_unknowns();
  SparseCholesky factored(std::span<WireEdge const> edges) const;
  std::vector<double> response_to(WireConstraint const& constraint) const;
  double along(WireConstraint const& constraint, std::span<double const> response) const;
  void append(Column column);
  int component_of(Column const& column) const;
  std::vector<Vec2> free_moves(std::span<Vec2 const> values) const;
  /// The constraints' forces; the shift of each component, by its lowest vertex, goes to shifts.
  std::vector<Vec2> forces_on(std::span<Vec2 const> moves, std::span<Vec2 const> pose,
                              std::span<Vec2> shifts) const;

  std::vector<int> components_;
  std::vector<char> is_fixed_;
  std::vector<int> unknowns_;  // per vertex; -1: fixed
  int unknown_count_ = 0;
  std::vector<char> has_fixed_;           // per component, by its lowest vertex
  std::vector<char> is_held_;             // likewise
  std::optional<SparseCholesky> factor_;  // there once made
  std::vector<WireConstraint> constraints_;
  std::vector<Column> columns_;      // of those that hold; the last constraint first
  GrowingCholesky compliance_;       // what a unit force along one does along another
  std::vector<double> unit_forces_;  // its solution for ones
};

}  // namespace inkflate
