// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "editor/pick.h"
#include "editor/scene_chunk.h"

namespace inkflate {

/// On the screen: the frame around the selection, with squares to pull and a knob to turn it by.
DrawList draw_frame(Frame const& frame, Affine const& to_screen);

/// The frame's chunk, kept from scene to scene: what is selected is measured again only when it, or the camera, has changed.
class FrameChunk {
 public:
  void add(Document const& document, View const& view, std::uint64_t& next_id,
           std::vector<SceneChunk>& chunks);

 private:
  Shared<std::vector<Shared<DocumentLayer>>> layers_;
  std::vector<LayerId> selection_;
  Camera camera_;
  ViewSize size_;
  SceneChunk chunk_;
};

}  // namespace inkflate
