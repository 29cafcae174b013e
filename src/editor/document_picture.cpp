// SPDX-License-Identifier: Apache-2.0
#include "editor/document_picture.h"

#include <algorithm>
#include <utility>

#include "editor/pick.h"
#include "editor/scene.h"

namespace inkflate {
namespace {

/// The document as the canvas shows it, fitted into a square.
Scene scene_of(Document const& document, int side_px) {
  double const side = std::clamp(side_px, kLeastPictureSidePx, kLargestPictureSidePx);
  View view;
  view.size = {side, side};
  view.camera = fitted(view.camera, view.size, box_of(document));
  view.has_grid = false;
  SceneBuilder builder;
  return builder.build({document, view, ToolIdle{}, {}, {}});
}

Shared<DocumentLayer> shown_unmarked(DocumentLayer layer) {
  layer.layer.is_hidden = false;
  layer.layer.choice = {};
  return std::make_shared<DocumentLayer const>(std::move(layer));
}

}  // namespace

Picture picture_of_layer(DocumentLayer const& layer, int side_px) {
  auto document = empty_document();
  document.layers =
      std::make_shared<std::vector<Shared<DocumentLayer>> const>(1, shown_unmarked(layer));
  auto scene = scene_of(document, side_px);
  scene.paper = {0, 0, 0, 0};
  return picture_of(scene);
}

Picture picture_of_document(Document const& document, int side_px) {
  auto unmarked = document;
  unmarked.choice = std::make_shared<CloseChoice const>();
  std::vector<Shared<DocumentLayer>> layers;
  for (auto const& layer : *document.layers) {
    if (!layer->layer.is_hidden) layers.push_back(shown_unmarked(*layer));
  }
  unmarked.layers = std::make_shared<std::vector<Shared<DocumentLayer>> const>(std::move(layers));
  return picture_of(scene_of(unmarked, side_px));
}

}  // namespace inkflate
