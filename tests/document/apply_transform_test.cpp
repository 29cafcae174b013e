// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "document/apply.h"
#include "geometry/polyline.h"
#include "support/editor_documents.h"
#include "support/refusals.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Affine kMirror = {-1, 0, 0, 1, 300, 0};

/// A ring with sources, marks and a pin.
Document marked_ring() {
  auto document = with_ring(empty_document(), {100, 100}, 50, 20);
  document = with_changed(document, LayerId{1}, [](Layer& layer) {
    layer.outlines.front().sources = {{0, 0.5, 0, 1, 2}, {1, 3.5, 0, 5, 3}};
    layer.choice = {10, {{1, 2}}, {{3, 4}}};
  });
  return *inkflate::apply(document, AddPin{{{}, LayerId{1}, Side::Front, {100, 90}, {50, 60}}});
}

Layer const& ring_of(Document const& document) { return document.layers->front()->layer; }

TEST(TransformLayers, MovesStrokesOutlinesMarksAndPins) {
  auto const before = marked_ring();
  Affine const map = {0, 2, -2, 0, 5, 7};  // a quarter turn, twice as large
  auto const after = inkflate::apply(before, TransformLayers{{LayerId{1}}, map});
  ASSERT_TRUE(after);
  auto const& kept = (*after->layers)[0]->strokes[0];
  auto const& old = (*before.layers)[0]->strokes[0];
  EXPECT_EQ(kept->stroke.samples[3].position, map(old->stroke.samples[3].position));
  EXPECT_EQ(kept->stroke.width_px, 2 * old->stroke.width_px);
  EXPECT_NE(kept->box, old->box);
  EXPECT_EQ(ring_of(*after).outlines[1].pieces[2].curve.control[1],
            map(ring_of(before).outlines[1].pieces[2].curve.control[1]));
  EXPECT_EQ(ring_of(*after).choice, (CloseChoice{20, {map({1, 2})}, {map({3, 4})}}));
  EXPECT_EQ(after->pins->front().rest, map({100, 90}));
  EXPECT_EQ(after->pins->front().position, map({50, 60}));
}

TEST(TransformLayers, MirroredOutlinesKeepTheirTurnAndJoinExactly) {
  auto const after = inkflate::apply(marked_ring(), TransformLayers{{LayerId{1}}, kMirror});
  ASSERT_TRUE(after);
  auto const& outlines = ring_of(*after).outlines;
  EXPECT_GT(signed_area(flatten(outlines[0], 0.1)), 0);
  EXPECT_LT(signed_area(flatten(outlines[1], 0.1)), 0);
  for (auto const& outline : outlines) {
    Vec2 end = outline.pieces.back().curve.end();
    for (auto const& piece : outline.pieces) {
      EXPECT_EQ(piece.curve.start(), end);
      end = piece.curve.end();
    }
  }
}

TEST(TransformLayers, MirroredSourcesFollowTheirOutline) {
  auto const after = inkflate::apply(marked_ring(), TransformLayers{{LayerId{1}}, kMirror});
  ASSERT_TRUE(after);
  std::vector<InkSource> const expected = {{0.5, 3, 0, 3, 5}, {3.5, 4, 0, 2, 1}};
  EXPECT_EQ(ring_of(*after).outlines.front().sources, expected);
}

TEST(TransformLayers, MirroringTwiceIsNothing) {
  auto const once = inkflate::apply(marked_ring(), TransformLayers{{LayerId{1}}, kMirror});
  ASSERT_TRUE(once);
  auto const twice = inkflate::apply(*once, TransformLayers{{LayerId{1}}, kMirror});
  ASSERT_TRUE(twice);
  auto const& outline = ring_of(*twice).outlines.front();
  auto const& old = ring_of(marked_ring()).outlines.front();
  EXPECT_EQ(outline.sources, old.sources);
  for (std::size_t i = 0; i < old.pieces.size(); ++i) {
    EXPECT_LT(distance(outline.pieces[i].curve.start(), old.pieces[i].curve.start()), 1e-12);
  }
}

TEST(TransformLayers, WithoutLayersMovesLooseStrokesAndTheirMarks) {
  auto document = with_loose(marked_ring(), line_stroke({{0, 0}, {10, 0}}));
  document = *inkflate::apply(document, SetChoice{{}, {4, {{1, 1}}, {}}});
  auto const after = inkflate::apply(document, TransformLayers{{}, Affine::scaling(3, 3)});
  ASSERT_TRUE(after);
  EXPECT_EQ(after->loose[0]->box.max.x, 30);
  EXPECT_EQ(*after->choice, (CloseChoice{12, {{3, 3}}, {}}));
  EXPECT_EQ(after->layers, document.layers);
  EXPECT_EQ(after->pins, document.pins);
}

