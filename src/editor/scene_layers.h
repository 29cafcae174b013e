// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "document/document.h"
#include "editor/scene_chunk.h"

namespace inkflate {

using LayerList = Shared<std::vector<Shared<DocumentLayer>>>;

/// How finely curves are drawn: a step finer for each factor 4 of the zoom from 4 on, so that no corner shows and zooming seldom draws
/// anything again.
int fineness_of(double zoom);

/// Chunks of all layers, kept from scene to scene. Hidden layers have none.
class LayerChunks {
 public:
  void update(LayerList const& layers, int fineness, std::uint64_t& next_id);

  /// Areas and lines back to front, then once more all lines, faint: what nearer areas hide shows through.
  std::vector<SceneChunk> const& closed() const { return closed_; }
  /// Outlines of before, pale, and rough strokes.
  std::vector<SceneChunk> const& open() const { return open_; }

 private:
  void add_closed(Shared<DocumentLayer> const& layer, int fineness, std::uint64_t& next_id);
  void add_hidden_ink(int fineness, std::uint64_t& next_id);
  void add_open(Shared<DocumentLayer> const& layer, int fineness, std::uint64_t& next_id);

  LayerList layers_;  // that the chunks show
  int fineness_ = 0;
  ChunkCache cache_;
  std::vector<SceneChunk> closed_;
  std::vector<SceneChunk> open_;
  std::vector<Shared<DocumentLayer>> shown_;  // the closed ones
};

/// Chunks of what marks layers as chosen, or as under the pointer.
class HighlightChunks {
 public:
  /// selection: ascending. The hovered layer comes first, thin; one that is also selected counts as selected.
  std::vector<SceneChunk> const& update(LayerList const& layers,
                                        std::vector<LayerId> const& selection, LayerId hover,
                                        int fineness, std::uint64_t& next_id);

 private:
  void add(Shared<DocumentLayer> const& layer, ChunkLook look, int fineness,
           std::uint64_t& next_id);

  LayerList layers_;
  std::vector<LayerId> selection_;
  LayerId hover_ = LayerId::None;
  int fineness_ = 0;
  ChunkCache cache_;
  std::vector<SceneChunk> chunks_;
};

}  // namespace inkflate
