// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "document/document.h"
#include "editor/scene_caches.h"
#include "editor/scene_chunk.h"
#include "editor/tool.h"
#include "editor/view.h"
#include "image/grid2.h"
#include "model/rest_model.h"
#include "pipeline/close_document.h"

namespace inkflate {

/// The model, to be drawn over the paper.
struct ModelScene {
  std::uint64_t id = 0;  // of mesh and texture
  Shared<RestModel> model;
  Shared<Texture> texture;
  ModelView view;
  Shading shading = Shading::Textured;
};

/// What the window shows, back to front.
struct Scene {
  ViewSize size;
  Affine canvas_to_screen;
  Colour paper;
  std::vector<SceneChunk> chunks;
  std::optional<ModelScene> model;
};

/// What a scene is made of.
struct SceneInput {
  Document const& document;  // with the gesture under way
  View const& view;
  ToolState const& tool;
  ShapePreview const& preview;
  std::optional<ModelScene> model;
};

/// Makes scenes, and keeps the draw lists of layers and strokes that have not changed: docs/algorithms/scene.md.
///
/// Whatever the view's numbers are, what comes out is finite. Ids ascend from 1 and never come again for other content; caches hold
/// what the last scene shows, and no more.
class SceneBuilder {
 public:
  /// cost    O(chunks) when nothing changed; else what changed
  Scene build(SceneInput const& input);

 private:
  void add_drawing(SceneInput const& input, View const& view, Scene& scene);

  std::uint64_t next_id_ = 1;
  SceneCaches caches_;
};

/// The scene as a picture, without a window or GPU: 0 .. 16384 px each way. The model stands over its soft shadow.
///
/// cost    that of rasterise and rasterise_model
Picture picture_of(Scene const& scene);

}  // namespace inkflate
