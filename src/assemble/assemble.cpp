// SPDX-License-Identifier: Apache-2.0
#include "assemble/assemble.h"

#include <utility>

#include "assemble/drawing_rims.h"
#include "assemble/mesh_layers.h"
#include "assemble/plan_joints.h"
#include "assemble/stitch.h"

namespace inkflate {
namespace {

std::optional<Error> find_fault(Drawing const& drawing, AssembleOptions const& options) {
  if (!(options.density >= 0.1 && options.density <= 10)) {
    return Error{ErrorCode::BadOption, "the density has to be from 0.1 to 10"};
  }
  if (drawing.layers.empty()) {
    return Error{ErrorCode::NothingThere, "the drawing has no closed shape to inflate"};
  }
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    auto const& layer = drawing.layers[i];
    auto const index = static_cast<long long>(i);
    if (layer.outlines.empty() || layer.outlines.front().pieces.empty()) {
      return Error{ErrorCode::BadInput, "layer \"" + layer.name + "\" has no outline", index};
    }
    if (!(layer.thickness >= 0.1 && layer.thickness <= 32)) {
      return Error{ErrorCode::BadInput,
                   "the thickness of layer \"" + layer.name + "\" is not from 0.1 to 32", index};
    }
  }
  return std::nullopt;
}

/// The open runs as they are, joined to nothing.
void keep_unjoined(std::vector<LayerRim> const& planned, std::vector<LayerRim>& rims) {
  for (std::size_t i = 0; i < rims.size(); ++i) {
    for (std::size_t r = 0; r < rims[i].runs.size(); ++r) {
      rims[i].runs[r].opening = planned[i].runs[r].opening;
    }
  }
}

/// Takes the joints off a host whose mesh cannot have them: their runs are capped. False: it had none.
bool drop_joints_of(int host, std::vector<PlannedJoint>& plan) {
  return std::erase_if(plan, [&](PlannedJoint const& joint) { return joint.host == host; }) > 0;
}

/// Rather a character in two pieces than none at all.
Result<MeshedLayers> mesh_what_can_be(std::span<LayerRim const> rims,
                                      std::vector<PlannedJoint>& plan, double unit_px,
                                      double density) {
  auto meshed = mesh_layers(rims, plan, unit_px, density);
  while (!meshed && drop_joints_of(static_cast<int>(meshed.error().index), plan)) {
    meshed = mesh_layers(rims, plan, unit_px, density);
  }
  return meshed;
}

}  // namespace

Result<FlatModel> assemble(Drawing const& drawing, AssembleOptions const& options,
                           Progress const& progress) {
  Error const cancelled = {ErrorCode::Cancelled, "stopped"};
  if (auto const fault = find_fault(drawing, options)) return *fault;
  if (!progress.enter("join")) return cancelled;
  double const unit_px = drawing_unit(drawing);
  if (!(unit_px > 0))
    return Error{ErrorCode::NothingThere, "the drawing's outlines are a single point"};
  auto rims = drawing_rims(drawing, unit_px);
  auto joined = rims;
  auto plan = plan_joints(joined, unit_px);
  if (options.open == OpenRuns::Capped) {
    keep_unjoined(joined, rims);
    plan.clear();
  } else {
    rims = std::move(joined);
  }
  if (!progress.enter("mesh")) return cancelled;
  auto meshed = mesh_what_can_be(rims, plan, unit_px, options.density);
  if (!meshed) return meshed.error();
  if (!progress.enter("stitch")) return cancelled;
  auto model = stitch(std::move(*meshed), options.open);
  model.width_px = drawing.sketch.width_px;
  model.height_px = drawing.sketch.height_px;
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    model.layers[i].name = drawing.layers[i].name;
    model.layers[i].thickness = drawing.layers[i].thickness;
  }
  return model;
}

}  // namespace inkflate
