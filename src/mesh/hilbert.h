// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "mesh/delaunay.h"

namespace inkflate {

/// The indices of the points in the order of a Hilbert curve; points at the same place stand together, in index order.
/// Neighbours in this order are near each other, so each insertion starts its walk next to its goal.
std::vector<int> hilbert_order(std::span<LatticePoint const> points);

}  // namespace inkflate
