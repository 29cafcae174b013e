// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "inflate/depth_rules.h"
#include "solvers/sparse_cholesky.h"

namespace inkflate {

/// The unknowns of all plates for which energy plus weighted squared violations of the rules is least.
///
/// Equalities become part of the energy, which is factored once. The inequalities are found one by one: the worst broken one of each
/// pair of layers starts to push, those that would have to pull are let go, until none is broken by more than a hundredth of a px.
///
/// in      energy: the lower part of a positive definite form 1/2 x^T E x; rules: those of a group stand together
/// out     one number per unknown; finite. What cannot be fulfilled together ends in a compromise
/// cost    one factorisation; one back-substitution for each rule that comes to push
/// source  Lawson, Hanson, "Solving Least Squares Problems", 1974, chapter 23, on the dual problem; docs/algorithms/depth.md
std::vector<double> solve_depths(int unknown_count, std::vector<MatrixEntry> energy,
                                 std::span<DepthRule const> rules);

}  // namespace inkflate
