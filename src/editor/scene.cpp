// SPDX-License-Identifier: Apache-2.0
#include "editor/scene.h"

#include <algorithm>
#include <cmath>

#include "document/apply.h"
#include "editor/scene_guides.h"
#include "editor/scene_pins.h"
#include "render/palette.h"

namespace inkflate {
namespace {

/// As large as a picture may be.
constexpr double kLargestSidePx = 16384;

double side_px(double value) {
  return std::isfinite(value) ? std::clamp(value, 0.0, kLargestSidePx) : 0;
}

/// The view, whatever it is, as one that can be drawn.
View drawable(View view) {
  view.size.width_px = side_px(view.size.width_px);
  view.size.height_px = side_px(view.size.height_px);
  auto& camera = view.camera;
  if (!is_finite(camera.centre) || !std::isfinite(camera.zoom)) camera = Camera{};
  camera.zoom = std::clamp(camera.zoom, Camera::kLeastZoom, Camera::kLargestZoom);
  auto const within = [](double value) {
    return std::clamp(value, -DocumentLimits::kFarthestPx, DocumentLimits::kFarthestPx);
  };
  camera.centre = {within(camera.centre.x), within(camera.centre.y)};
  return view;
}

bool is_drawable(ModelView const& view) {
  return std::isfinite(view.turn_rad) && std::isfinite(view.tilt_rad) && std::isfinite(view.zoom) &&
         view.zoom > 0 && is_finite(view.pan_px);
}

void add(std::vector<SceneChunk>& chunks, std::vector<SceneChunk> const& upper) {
  chunks.insert(chunks.end(), upper.begin(), upper.end());
}

}  // namespace

Scene SceneBuilder::build(SceneInput const& input) {
  auto const view = drawable(input.view);
  Scene scene;
  scene.size = view.size;
  scene.canvas_to_screen = canvas_to_screen(view.camera, view.size);
  scene.paper = palette::kPaper;
  if (view.has_grid) {
    scene.chunks.push_back(caches_.grid.update(grid_lines(view.camera, view.size), next_id_));
  }
  if (view.mode == Mode::Draw) {
    add_drawing(input, view, scene);
    return scene;
  }
  auto const grid = caches_.grid;
  caches_ = {};
  caches_.grid = grid;
  scene.model = input.model;
  if (scene.model && !is_drawable(scene.model->view)) scene.model->view = ModelView{};
  return scene;
}

void SceneBuilder::add_drawing(SceneInput const& input, View const& view, Scene& scene) {
  auto const& document = input.document;
  auto& chunks = scene.chunks;
  int const fineness = fineness_of(view.camera.zoom);
  auto const slot = [&](ChunkSlot& kept, DrawList list, SceneSpace space) {
    kept.add(std::move(list), space, next_id_, chunks);
  };
  slot(caches_.template_picture, draw_template(document), SceneSpace::Canvas);
  caches_.layers.update(document.layers, fineness, next_id_);
  add(chunks, caches_.layers.closed());
  slot(caches_.preview_area, draw_preview_area(input.preview), SceneSpace::Canvas);
  add(chunks, caches_.layers.open());
  add(chunks, caches_.loose.update(document.loose, next_id_));
  slot(caches_.preview_closings, draw_preview_closings(input.preview), SceneSpace::Canvas);
  slot(caches_.tool, draw_tool(input.tool), SceneSpace::Canvas);
  add(chunks,
      caches_.highlights.update(document.layers, view.selection, view.hover, fineness, next_id_));
  slot(caches_.marks, draw_marks(document, view), SceneSpace::Screen);
  if (view.tool == Tool::Select) caches_.frame.add(document, view, next_id_, chunks);
  slot(caches_.pins, draw_pins(document, view, input.tool), SceneSpace::Screen);
}

}  // namespace inkflate
