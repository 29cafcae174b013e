// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "image/grid2.h"
#include "mesh/tri_mesh.h"
#include "model/flat_model.h"

namespace inkflate {

/// The inflated character in its rest pose.
struct RestModel {
  TriMesh mesh;  // px: x to the right, y up, z to the viewer; the canvas' centre is (0, 0, 0)
  std::vector<Vec3> normals;  // of length 1, one per vertex
  std::vector<Vec2> canvas;   // per vertex the place on the canvas where it was drawn, px, y down
  std::vector<Face> faces;    // per triangle; layers in order, so those of a layer stand together
  std::vector<std::string> layer_names;
  double width_px = 0;  // of the canvas
  double height_px = 0;
};

/// A picture to wear and where on it each triangle lies.
struct Texture {
  Picture picture;
  std::vector<std::array<Vec2, 3>>
      corners;  // per triangle and corner: u to the right, v down, 0 .. 1
};

}  // namespace inkflate
