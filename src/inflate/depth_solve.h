// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "inflate/depth_rules.h"
#include "solvers/sparse_cholesky.h"

namespace inkflate {

/// The unknowns of all plates for which energy plus weighted squared violations of the rules is least.
///
/// Newton steps on this convex, piecewise quadratic sum: each step solves for the rules that are broken now; halved until the
/// sum falls. Exact once the same rules stay broken, and in any case done after a few dozen steps.
///
/// in      energy: the lower part of a positive definite form x^T E x
/// out     one number per unknown
/// source  Pinar, Zenios 1994 (smooth penalties); docs/algorithms/depth.md
std::vector<double> solve_depths(int unknown_count, std::span<MatrixEntry const> energy,
                                 std::span<DepthRule const> rules);

}  // namespace inkflate
