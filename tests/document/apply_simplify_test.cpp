// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "document/apply.h"
#include "support/editor_documents.h"
#include "support/refusals.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Layer shape(std::string name, std::vector<int> strokes) {
  Layer layer;
  layer.name = std::move(name);
  layer.outlines = {circle_outline({50, 50}, 20)};
  for (int const stroke : strokes) layer.outlines.front().sources.push_back({0, 1, stroke, 0, 1});
  layer.strokes = std::move(strokes);
  layer.choice.gap_px = 12;
  return layer;
}

/// A disc with id 1 and four loose circles, radius 1 to 4.
Document rough() {
  auto document = with_disc(empty_document(), {50, 50}, 20, "old");
  for (int i = 1; i <= 4; ++i) document = with_loose(document, circle_stroke({0, 0}, i));
  auto const marked = inkflate::apply(document, SetChoice{{}, {5, {{1, 1}}, {{2, 2}}}});
  return *marked;
}

Simplify of(Simplify::Set set) { return {{std::move(set)}}; }

TEST(Simplify, LooseStrokesBecomeALayerInFront) {
  auto const before = rough();
  auto const after =
      inkflate::apply(before, of({{}, {1, 3}, StrokeDepth::Near, {shape("new", {3})}}));
  ASSERT_TRUE(after);
  ASSERT_EQ(after->layers->size(), 2U);
  auto const& made = *after->layers->back();
  EXPECT_EQ(made.layer.name, "new");
  EXPECT_EQ(static_cast<int>(made.layer.id), before.next_id);
  EXPECT_EQ(after->next_id, before.next_id + 1);
  EXPECT_EQ(made.strokes.size(), 2);
  EXPECT_EQ(made.strokes[1], before.loose[3]) << "strokes are shared";
  EXPECT_EQ(made.layer.strokes, std::vector<int>{1});
  EXPECT_EQ(made.layer.noise, std::vector<int>{0}) << "no shape names it";
  EXPECT_EQ(made.layer.outlines.front().sources.front().stroke, 1);
  EXPECT_EQ(made.layer.choice.gap_px, 12);
}

TEST(Simplify, OtherLooseStrokesAndTheirMarksStay) {
  auto const before = rough();
  auto const after =
      inkflate::apply(before, of({{}, {1, 3}, StrokeDepth::Near, {shape("new", {3})}}));
  ASSERT_TRUE(after);
  ASSERT_EQ(after->loose.size(), 2);
  EXPECT_EQ(after->loose[0], before.loose[0]);
  EXPECT_EQ(after->loose[1], before.loose[2]);
  EXPECT_EQ(*after->choice, *before.choice);
}

TEST(Simplify, MarksGoWithTheLastLooseStroke) {
  auto const after =
      inkflate::apply(rough(), of({{}, {0, 1, 2, 3}, StrokeDepth::Near, {shape("new", {0})}}));
  ASSERT_TRUE(after);
  EXPECT_TRUE(after->loose.is_empty());
  EXPECT_EQ(*after->choice, (CloseChoice{5, {}, {}}));
}

TEST(Simplify, FarSetsLieBehindAllOthersNearOnesBefore) {
  Simplify command;
  command.sets.push_back({{}, {0, 1}, StrokeDepth::Far, {shape("a", {0}), shape("b", {1})}});
  command.sets.push_back({{}, {2}, StrokeDepth::Near, {shape("c", {2})}});
  auto const after = inkflate::apply(rough(), command);
  ASSERT_TRUE(after);
  std::string order;
  for (auto const& layer : *after->layers) order += layer->layer.name + " ";
  EXPECT_EQ(order, "a b old c ");
}

TEST(Simplify, StrokeOfTwoShapesGoesToTheFirst) {
  auto const after = inkflate::apply(
      rough(), of({{}, {0, 1}, StrokeDepth::Near, {shape("a", {0}), shape("b", {0, 1})}}));
  ASSERT_TRUE(after);
  auto const& b = *after->layers->back();
  EXPECT_EQ(b.layer.strokes, std::vector<int>{0});
  EXPECT_EQ(b.layer.outlines.front().sources.front().stroke, -1);
}

TEST(Simplify, OpenLayerKeepsWhatItWasAndIsClosed) {
  auto document = with_disc(rough(), {9, 9}, 3, "above");
  document = with_changed(document, LayerId{1}, [](Layer& layer) {
    layer.is_open = true;
    layer.thickness = 7;
    layer.is_hidden = true;
    layer.fill = Colour{1, 2, 3};
  });
  auto const after = inkflate::apply(
      document, of({LayerId{1}, {}, StrokeDepth::Near, {shape("x", {0}), shape("y", {})}}));
  ASSERT_TRUE(after);
  ASSERT_EQ(after->layers->size(), 3U);
  auto const& first = (*after->layers)[0]->layer;
  EXPECT_EQ(first.id, LayerId{1});
  EXPECT_EQ(first.name, "old");
  EXPECT_EQ(first.thickness, 7);
  EXPECT_TRUE(first.is_hidden);
  EXPECT_EQ(first.fill, (Colour{1, 2, 3}));
  EXPECT_FALSE(first.is_open);
  EXPECT_EQ(first.choice.gap_px, 12);
  EXPECT_EQ((*after->layers)[1]->layer.name, "y") << "just before it";
  EXPECT_EQ(static_cast<int>((*after->layers)[1]->layer.id), document.next_id);
  EXPECT_EQ(after->next_id, document.next_id + 1);
  EXPECT_EQ(after->loose.size(), 4);
}

