// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simplify/fit_rim.h"
#include "simplify/work_space.h"

namespace inkflate {

/// Fits all rims of a sketch together so that no outline crosses itself or another one: each is drawn as smoothly as that allows.
///
/// in      rims: as trace_rims gives them; centred: their positions by centre_rim
/// out     one outline per rim, in canvas px. Every outline is simple, as its polygons within 0.01 and 0.2 work px of it show; two
///         may touch only where their rims share a sample
/// cost    O(n log n); more only where outlines had to be drawn again
std::vector<Outline> fit_rims(std::vector<Rim> const& rims, std::vector<Contour> const& centred,
                              StrokeSamples const& samples, WorkSpace const& space, double smooth);

}  // namespace inkflate
