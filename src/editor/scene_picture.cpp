// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "editor/scene.h"
#include "render/rasterise.h"
#include "render/rasterise_model.h"

namespace inkflate {
namespace {

constexpr int kLargestSidePx = 16384;

int pixels(double side_px) {
  if (!(side_px > 0)) return 0;
  return side_px < kLargestSidePx ? static_cast<int>(std::ceil(side_px)) : kLargestSidePx;
}

DrawnPicture picture_of_model(ModelScene const& model, int width, int height) {
  auto const list =
      draw_model(*model.model, model.texture.get(), model.view, model.shading, width, height);
  ModelPictureOptions options;
  options.shadow = GroundShadow::On;
  return {std::make_shared<Picture const>(rasterise_model(list, width, height, options)), {}, 1};
}

}  // namespace

Picture picture_of(Scene const& scene) {
  int const width = pixels(scene.size.width_px);
  int const height = pixels(scene.size.height_px);
  DrawList list;
  for (auto const& chunk : scene.chunks) {
    auto placed = chunk.space == SceneSpace::Canvas ? place(*chunk.list, scene.canvas_to_screen)
                                                    : *chunk.list;
    list.insert(list.end(), std::make_move_iterator(placed.begin()),
                std::make_move_iterator(placed.end()));
  }
  if (scene.model && scene.model->model) {
    list.push_back(picture_of_model(*scene.model, width, height));
  }
  return rasterise(list, width, height, scene.paper);
}

}  // namespace inkflate
