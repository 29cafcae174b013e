// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "assemble/plan_joints.h"
#include "base/result.h"
#include "model/flat_model.h"

namespace inkflate {

/// An open run of a meshed layer.
struct OpenRim {
  int layer = 0;
  int run = 0;                // of the layer's rim
  std::vector<int> vertices;  // of the layer's mesh, in outline order, with both ends
};

/// The layers as meshes, not yet stitched: names and sheets are still empty.
struct MeshedLayers {
  std::vector<FlatLayer> layers;
  std::vector<OpenRim> open_rims;
  std::vector<Joint> joints;  // in the order of the plan
};

/// Meshes every layer; a joint's run has the same points in the limb's and in the host's mesh.
///
/// in      rims, plan: of plan_joints; unit_px: a thousandth of the drawing's size; density: triangles per area, 1 is the default
/// errors  BadInput (an outline crosses itself; index: the layer)
/// cost    that of mesh_region
Result<MeshedLayers> mesh_layers(std::span<LayerRim const> rims, std::span<PlannedJoint const> plan,
                                 double unit_px, double density);

}  // namespace inkflate
