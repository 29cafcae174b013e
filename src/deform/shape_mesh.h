// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deform/bend_mesh.h"

namespace inkflate {

/// Which line of a shape a BendLine was made from.
struct BendLineOrigin {
  int index = 0;                   // of the outline, or of the line where the shape has no outlines
  std::vector<double> parameters;  // per vertex where on it (deform/line_samples.h); ascending
};

/// A mesh to bend and what its lines are.
struct ShapeMesh {
  BendMesh mesh;
  std::vector<BendLineOrigin> origins;  // one per BendMesh::lines
  bool is_filled = false;               // what lies inside of the outlines is meshed, not strips
  // Per triangle the sheet that it is in, smaller ones first, where the shape lies over itself; empty: it does not.
  std::vector<int> sheets;
};

}  // namespace inkflate
