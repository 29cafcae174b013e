// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_strokes.h"

#include <utility>

#include "base/hash.h"
#include "render/ink_line.h"
#include "render/palette.h"

namespace inkflate {
namespace {

/// What is far is pale, as hills are.
constexpr double kFarShare = 0.45;

constexpr std::size_t kFewestStrokes = 8;
constexpr std::size_t kMostStrokes = 64;
/// One stroke of so many ends its batch: with the fewest, 32 strokes on average.
constexpr std::uint64_t kCutEvery = 24;

bool ends_batch(KeptStroke const& kept) {
  Hash hash;
  hash.add(static_cast<std::int64_t>(kept.stroke.samples.size()));
  hash.add(kept.box.min.x);
  return (hash.value() >> 32U) % kCutEvery == 0;
}

DrawList draw_strokes(StrokeBatch const& batch) {
  DrawList list;
  list.reserve(batch.size());
  for (auto const& kept : batch) {
    if (!kept->stroke.samples.empty()) list.push_back(rough_line(kept->stroke));
  }
  return list;
}

}  // namespace

StrokedPolyline rough_line(Stroke const& stroke) {
  auto line = shown_line(stroke);
  if (stroke.depth == StrokeDepth::Far) line.colour = faded(line.colour, kFarShare);
  line.limits.least_px = kThinnestLinePx;
  return line;
}

std::vector<StrokeBatch> stroke_batches(StrokeList const& strokes) {
  std::vector<StrokeBatch> batches;
  bool is_ended = true;
  strokes.for_each([&](Shared<KeptStroke> const& kept) {
    if (is_ended) batches.emplace_back();
    auto& batch = batches.back();
    batch.push_back(kept);
    is_ended =
        (batch.size() >= kFewestStrokes && ends_batch(*kept)) || batch.size() >= kMostStrokes;
  });
  return batches;
}

void add_stroke_chunks(StrokeList const& strokes, ChunkCache& cache, std::uint64_t& next_id,
                       std::vector<SceneChunk>& chunks) {
  for (auto const& batch : stroke_batches(strokes)) {
    auto const& chunk = cache.chunk({ChunkLook::Strokes, 0, {batch.begin(), batch.end()}}, next_id,
                                    [&] { return draw_strokes(batch); });
    if (chunk.list) chunks.push_back(chunk);
  }
}

std::vector<SceneChunk> const& StrokeChunks::update(StrokeList const& strokes,
                                                    std::uint64_t& next_id) {
  if (strokes_.is_same(strokes)) return chunks_;
  chunks_.clear();
  add_stroke_chunks(strokes, cache_, next_id, chunks_);
  cache_.drop_unused();
  strokes_ = strokes;
  return chunks_;
}

}  // namespace inkflate
