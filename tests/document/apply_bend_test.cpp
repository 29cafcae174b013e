// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "document/apply.h"
#include "document/history.h"
#include "document/transform.h"
#include "support/editor_documents.h"
#include "support/refusals.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Affine kShear = {1, 0.25, 0.5, 1, 3, -2};
std::vector<BendPin> const kPins = {{{100, 50}}, {{150, 100}, 0.5}};

/// A ring with a source, marks, pins and a second stroke; loose strokes beside it.
Document sheet() {
  auto document = with_ring(empty_document(), {100, 100}, 50, 20);
  document = with_changed(document, LayerId{1}, [](Layer& layer) {
    layer.outlines.front().sources = {{0, 2, 0, 1, 2}, {2, 3, -1, 0, 0}, {3, 4, 0, 5, 3}};
    layer.choice = {10, {{1, 2}}, {{3, 4}, {5, 6}}};
    layer.bend_pins = kPins;
  });
  document = with_loose(document, line_stroke({{0, 0}, {10, 0}, {20, 5}}));
  return with_loose(document, line_stroke({{0, 50}, {10, 50}}));
}

DocumentLayer const& layer_of(Document const& document) { return *document.layers->front(); }
Layer const& ring_of(Document const& document) { return layer_of(document).layer; }

std::vector<Vec2> places(StrokeList const& strokes) {
  std::vector<Vec2> positions;
  strokes.for_each([&](Shared<KeptStroke> const& kept) {
    for (auto const& sample : kept->stroke.samples) positions.push_back(sample.position);
  });
  return positions;
}

/// The front layer as it is, for a command to change.
Bend::Part at_rest(Document const& document) {
  auto const& layer = ring_of(document);
  Bend::Part part = {layer.id, layer.outlines, places(layer_of(document).strokes),
                     layer.choice.outside};
  auto const& inside = layer.choice.inside;
  part.marks.insert(part.marks.end(), inside.begin(), inside.end());
  return part;
}

/// The whole part under a map.
Bend::Part mapped(Bend::Part part, Affine const& map) {
  for (auto& outline : part.outlines) outline = transformed(outline, map);
  for (auto* points : {&part.samples, &part.marks}) {
    for (auto& point : *points) point = map(point);
  }
  return part;
}

TEST(Bend, MovesOutlinesStrokesAndMarksAndNothingElse) {
  auto const before = sheet();
  auto const after = inkflate::apply(before, Bend{{mapped(at_rest(before), kShear)}});
  ASSERT_TRUE(after) << after.error().message;
  auto expected = ring_of(before);
  for (auto& outline : expected.outlines) outline = transformed(outline, kShear);
  expected.choice = {10, {kShear({1, 2})}, {kShear({3, 4}), kShear({5, 6})}};
  EXPECT_EQ(ring_of(*after), expected);
  auto const& kept = layer_of(*after).strokes[0];
  auto const& old = layer_of(before).strokes[0];
  EXPECT_EQ(kept->stroke.samples[3].position, kShear(old->stroke.samples[3].position));
  EXPECT_EQ(kept->stroke.width_px, old->stroke.width_px);
  EXPECT_NE(kept->box, old->box);
  EXPECT_TRUE(after->loose.is_same(before.loose));
}

TEST(Bend, StrokesThatDoNotMoveAreShared) {
  auto const before = sheet();
  auto part = at_rest(before);
  part.samples.back() += Vec2{1, 0};
  auto const after = inkflate::apply(before, Bend{{part}});
  ASSERT_TRUE(after);
  auto const& strokes = layer_of(*after).strokes;
  int const last = strokes.size() - 1;
  ASSERT_GT(last, 0);
  EXPECT_EQ(strokes[0], layer_of(before).strokes[0]);
  EXPECT_NE(strokes[last], layer_of(before).strokes[last]);
}

TEST(Bend, WhatMovesOutlinesAloneSharesAllStrokes) {
  auto const before = sheet();
  auto part = at_rest(before);
  part.outlines[1] = transformed(part.outlines[1], kShear);
  auto const after = inkflate::apply(before, Bend{{part}});
  ASSERT_TRUE(after);
  EXPECT_TRUE(layer_of(*after).strokes.is_same(layer_of(before).strokes));
  EXPECT_EQ(ring_of(*after).outlines[0], ring_of(before).outlines[0]);
}

