// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assemble/assemble.h"
#include "assemble/mesh_layers.h"
#include "model/flat_model.h"

namespace inkflate {

/// Numbers the vertices of the model. A layer's sheets share its drawn rim. At a slit the host's sheet is cut along the seam: the lip on the
/// limb's far side goes on into the limb's sheet of the same side, the lip under the limb into the other one. At a mouth both sheets go on.
/// Open runs that join nothing are closed by a flat wall, unless `open` asks for holes.
///
/// out     the sheets' vertices as one closed 2-manifold (OpenRuns::Holes apart); vertices in the order in which the layers first use them
/// cost    O(n)
FlatModel stitch(MeshedLayers layers, OpenRuns open);

}  // namespace inkflate
