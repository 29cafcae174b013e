// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solidify/march.h"

namespace inkflate {

/// Rounds the creases in which shells meet, where the lattice leaves teeth, within about two steps; and evens out what was made of balls.
/// Edges of the model that stick out stay, and so do points on the base.
///
/// in      base: the k on which the mesh stands if it has a flat base; lattice units
/// out     no triangles cross that did not before
/// cost    O(n log n)
/// source  Taubin 1995, "A signal processing approach to fair surface design", for the balls: it does not shrink them
void smooth_creases(MarchedMesh& marched, double base);

}  // namespace inkflate
