// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/scene_chunk.h"
#include "editor/scene_frame.h"
#include "editor/scene_grid.h"
#include "editor/scene_layers.h"
#include "editor/scene_strokes.h"

namespace inkflate {

/// What a SceneBuilder keeps from scene to scene, in the order in which it lies on the paper.
struct SceneCaches {
  GridChunk grid;
  ChunkSlot template_picture;
  LayerChunks layers;
  ChunkSlot preview_area;
  StrokeChunks loose;
  ChunkSlot preview_closings;
  ChunkSlot tool;
  HighlightChunks highlights;
  ChunkSlot marks;
  FrameChunk frame;
  ChunkSlot pins;
};

}  // namespace inkflate