TEST(TransformLayers, RefusesMapsThatLoseOrBurstTheDrawing) {
  auto const document = with_loose(marked_ring(), line_stroke({{0, 0}, {10, 0}}));
  for (auto const& map : {Affine::scaling(0, 1), Affine::scaling(kNan, 1),
                          Affine::scaling(1e300, 1e300), Affine::scaling(1e-300, 1e-300)}) {
    EXPECT_EQ(test::refusal(document, TransformLayers{{LayerId{1}}, map}), ErrorCode::BadOption);
  }
  auto const far = Affine::translation({1e6, 0});
  EXPECT_EQ(test::refusal(document, TransformLayers{{LayerId{1}}, far}), ErrorCode::BadInput);
  EXPECT_EQ(test::refusal(document, TransformLayers{{}, far}), ErrorCode::BadInput);
  EXPECT_EQ(test::refusal(document, TransformLayers{{LayerId{1}}, {}}), ErrorCode::NothingThere);
  EXPECT_EQ(test::refusal(document, TransformLayers{{LayerId{8}}, kMirror}), ErrorCode::BadInput);
  EXPECT_EQ(test::refusal(marked_ring(), TransformLayers{{}, kMirror}), ErrorCode::NothingThere);
}

TEST(TransformLayers, RefusesPinsThatWouldLeaveTheSheet) {
  auto const document = *inkflate::apply(marked_ring(), MovePins{{PinId{2}}, {{-1e6, 0}}});
  auto const refused =
      inkflate::apply(document, TransformLayers{{LayerId{1}}, Affine::translation({-9, 0})});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().index, 2);
}

TEST(TransformLayers, RefusesGapsThatWouldGrowTooLarge) {
  auto document = with_loose(empty_document(), line_stroke({{0, 0}}));
  document = *inkflate::apply(document, SetChoice{{}, {1e6, {}, {}}});
  EXPECT_EQ(test::refusal(document, TransformLayers{{}, Affine::scaling(2, 2)}),
            ErrorCode::BadOption);
}

TEST(DuplicateLayer, SharesItsStrokes) {
  auto const before = marked_ring();
  auto const after = inkflate::apply(before, DuplicateLayer{LayerId{1}, OrderEnd::Back, {}});
  ASSERT_TRUE(after);
  auto const& copy = *after->layers->front();
  EXPECT_EQ(copy.layer.name, "ring copy");
  EXPECT_EQ(static_cast<int>(copy.layer.id), before.next_id);
  EXPECT_EQ(after->next_id, before.next_id + 1);
  EXPECT_TRUE(copy.strokes.is_same((*before.layers)[0]->strokes));
  EXPECT_EQ(after->pins, before.pins);
}

TEST(DuplicateLayer, MayLieAsideAndInFront) {
  auto const after =
      inkflate::apply(marked_ring(), DuplicateLayer{LayerId{1}, OrderEnd::Front, {7, 9}});
  ASSERT_TRUE(after);
  auto const& copy = *after->layers->back();
  EXPECT_EQ(copy.layer.name, "ring copy");
  EXPECT_EQ(copy.layer.choice.outside.front(), (Vec2{8, 11}));
  EXPECT_EQ(copy.strokes[0]->box.min.x, (*after->layers)[0]->strokes[0]->box.min.x + 7);
}

TEST(DuplicateLayer, RefusesWhatHasNoRoom) {
  auto const refused = [](Document const& document, Vec2 offset) {
    return test::refusal(document, DuplicateLayer{LayerId{1}, OrderEnd::Back, offset});
  };
  EXPECT_EQ(refused(empty_document(), {}), ErrorCode::BadInput);
  EXPECT_EQ(refused(marked_ring(), {kNan, 0}), ErrorCode::BadOption);
  EXPECT_EQ(refused(marked_ring(), {1e6, 0}), ErrorCode::BadInput);
  auto many = marked_ring();
  many.layers = std::make_shared<std::vector<Shared<DocumentLayer>> const>(1024, (*many.layers)[0]);
  EXPECT_EQ(refused(many, {}), ErrorCode::TooLarge);
  auto full = marked_ring();
  full.loose = StrokeList::of(
      std::vector<Shared<KeptStroke>>(DocumentLimits::kStrokes - 2, keep(line_stroke({{0, 0}}))));
  EXPECT_EQ(refused(full, {}), ErrorCode::TooLarge);
  auto last = marked_ring();
  last.next_id = DocumentLimits::kIds;
  EXPECT_EQ(refused(last, {}), ErrorCode::TooLarge);
}

}  // namespace
}  // namespace inkflate
