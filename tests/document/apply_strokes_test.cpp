// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "document/apply.h"
#include "support/editor_documents.h"
#include "support/refusals.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Stroke row(double y) { return line_stroke({{0, y}, {50, y}, {100, y}}); }

/// Three loose rows at 0, 100 and 200.
Document three_rows() {
  auto document = empty_document();
  for (double const y : {0.0, 100.0, 200.0}) document = with_loose(document, row(y));
  return document;
}

/// An open layer of three rows, drawn by the middle one, with a disc for its outline.
Document open_layer() {
  auto document = with_open(empty_document(), {row(0), row(100), row(200)});
  return with_changed(document, LayerId{1}, [](Layer& layer) {
    layer.outlines = {circle_outline({50, 50}, 20)};
    layer.outlines.front().sources = {{0, 1, 0, 0, 1}, {1, 2, 1, 0, 1}, {2, 3, 2, 0, 1}};
    layer.strokes = {1};
    layer.details = {0};
    layer.noise = {2};
  });
}

TEST(AddStroke, LiesBehindTheLooseOnesInOrder) {
  auto const before = three_rows();
  auto const after = inkflate::apply(before, AddStroke{row(300), LayerId::None});
  ASSERT_TRUE(after);
  ASSERT_EQ(after->loose.size(), 4);
  EXPECT_EQ(after->loose[3]->stroke, row(300));
  EXPECT_EQ(after->loose[0], before.loose[0]) << "strokes are shared";
  EXPECT_EQ(after->layers, before.layers);
}

TEST(AddStroke, OfAnOpenLayerDrawsItsOutline) {
  auto const after = inkflate::apply(open_layer(), AddStroke{row(300), LayerId{1}});
  ASSERT_TRUE(after);
  auto const& layer = *find_layer(*after, LayerId{1});
  EXPECT_EQ(layer.strokes.size(), 4);
  EXPECT_EQ(layer.layer.strokes, (std::vector<int>{1, 3}));
}

TEST(AddStroke, RefusesWhatIsNoStroke) {
  auto const refused = [](auto spoil) {
    AddStroke command = {row(0), LayerId::None};
    spoil(command);
    return test::refusal(empty_document(), command);
  };
  EXPECT_EQ(refused([](auto& c) { c.stroke.samples.clear(); }), ErrorCode::BadInput);
  EXPECT_EQ(refused([](auto& c) { c.stroke.samples[1].position.x = kNan; }), ErrorCode::BadInput);
  EXPECT_EQ(refused([](auto& c) { c.stroke.samples[1].position.y = 1e300; }), ErrorCode::BadInput);
  EXPECT_EQ(refused([](auto& c) { c.stroke.samples[1].pressure = 1.5; }), ErrorCode::BadInput);
  EXPECT_EQ(refused([](auto& c) { c.stroke.samples[1].time_s = -1; }), ErrorCode::BadInput);
  EXPECT_EQ(refused([](auto& c) { c.stroke.width_px = kNan; }), ErrorCode::BadInput);
  EXPECT_EQ(refused([](auto& c) { c.stroke.group = 0; }), ErrorCode::BadInput);
  EXPECT_EQ(refused([](auto& c) { c.layer = LayerId{1}; }), ErrorCode::BadInput);
  EXPECT_EQ(refused([](auto& c) { c.stroke.samples.resize(1'000'001); }), ErrorCode::TooLarge);
}

TEST(AddStroke, RefusesAMillionAndOneStrokes) {
  auto document = empty_document();
  document.loose =
      StrokeList::of(std::vector<Shared<KeptStroke>>(DocumentLimits::kStrokes, keep(row(0))));
  EXPECT_EQ(test::refusal(document, AddStroke{row(0), LayerId::None}), ErrorCode::TooLarge);
}

TEST(AddStroke, RefusesLayersThatAreClosedOrLocked) {
  auto const disc = with_disc(empty_document(), {0, 0}, 9);
  EXPECT_EQ(test::refusal(disc, AddStroke{row(0), LayerId{1}}), ErrorCode::BadInput);
  auto const locked =
      with_changed(open_layer(), LayerId{1}, [](Layer& layer) { layer.is_locked = true; });
  EXPECT_EQ(test::refusal(locked, AddStroke{row(0), LayerId{1}}), ErrorCode::BadInput);
}

TEST(EraseArea, CutsOnlyTheStrokesThatItMeets) {
  auto const before = three_rows();
  auto const after = inkflate::apply(before, EraseArea{{{50, 100}}, 10});
  ASSERT_TRUE(after);
  ASSERT_EQ(after->loose.size(), 4);
  EXPECT_EQ(after->loose[0], before.loose[0]);
  EXPECT_EQ(after->loose[3], before.loose[2]);
  EXPECT_NEAR(after->loose[1]->box.max.x, 40, 1e-9);
  EXPECT_NEAR(after->loose[2]->box.min.x, 60, 1e-9);
}

