// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "solidify/solid.h"

namespace inkflate {

/// Finds for each node the side on which it is. Voids that cannot be reached from outside are filled; crumbs that broke off because the
/// model is too thin there to be seen go.
///
/// in      solid: all but ball_of_node and sides
///         shell_of_triangle: which connected piece of the model each triangle belongs to, from 0
/// cost    O(nodes + sum of the balls' volumes)
void label_nodes(Solid& solid, std::span<int const> shell_of_triangle);

}  // namespace inkflate
