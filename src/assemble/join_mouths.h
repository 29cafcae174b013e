// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assemble/layer_rim.h"

namespace inkflate {

/// Brings two open runs of different layers together if they nearly meet face to face: both become the line half-way between them, and the
/// rims beside them follow smoothly.
///
/// out     whether they meet; then run_b has the points of run_a, backwards. Else nothing has changed
bool bring_together(LayerRim& a, int run_a, LayerRim& b, int run_b);

}  // namespace inkflate
