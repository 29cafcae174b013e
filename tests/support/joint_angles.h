// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/flat_model.h"
#include "model/rest_model.h"

namespace inkflate {

/// The largest angle between the normals of two neighbouring faces, of all edges whose middle lies within reach_px of an end of a joint.
/// Degrees; 0 without joints.
double largest_angle_at_joints(FlatModel const& flat, RestModel const& model, double reach_px);

}  // namespace inkflate
