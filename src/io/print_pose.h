// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/tri_mesh.h"

namespace inkflate {

/// The model's mesh (y up) as it stands on a printer: z up, the front facing -y, the lowest point on z = 0, centred in x and y,
/// its longest side `longest_mm`. Parts that overlap stay so: for one clean shell see solidify/solidify.h.
///
/// in      model: finite. Where all points are one, nothing is scaled
TriMesh print_pose(TriMesh const& model, double longest_mm = 100);

}  // namespace inkflate
