// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_strokes.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

StrokeList strokes(int count, bool is_random) {
  Rng rng(11);
  std::vector<Shared<KeptStroke>> kept;
  for (int i = 0; i < count; ++i) {
    double const x = is_random ? rng.uniform(0, 1000) : 5;
    kept.push_back(keep(line_stroke({{x, 1}, {x + 5, 9}})));
  }
  return StrokeList::of(kept);
}

TEST(SceneStrokes, BatchesAreTheListInOrder) {
  for (bool const is_random : {true, false}) {
    auto const list = strokes(1000, is_random);
    std::vector<Shared<KeptStroke>> all;
    for (auto const& batch : stroke_batches(list)) {
      EXPECT_LE(batch.size(), 64U);
      all.insert(all.end(), batch.begin(), batch.end());
    }
    EXPECT_EQ(all, list.to_vector());
  }
  EXPECT_TRUE(stroke_batches({}).empty());
}

TEST(SceneStrokes, BatchesHoldAbout32) {
  auto const batches = stroke_batches(strokes(6400, true));
  EXPECT_GT(batches.size(), 150U);
  EXPECT_LT(batches.size(), 270U);
}

TEST(SceneStrokes, AStrokeWithoutSamplesDrawsNothing) {
  ChunkCache cache;
  std::uint64_t next_id = 1;
  std::vector<SceneChunk> chunks;
  add_stroke_chunks(StrokeList().with_pushed(keep({})), cache, next_id, chunks);
  EXPECT_TRUE(chunks.empty());
  EXPECT_EQ(next_id, 1U);
}

}  // namespace
}  // namespace inkflate
