// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "document/document.h"
#include "editor/tool.h"
#include "editor/view.h"
#include "image/grid2.h"
#include "model/rest_model.h"
#include "pipeline/close_document.h"
#include "render/draw_list.h"

namespace inkflate {

enum class SceneSpace { Canvas, Screen };

/// Things to draw that change together. A studio keeps what it made of a chunk for as long as its id comes again.
struct SceneChunk {
  std::uint64_t id = 0;  // another content has another id
  SceneSpace space = SceneSpace::Canvas;
  Shared<DrawList> list;
};

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

/// Makes scenes, and keeps the draw lists of layers and strokes that have not changed.
class SceneBuilder {
 public:
  /// cost    O(chunks) when nothing changed; else what changed
  Scene build(SceneInput const& input);
};

/// The scene as a picture, without a window or GPU.
Picture picture_of(Scene const& scene);

}  // namespace inkflate
