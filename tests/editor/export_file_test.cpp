// SPDX-License-Identifier: Apache-2.0
#include "editor/export_file.h"

#include <gtest/gtest.h>

#include "io/read_document.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

Document disc() { return with_disc(empty_document(), {500, 500}, 100); }

Result<std::vector<FileOut>> exported(Document const& document, std::string extension,
                                      ModelCache& cache, Progress const& progress = {},
                                      View const& view = {}) {
  return export_file({document, view, "mouse", std::move(extension)}, cache, progress);
}

TEST(ExportFile, ModelsCanBeStoppedAtEveryStage) {
  auto const document = disc();
  View inflated;
  inflated.mode = Mode::Inflate;
  for (auto const* const extension : {"glb", "stl", "png"}) {
    int stages = 0;
    ModelCache whole;
    ASSERT_TRUE(exported(document, extension, whole, {[&](auto) { ++stages; }, {}}, inflated));
    EXPECT_GT(stages, 1);
    for (int stop = 0; stop < stages; ++stop) {
      int seen = 0;
      ModelCache cache;
      auto const files =
          exported(document, extension, cache, {{}, [&] { return seen++ == stop; }}, inflated);
      ASSERT_FALSE(files) << extension << ", stage " << stop;
      EXPECT_EQ(files.error().code, ErrorCode::Cancelled);
      EXPECT_FALSE(files.error().message.empty());
    }
  }
}

TEST(ExportFile, AStoppedModelIsMadeTheNextTime) {
  auto const document = disc();
  ModelCache cache;
  EXPECT_FALSE(exported(document, "glb", cache, {{}, [] { return true; }}));
  EXPECT_FALSE(cache.is_current(document));
  EXPECT_TRUE(exported(document, "glb", cache));
  EXPECT_TRUE(cache.is_current(document));
}

TEST(ExportFile, WithoutAPartThereIsNoModelHoweverOftenItIsWanted) {
  auto const document = empty_document();
  ModelCache cache;
  View inflated;
  inflated.mode = Mode::Inflate;
  for (auto const* const extension : {"glb", "stl", "png"}) {
    for (int time = 0; time < 2; ++time) {
      auto const files = exported(document, extension, cache, {}, inflated);
      ASSERT_FALSE(files) << extension;
      EXPECT_EQ(files.error().code, ErrorCode::NothingThere);
      EXPECT_FALSE(files.error().message.empty());
    }
  }
}

TEST(ExportFile, WhatHasLeftTheSheetIsNotCutOff) {
  ModelCache cache;
  auto const far = with_disc(empty_document(), {-300, 1500}, 100);
  auto const files = exported(far, "svg", cache);
  ASSERT_TRUE(files);
  auto const read = read_document(files->front().bytes);
  ASSERT_TRUE(read);
  auto const& sketch = read->project.drawing.sketch;
  ASSERT_FALSE(sketch.strokes.empty());
  for (auto const& stroke : sketch.strokes) {
    for (auto const& sample : stroke.samples) {
      EXPECT_GE(sample.position.x, 0);
      EXPECT_LE(sample.position.y, sketch.height_px);
    }
  }
}

TEST(ExportFile, OtherExtensionsAreRefused) {
  ModelCache cache;
  for (auto const* const extension : {"", "fbx", ".png", "a very long name of an extension"}) {
    auto const files = exported(disc(), extension, cache);
    ASSERT_FALSE(files) << extension;
    EXPECT_EQ(files.error().code, ErrorCode::BadOption);
  }
}

TEST(ExportFile, AModelThatWearsItsPictureIsNotTheOneThatWearsItsInk) {
  auto bare = disc();
  auto dressed = bare;
  dressed.template_picture = std::make_shared<Picture const>(8, 8, Colour{200, 30, 30});
  ModelCache cache;
  auto const ink = exported(bare, "glb", cache);
  EXPECT_FALSE(cache.is_current(dressed));
  auto const picture = exported(dressed, "glb", cache);
  ASSERT_TRUE(ink && picture);
  EXPECT_NE(ink->front().bytes, picture->front().bytes);
}

}  // namespace
}  // namespace inkflate
