// SPDX-License-Identifier: Apache-2.0
#include "document/document.h"

#include <gtest/gtest.h>

#include <limits>

#include "document/apply.h"
#include "support/editor_documents.h"
#include "support/random_commands.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Project two_layers() {
  Project project;
  auto& drawing = project.drawing;
  drawing.sketch.width_px = 100;
  drawing.sketch.height_px = 80;
  for (int i = 0; i < 5; ++i) {
    drawing.sketch.strokes.push_back(line_stroke({{i * 10.0, 0}, {i * 10.0, 50}}));
  }
  Layer back;
  back.name = "back";
  back.outlines = {circle_outline({50, 50}, 20)};
  back.strokes = {4, 1};
  back.id = LayerId{2};
  back.outlines.front().sources = {{0, 1, 4, 0, 1}, {1, 2, 3, 0, 1}, {2, 3, -1, 0, 0}};
  Layer front;
  front.name = "front";
  front.strokes = {1, 3};
  front.details = {0};
  front.id = LayerId{1};
  front.is_open = true;
  drawing.layers = {back, front};
  project.next_id = 4;
  project.pins = {{PinId{3}, LayerId{1}, Side::Back, {1, 2}, {3, 4}}};
  project.clip = {2, {{PinId{3}, {{0, {1, 1}}, {2, {2, 2}}}, 0.5}}};
  return project;
}

TEST(Document, EmptyOneIsBlankAndAnEmptyProject) {
  auto const document = empty_document();
  EXPECT_TRUE(is_blank(document));
  auto const project = to_project(document);
  EXPECT_EQ(project.drawing.sketch.width_px, 1000);
  EXPECT_TRUE(project.drawing.layers.empty());
  auto const again = make_document(project);
  ASSERT_TRUE(again);
  EXPECT_EQ(to_project(*again), project);
}

TEST(Document, WhatAHandHasMadeIsNotBlank) {
  EXPECT_FALSE(is_blank(with_loose(empty_document(), circle_stroke({0, 0}, 5))));
  EXPECT_FALSE(is_blank(with_disc(empty_document(), {0, 0}, 5)));
  auto const marked = inkflate::apply(empty_document(), SetChoice{{}, {{}, {{1, 1}}, {}}});
  ASSERT_TRUE(marked);
  EXPECT_FALSE(is_blank(*marked));
}

TEST(Document, KeptStrokeKnowsItsBox) {
  auto const kept = keep(line_stroke({{3, 9}, {-1, 4}}));
  EXPECT_EQ(kept->box, (Rect{{-1, 4}, {3, 9}}));
}

TEST(MakeDocument, LayersHaveTheirStrokesInDrawingOrder) {
  auto const document = make_document(two_layers());
  ASSERT_TRUE(document);
  auto const& back = *find_layer(*document, LayerId{2});
  ASSERT_EQ(back.strokes.size(), 2);
  EXPECT_EQ(back.strokes[0]->stroke.samples.front().position.x, 10);
  EXPECT_EQ(back.layer.strokes, (std::vector<int>{1, 0}));
}

TEST(MakeDocument, StrokesOfSeveralLayersGoToTheFirst) {
  auto const document = make_document(two_layers());
  ASSERT_TRUE(document);
  auto const& front = *find_layer(*document, LayerId{1});
  EXPECT_EQ(front.strokes.size(), 2);
  EXPECT_EQ(front.layer.strokes, std::vector<int>{1});
  EXPECT_EQ(front.layer.details, std::vector<int>{0});
}

TEST(MakeDocument, SourcesOfStrokesOfOtherLayersLoseThem) {
  auto const document = make_document(two_layers());
  ASSERT_TRUE(document);
  auto const& sources = find_layer(*document, LayerId{2})->layer.outlines.front().sources;
  EXPECT_EQ(sources[0].stroke, 1);
  EXPECT_EQ(sources[1].stroke, -1);
  EXPECT_EQ(sources[2].stroke, -1);
}

TEST(MakeDocument, WhatNoLayerNamesIsLoose) {
  auto const document = make_document(two_layers());
  ASSERT_TRUE(document);
  ASSERT_EQ(document->loose.size(), 1);
  EXPECT_EQ(document->loose[0]->stroke.samples.front().position.x, 20);
}

TEST(MakeDocument, LayersWithoutIdGetOne) {
  auto project = two_layers();
  project.drawing.layers.emplace_back();
  auto const document = make_document(project);
  ASSERT_TRUE(document);
  EXPECT_EQ(document->layers->back()->layer.id, LayerId{4});
  EXPECT_EQ(document->next_id, 5);
  EXPECT_EQ(layer_index(*document, LayerId{4}), 2);
}

TEST(Document, ProjectAndDocumentHoldTheSame) {
  auto const document = make_document(two_layers());
  ASSERT_TRUE(document);
  auto const project = to_project(*document);
  auto const again = make_document(project);
  ASSERT_TRUE(again);
  EXPECT_EQ(to_project(*again), project);
  EXPECT_EQ(project.pins, two_layers().pins);
  EXPECT_EQ(project.clip, two_layers().clip);
}

TEST(Document, RandomProjectsAreStable) {
  Rng rng(3);
  for (int i = 0; i < 200; ++i) {
    auto const project = to_project(test::random_document(rng));
    auto const again = make_document(project);
    ASSERT_TRUE(again);
    ASSERT_EQ(to_project(*again), project);
  }
}