TEST(Bend, LayersThatAreOnlyNamedAreShared) {
  auto const before = with_disc(sheet(), {300, 300}, 40);
  Bend::Part disc = {LayerId{2},
                     before.layers->back()->layer.outlines,
                     places(before.layers->back()->strokes),
                     {}};
  auto const after = inkflate::apply(before, Bend{{at_rest(before), mapped(disc, kShear)}});
  ASSERT_TRUE(after);
  EXPECT_EQ(after->layers->front(), before.layers->front());
  EXPECT_NE(after->layers->back(), before.layers->back());
}

TEST(Bend, MovesRoughStrokesOneByOne) {
  auto const before = sheet();
  Bend const command = {{}, {{{LayerId::None, 1}, {{0, 60}, {10, 50}}}}};
  auto const after = inkflate::apply(before, command);
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->loose[0], before.loose[0]);
  EXPECT_EQ(after->loose[1]->stroke.samples[0].position, (Vec2{0, 60}));
  EXPECT_EQ(after->loose[1]->box.max.y, 60);
  EXPECT_EQ(after->layers->front(), before.layers->front());
}

TEST(Bend, OutlinesForgetTheRoughStrokesThatLeaveThem) {
  auto const before = with_changed(sheet(), LayerId{1}, [](Layer& layer) { layer.is_open = true; });
  auto samples = places(StrokeList::of(std::vector{layer_of(before).strokes[0]}));
  for (auto& sample : samples) sample.x += 5;
  auto const after = inkflate::apply(before, Bend{{}, {{{LayerId{1}, 0}, samples}}});
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(layer_of(*after).strokes[0]->stroke.samples[0].position, samples[0]);
  for (auto const& source : ring_of(*after).outlines[0].sources) EXPECT_EQ(source.stroke, -1);
  EXPECT_EQ(ring_of(*after).strokes, ring_of(before).strokes);
}

TEST(Bend, MayCutPiecesAndSourcesWhereTheyAre) {
  auto const before = sheet();
  auto part = at_rest(before);
  auto& outline = part.outlines[0];
  auto const [first, second] = split(outline.pieces[0].curve, 0.25);
  outline.pieces[0].curve = first;
  outline.pieces.insert(outline.pieces.begin() + 1, {second, outline.pieces[0].kind});
  outline.sources = {{0, 1, 0, 1, 1.125}, {1, 3, 0, 1.125, 2}, {3, 4, -1, 0, 0}, {4, 5, 0, 5, 3}};
  auto const after = inkflate::apply(before, Bend{{part}});
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(ring_of(*after).outlines[0], outline);
}

TEST(Bend, TakesOutlinesThatCrossThemselvesOrTurnOver) {
  auto const before = sheet();
  auto part = at_rest(before);
  for (auto& piece : part.outlines[0].pieces) {
    for (auto& point : piece.curve.control) point.x = 100 + 0.01 * (point.x - 100) * (point.y - 90);
  }
  EXPECT_TRUE(inkflate::apply(before, Bend{{part}}));
}

TEST(Bend, IsTakenOfHiddenAndOfOpenLayersButNotOfLockedOnes) {
  auto const refused = [](std::function<void(Layer&)> const& change) {
    auto const document = with_changed(sheet(), LayerId{1}, change);
    return test::refusal(document, Bend{{mapped(at_rest(document), kShear)}});
  };
  EXPECT_EQ(refused([](Layer& layer) { layer.is_hidden = true; }), std::nullopt);
  EXPECT_EQ(refused([](Layer& layer) { layer.is_open = true; }), std::nullopt);
  EXPECT_EQ(refused([](Layer& layer) { layer.is_locked = true; }), ErrorCode::BadInput);
}

TEST(Bend, RefusesWhatWouldChangeNothing) {
  auto const document = sheet();
  EXPECT_EQ(test::refusal(document, Bend{}), ErrorCode::NothingThere);
  EXPECT_EQ(test::refusal(document, Bend{{at_rest(document)}}), ErrorCode::NothingThere);
  Bend const still = {{}, {{{LayerId::None, 1}, {{0, 50}, {10, 50}}}}};
  EXPECT_EQ(test::refusal(document, still), ErrorCode::NothingThere);
}

