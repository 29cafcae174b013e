// SPDX-License-Identifier: Apache-2.0
#include "inflate/inflate.h"

#include <utility>

#include "inflate/layer_depths.h"
#include "inflate/layer_heights.h"
#include "inflate/raise_sheets.h"
#include "inflate/shape_joints.h"
#include "inflate/vertex_normals.h"

namespace inkflate {
namespace {

/// Turns the canvas into the model: y up, its centre at the origin.
Vec3 turned(Vec2 centre, Vec3 p) { return {p.x - centre.x, centre.y - p.y, p.z}; }

/// Front sheets are seen from the viewer, whose y points the other way: there the corners change their order.
Triangle oriented(Triangle const& corners, Side side) {
  return side == Side::Front ? Triangle{corners[0], corners[2], corners[1]} : corners;
}

void add_faces(FlatModel const& model, RestModel& rest) {
  for (int i = 0; i < static_cast<int>(std::ssize(model.layers)); ++i) {
    auto const& layer = model.layers[i];
    rest.layer_names.push_back(layer.name);
    for (auto const side : {Side::Front, Side::Back}) {
      for (auto const& corners : layer.sheets[static_cast<int>(side)]) {
        rest.mesh.triangles.push_back(oriented(corners, side));
        rest.faces.push_back({i, side});
      }
    }
    for (auto const& cap : model.caps) {
      if (cap.face.layer != i) continue;
      rest.mesh.triangles.push_back(cap.corners);
      rest.faces.push_back(cap.face);
    }
  }
}

}  // namespace

Result<RestModel> inflate(FlatModel const& model, Progress const& progress) {
  Error const cancelled = {ErrorCode::Cancelled, "stopped"};
  if (!progress.enter("inflate")) return cancelled;
  std::vector<std::vector<double>> heights;
  for (auto const& layer : model.layers) heights.push_back(layer_heights(layer));
  if (!progress.enter("order")) return cancelled;
  auto const depths = layer_depths(model, heights);
  if (!progress.enter("shape")) return cancelled;
  auto raised = raise_sheets(model, heights, depths);
  RestModel rest;
  rest.width_px = model.width_px;
  rest.height_px = model.height_px;
  add_faces(model, rest);
  shape_joints(model, rest.mesh.triangles, raised);
  for (auto const p : raised) rest.canvas.push_back({p.x, p.y});
  Vec2 const centre = {model.width_px / 2, model.height_px / 2};
  for (auto const p : raised) rest.mesh.points.push_back(turned(centre, p));
  rest.normals = vertex_normals(rest.mesh);
  return rest;
}

}  // namespace inkflate
