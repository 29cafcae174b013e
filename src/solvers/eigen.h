// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Eigen as this project uses it.

/// Out of memory ends the program: without exceptions, Eigen asks for more than there can be. Said here, for the sake of checkers.
namespace Eigen::internal {
[[noreturn]] inline void throw_std_bad_alloc();
}

// Vectors would sum in an order that depends on the machine.
#define EIGEN_DONT_VECTORIZE  // NOLINT(cppcoreguidelines-macro-usage): Eigen asks for it
#include <Eigen/SparseCholesky>