TEST(Bend, RefusesAnotherLayerThanThereIs) {
  auto const document = sheet();
  auto const refused = [&](std::function<void(Bend::Part&)> const& change) {
    auto part = mapped(at_rest(document), kShear);
    change(part);
    auto const after = inkflate::apply(document, Bend{{part}});
    return !after && after.error().code == ErrorCode::BadInput &&
           after.error().index == static_cast<int>(part.layer);
  };
  EXPECT_FALSE(refused([](Bend::Part&) {}));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.layer = LayerId{9}; }));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.layer = LayerId::None; }));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.outlines.pop_back(); }));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.samples.pop_back(); }));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.samples.push_back({}); }));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.marks.pop_back(); }));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.outlines[0].pieces.clear(); }));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.outlines[0].pieces.pop_back(); }));
  EXPECT_TRUE(
      refused([](Bend::Part& part) { part.outlines[0].pieces[1].kind = RunKind::Closing; }));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.outlines[0].sources[0].stroke = 1; }));
  EXPECT_TRUE(refused([](Bend::Part& part) { part.outlines[0].sources.pop_back(); }));
}

TEST(Bend, RefusesWhatIsNoNumberOrTooFarAway) {
  auto const document = sheet();
  auto const refused = [&](std::function<void(Bend::Part&)> const& change) {
    auto part = at_rest(document);
    change(part);
    return test::refusal(document, Bend{{part}}) == ErrorCode::BadInput;
  };
  for (double const bad : {kNan, 1.1e6, -std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(
        refused([&](Bend::Part& part) { part.outlines[0].pieces[1].curve.control[1].y = bad; }));
    EXPECT_TRUE(refused([&](Bend::Part& part) { part.samples[2].x = bad; }));
    EXPECT_TRUE(refused([&](Bend::Part& part) { part.outlines[0].sources[0].to = bad; }) ||
                bad == 1.1e6);
    Bend const line = {{}, {{{LayerId::None, 1}, {{0, bad}, {10, 50}}}}};
    EXPECT_EQ(test::refusal(document, line), ErrorCode::BadInput);
  }
  EXPECT_TRUE(refused([](Bend::Part& part) { part.marks[2].x = kNan; }));
}

TEST(Bend, RefusesLinesThatAreNotThereOrNotRough) {
  auto const document = sheet();
  std::vector<Vec2> const two = {{0, 60}, {10, 50}};
  for (auto const ref :
       {StrokeRef{LayerId::None, 2}, StrokeRef{LayerId::None, -1}, StrokeRef{LayerId::None, 0},
        StrokeRef{LayerId{1}, 0}, StrokeRef{LayerId{7}, 0}}) {
    EXPECT_EQ(test::refusal(document, Bend{{}, {{ref, two}}}), ErrorCode::BadInput) << ref.index;
  }
}

TEST(Bend, RefusesToBendAnythingTwice) {
  auto const document =
      with_changed(sheet(), LayerId{1}, [](Layer& layer) { layer.is_open = true; });
  auto const part = mapped(at_rest(document), kShear);
  EXPECT_EQ(test::refusal(document, Bend{{part, part}}), ErrorCode::BadInput);
  Bend::Line const line = {{LayerId::None, 1}, {{0, 60}, {10, 50}}};
  EXPECT_EQ(test::refusal(document, Bend{{}, {line, line}}), ErrorCode::BadInput);
  Bend::Line const own = {{LayerId{1}, 0},
                          places(StrokeList::of(std::vector{layer_of(document).strokes[0]}))};
  EXPECT_EQ(test::refusal(document, Bend{{part}, {own}}), ErrorCode::BadInput);
}

TEST(Bend, IsTakenBackToTheSameLayer) {
  auto const before = sheet();
  History history(before);
  ASSERT_TRUE(history.push({Bend{{mapped(at_rest(before), kShear)}}}, 0).has_value());
  auto const after = history.document();
  ASSERT_TRUE(history.undo());
  EXPECT_EQ(history.document().layers, before.layers);
  ASSERT_TRUE(history.redo());
  EXPECT_EQ(history.document().layers, after.layers);
}

}  // namespace
}  // namespace inkflate