TEST(EraseArea, PiecesInAnOpenLayerAreWhatTheirStrokeWas) {
  auto const after = inkflate::apply(open_layer(), EraseArea{{{50, 100}}, 10});
  ASSERT_TRUE(after);
  auto const& layer = find_layer(*after, LayerId{1})->layer;
  EXPECT_EQ(layer.details, std::vector<int>{0});
  EXPECT_EQ(layer.strokes, (std::vector<int>{1, 2}));
  EXPECT_EQ(layer.noise, std::vector<int>{3});
  auto const& sources = layer.outlines.front().sources;
  EXPECT_EQ(sources[0].stroke, 0);
  EXPECT_EQ(sources[1].stroke, -1) << "it was cut";
  EXPECT_EQ(sources[2].stroke, 3);
}

TEST(EraseArea, LeavesHiddenLayersAlone) {
  auto const hidden =
      with_changed(open_layer(), LayerId{1}, [](Layer& layer) { layer.is_hidden = true; });
  EraseArea const all = {{{0, 0}, {1000, 1000}}, 2000};
  EXPECT_EQ(test::refusal(hidden, all), ErrorCode::NothingThere);
}

TEST(EraseArea, LeavesClosedAndLockedLayersAlone) {
  EraseArea const all = {{{50, 100}}, 500};
  auto const disc = with_disc(empty_document(), {50, 50}, 20);
  EXPECT_EQ(test::refusal(disc, all), ErrorCode::NothingThere);
  auto const locked =
      with_changed(open_layer(), LayerId{1}, [](Layer& layer) { layer.is_locked = true; });
  EXPECT_EQ(test::refusal(locked, all), ErrorCode::NothingThere);
}

TEST(EraseArea, RefusesWhatIsNoEraser) {
  EXPECT_EQ(test::refusal(three_rows(), EraseArea{{{50, 50}}, 10}), ErrorCode::NothingThere);
  EXPECT_EQ(test::refusal(three_rows(), EraseArea{{}, 10}), ErrorCode::NothingThere);
  for (double const radius_px : {0.0, -1.0, kNan, 1e300}) {
    EXPECT_EQ(test::refusal(three_rows(), EraseArea{{{50, 100}}, radius_px}), ErrorCode::BadOption);
  }
  EXPECT_EQ(test::refusal(three_rows(), EraseArea{{{50, kNan}}, 9}), ErrorCode::BadInput);
  EXPECT_EQ(test::refusal(three_rows(), EraseArea{Polyline(1'000'001), 9}), ErrorCode::TooLarge);
}

TEST(EraseArea, RefusesPiecesBeyondTheLimit) {
  auto document = empty_document();
  std::vector<Shared<KeptStroke>> strokes(DocumentLimits::kStrokes - 1, keep(row(500)));
  strokes.push_back(keep(row(0)));
  document.loose = StrokeList::of(strokes);
  EXPECT_EQ(test::refusal(document, EraseArea{{{50, 0}}, 10}), ErrorCode::TooLarge);
}

TEST(EraseStrokes, TakesThemFromTheLooseOnesAndFromOpenLayers) {
  auto const before = with_loose(with_loose(open_layer(), row(7)), row(8));
  auto const after =
      inkflate::apply(before, EraseStrokes{{{LayerId{1}, 2}, {LayerId::None, 0}, {LayerId{1}, 0}}});
  ASSERT_TRUE(after);
  ASSERT_EQ(after->loose.size(), 1);
  EXPECT_EQ(after->loose[0], before.loose[1]);
  auto const& layer = *find_layer(*after, LayerId{1});
  EXPECT_EQ(layer.strokes.size(), 1);
  EXPECT_EQ(layer.layer.strokes, std::vector<int>{0});
  EXPECT_TRUE(layer.layer.details.empty());
  EXPECT_EQ(layer.layer.outlines.front().sources[1].stroke, 0);
}

TEST(EraseStrokes, RefusesStrokesThatAreNotThereTwiceOrClosed) {
  EXPECT_EQ(test::refusal(three_rows(), EraseStrokes{}), ErrorCode::NothingThere);
  for (int const index : {-1, 3, std::numeric_limits<int>::max()}) {
    EXPECT_EQ(test::refusal(three_rows(), EraseStrokes{{{LayerId::None, index}}}),
              ErrorCode::BadInput);
  }
  EXPECT_EQ(test::refusal(three_rows(), EraseStrokes{{{LayerId::None, 1}, {LayerId::None, 1}}}),
            ErrorCode::BadInput);
  auto const disc = with_disc(empty_document(), {0, 0}, 9);
  EXPECT_EQ(test::refusal(disc, EraseStrokes{{{LayerId{1}, 0}}}), ErrorCode::BadInput);
}

}  // namespace
}  // namespace inkflate
