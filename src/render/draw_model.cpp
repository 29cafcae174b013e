// SPDX-License-Identifier: Apache-2.0
#include "render/draw_model.h"

#include "render/model_placement.h"

namespace inkflate {

DrawTriangles draw_model(RestModel const& model, Texture const* texture, ModelView const& view,
                         Shading shading, int width, int height) {
  auto const placement = model_placement(model, view, width, height);
  DrawTriangles list;
  list.triangles = model.mesh.triangles;
  list.shading = shading;
  if (shading == Shading::Textured && texture) {
    list.texture = &texture->picture;
    list.corners = texture->corners;
  }
  for (auto const p : model.mesh.points) list.positions.push_back(placement(p));
  for (auto const n : model.normals) list.normals.push_back(placement.turned(n));
  return list;
}

}  // namespace inkflate