TEST(ShownDrawing, LeavesOutHiddenLayersThoseWithoutOutlinesAndLooseStrokes) {
  auto document = with_disc(empty_document(), {50, 50}, 9, "hidden");
  document = with_changed(document, LayerId{1}, [](Layer& layer) { layer.is_hidden = true; });
  document = with_disc(document, {50, 50}, 20, "shown");
  document = with_open(document, {circle_stroke({0, 0}, 5)});
  document = with_loose(document, circle_stroke({0, 0}, 7));
  auto const drawing = shown_drawing(document);
  ASSERT_EQ(drawing.layers.size(), 1U);
  EXPECT_EQ(drawing.layers.front().name, "shown");
  EXPECT_EQ(drawing.layers.front().strokes, std::vector<int>{0});
  EXPECT_EQ(drawing.sketch.strokes.size(), 1U);
  EXPECT_TRUE(drawing.stray.empty());
}

TEST(Document, UnknownLayerIsNotFound) {
  EXPECT_EQ(find_layer(empty_document(), LayerId{1}), nullptr);
  EXPECT_FALSE(layer_index(empty_document(), LayerId::None));
}

using Spoil = void (*)(Project&);

/// What make_document refuses, and why.
struct BadProject {
  Spoil spoil;
  ErrorCode code;
  long long index;
};

TEST(MakeDocument, RefusesWhatDoesNotFitTogether) {
  static constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  BadProject const cases[] = {
      {[](Project& p) { p.drawing.layers[1].strokes = {5}; }, ErrorCode::BadInput, 1},
      {[](Project& p) { p.drawing.layers[0].noise = {-1}; }, ErrorCode::BadInput, 0},
      {[](Project& p) { p.drawing.layers[0].outlines[0].sources[0].stroke = 5; },
       ErrorCode::BadInput, 0},
      {[](Project& p) { p.drawing.layers[0].outlines[0].sources[0].to = not_a_number; },
       ErrorCode::BadInput, 0},
      {[](Project& p) { p.drawing.layers[0].outlines[0].pieces.pop_back(); }, ErrorCode::BadInput,
       0},
      {[](Project& p) { p.drawing.layers[0].outlines[0].pieces[0].curve.control[1].x = 1e300; },
       ErrorCode::BadInput, 0},
      {[](Project& p) { p.drawing.layers[1].thickness = 0; }, ErrorCode::BadOption, 1},
      {[](Project& p) { p.drawing.layers[1].name = "\xff"; }, ErrorCode::BadOption, 1},
      {[](Project& p) { p.drawing.layers[1].id = LayerId{2}; }, ErrorCode::BadInput, 1},
      {[](Project& p) { p.drawing.layers[1].id = LayerId{4}; }, ErrorCode::BadInput, 1},
      {[](Project& p) { p.drawing.layers[1].id = LayerId{-1}; }, ErrorCode::BadInput, 1},
      {[](Project& p) { p.drawing.stray = {5}; }, ErrorCode::BadInput, 5},
      {[](Project& p) { p.drawing.sketch.strokes[2].samples[0].position.y = not_a_number; },
       ErrorCode::BadInput, 2},
      {[](Project& p) { p.drawing.sketch.strokes[2].group = 0; }, ErrorCode::BadInput, 2},
      {[](Project& p) { p.drawing.sketch.width_px = not_a_number; }, ErrorCode::BadInput, -1},
      {[](Project& p) {
         p.drawing.sketch.groups = {{"g", {}, 99}};
       },
       ErrorCode::BadOption, -1},
      {[](Project& p) { p.drawing.sketch.groups = {{"\xff"}}; }, ErrorCode::BadInput, -1},
      {[](Project& p) { p.drawing.choice.gap_px = 0; }, ErrorCode::BadOption, -1},
      {[](Project& p) { p.next_id = 0; }, ErrorCode::BadInput, -1},
      {[](Project& p) { p.next_id = 2'000'000'001; }, ErrorCode::BadInput, -1},
      {[](Project& p) { p.pins[0].layer = LayerId{3}; }, ErrorCode::BadInput, 0},
      {[](Project& p) { p.pins[0].layer = LayerId::None; }, ErrorCode::BadInput, 0},
      {[](Project& p) { p.pins[0].id = PinId{4}; }, ErrorCode::BadInput, 0},
      {[](Project& p) { p.pins.push_back(p.pins[0]); }, ErrorCode::BadInput, 1},
      {[](Project& p) { p.pins[0].rest.x = not_a_number; }, ErrorCode::BadInput, 0},
      {[](Project& p) { p.clip.tracks[0].pin = PinId{1}; }, ErrorCode::BadInput, 0},
      {[](Project& p) { p.clip.tracks.push_back(p.clip.tracks[0]); }, ErrorCode::BadInput, 1},
      {[](Project& p) { p.clip.tracks[0].keys.clear(); }, ErrorCode::BadInput, 0},
      {[](Project& p) { p.clip.tracks[0].keys[1].time_s = 3; }, ErrorCode::BadInput, 0},
      {[](Project& p) { p.clip.length_s = not_a_number; }, ErrorCode::BadOption, -1},
      {[](Project& p) { p.drawing.layers.resize(1025); }, ErrorCode::TooLarge, -1},
      {[](Project& p) { p.pins.resize(1025); }, ErrorCode::TooLarge, -1},
  };
  int number = 0;
  for (auto const& each : cases) {
    auto project = two_layers();
    each.spoil(project);
    auto const document = make_document(project);
    ASSERT_FALSE(document) << "case " << number;
    EXPECT_EQ(document.error().code, each.code) << "case " << number;
    EXPECT_EQ(document.error().index, each.index) << "case " << number;
    EXPECT_FALSE(document.error().message.empty());
    ++number;
  }
}

}  // namespace
}  // namespace inkflate
