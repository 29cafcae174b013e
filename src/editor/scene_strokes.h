// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "document/document.h"
#include "editor/scene_chunk.h"

namespace inkflate {

/// The narrowest line that a scene shows, px of the screen: so that ink does not fade away where the paper is far.
inline constexpr double kThinnestLinePx = 0.75;

/// A stroke as it is seen while nothing is closed: far ones pale, help lines dashed. At least one sample.
StrokedPolyline rough_line(Stroke const& stroke);

using StrokeBatch = std::vector<Shared<KeptStroke>>;

/// The list cut into batches of about 32. Where it is cut depends on the strokes around the cut alone: when one is added, erased or replaced,
/// all batches but one or two stay what they were.
std::vector<StrokeBatch> stroke_batches(StrokeList const& strokes);

/// Puts the chunks of all batches at the end.
void add_stroke_chunks(StrokeList const& strokes, ChunkCache& cache, std::uint64_t& next_id,
                       std::vector<SceneChunk>& chunks);

/// Chunks of one list of strokes, kept from scene to scene.
class StrokeChunks {
 public:
  std::vector<SceneChunk> const& update(StrokeList const& strokes, std::uint64_t& next_id);

 private:
  StrokeList strokes_;  // that the chunks show
  ChunkCache cache_;
  std::vector<SceneChunk> chunks_;
};

}  // namespace inkflate