TEST(Simplify, RefusesSetsThatDoNotFit) {
  auto const near = StrokeDepth::Near;
  auto const refused = [](Simplify const& command) { return test::refusal(rough(), command); };
  EXPECT_EQ(refused({}), ErrorCode::NothingThere);
  EXPECT_EQ(refused(of({{}, {}, near, {shape("a", {})}})), ErrorCode::NothingThere);
  EXPECT_EQ(refused(of({{}, {0}, near, {}})), ErrorCode::NothingThere);
  EXPECT_EQ(refused(of({{}, {4}, near, {shape("a", {})}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(of({{}, {1, 0}, near, {shape("a", {})}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(of({{}, {-1}, near, {shape("a", {})}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(of({{}, {0}, near, {shape("a", {1})}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(of({{}, {0}, near, {shape("a", {4})}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(of({{}, {0}, near, {Layer{}}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(of({LayerId{1}, {}, near, {shape("a", {})}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(of({LayerId{9}, {}, near, {shape("a", {})}})), ErrorCode::BadInput);
  Simplify twice = of({{}, {0}, near, {shape("a", {0})}});
  twice.sets.push_back(twice.sets.front());
  EXPECT_EQ(refused(twice), ErrorCode::BadInput);
  EXPECT_EQ(refused(of({{}, {0}, near, std::vector<Layer>(1024, shape("a", {}))})),
            ErrorCode::TooLarge);
}

Simplify with_details(Simplify::Details details) { return {{}, {std::move(details)}}; }

TEST(Simplify, LooseStrokesBecomeDetailsOfAClosedLayer) {
  auto const before = rough();
  auto const after = inkflate::apply(before, with_details({LayerId{1}, {0, 2}}));
  ASSERT_TRUE(after);
  ASSERT_EQ(after->layers->size(), 1U);
  auto const& layer = *after->layers->front();
  auto const& old = *before.layers->front();
  EXPECT_EQ(layer.layer.outlines, old.layer.outlines);
  EXPECT_EQ(layer.layer.details, (std::vector<int>{old.strokes.size(), old.strokes.size() + 1}));
  EXPECT_EQ(layer.strokes[old.strokes.size() + 1], before.loose[2]) << "strokes are shared";
  ASSERT_EQ(after->loose.size(), 2);
  EXPECT_EQ(after->loose[0], before.loose[1]);
  EXPECT_EQ(*after->choice, *before.choice);
}

TEST(Simplify, DetailsAndShapesComeTogether) {
  auto command = of({{}, {1, 3}, StrokeDepth::Far, {shape("new", {3})}});
  command.details = {{LayerId{1}, {0}}, {LayerId{1}, {2}}};
  auto const after = inkflate::apply(rough(), command);
  ASSERT_TRUE(after);
  ASSERT_EQ(after->layers->size(), 2U);
  EXPECT_EQ((*after->layers)[0]->layer.name, "new");
  EXPECT_EQ((*after->layers)[1]->layer.details.size(), 2U);
  EXPECT_TRUE(after->loose.is_empty());
  EXPECT_TRUE(after->choice->outside.empty());
}

TEST(Simplify, RefusesDetailsThatDoNotFit) {
  auto const refused = [](Simplify const& command) { return test::refusal(rough(), command); };
  EXPECT_EQ(refused(with_details({LayerId{1}, {}})), ErrorCode::NothingThere);
  EXPECT_EQ(refused(with_details({LayerId{1}, {4}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(with_details({LayerId{1}, {1, 0}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(with_details({LayerId{9}, {0}})), ErrorCode::BadInput);
  EXPECT_EQ(refused(with_details({LayerId::None, {0}})), ErrorCode::BadInput);
  auto twice = of({{}, {0}, StrokeDepth::Near, {shape("a", {0})}});
  twice.details = {{LayerId{1}, {0}}};
  EXPECT_EQ(refused(twice), ErrorCode::BadInput);
  auto const open = with_changed(rough(), LayerId{1}, [](Layer& layer) { layer.is_open = true; });
  EXPECT_EQ(test::refusal(open, with_details({LayerId{1}, {0}})), ErrorCode::BadInput);
  auto const locked =
      with_changed(rough(), LayerId{1}, [](Layer& layer) { layer.is_locked = true; });
  EXPECT_EQ(test::refusal(locked, with_details({LayerId{1}, {0}})), ErrorCode::BadInput);
}

TEST(Simplify, RefusesAnOpenLayerTwiceOrInPart) {
  auto const open = with_changed(rough(), LayerId{1}, [](Layer& layer) { layer.is_open = true; });
  Simplify::Set const set = {LayerId{1}, {}, StrokeDepth::Near, {shape("a", {})}};
  EXPECT_EQ(test::refusal(open, Simplify{{set, set}}), ErrorCode::BadInput);
  Simplify::Set const part = {LayerId{1}, {0}, StrokeDepth::Near, {shape("a", {})}};
  EXPECT_EQ(test::refusal(open, of(part)), ErrorCode::BadInput);
}

TEST(Simplify, RefusesWhenAllIdsAreGiven) {
  auto document = rough();
  document.next_id = DocumentLimits::kIds;
  EXPECT_EQ(test::refusal(document, of({{}, {0}, StrokeDepth::Near, {shape("a", {})}})),
            ErrorCode::TooLarge);
}

}  // namespace
}  // namespace inkflate
