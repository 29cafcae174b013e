// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "document/apply.h"
#include "document/merge.h"
#include "support/editor_documents.h"
#include "support/refusals.h"

namespace inkflate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
std::vector<BendPin> const kPins = {{{100, 50}}, {{150, 100}, 0.5}};

/// A ring with pins.
Document pinned() {
  return with_changed(with_ring(empty_document(), {100, 100}, 50, 20), LayerId{1},
                      [](Layer& layer) { layer.bend_pins = kPins; });
}

DocumentLayer const& layer_of(Document const& document) { return *document.layers->front(); }
Layer const& ring_of(Document const& document) { return layer_of(document).layer; }

TEST(SetBendPins, TakeThePlaceOfThoseBefore) {
  auto const before = pinned();
  auto const after = inkflate::apply(before, SetBendPins{LayerId{1}, {{{7, 8}, -1}}});
  ASSERT_TRUE(after);
  EXPECT_EQ(ring_of(*after).bend_pins, (std::vector<BendPin>{{{7, 8}, -1}}));
  EXPECT_TRUE(layer_of(*after).strokes.is_same(layer_of(before).strokes));
  auto const none = inkflate::apply(before, SetBendPins{LayerId{1}, {}});
  ASSERT_TRUE(none);
  EXPECT_TRUE(ring_of(*none).bend_pins.empty());
}

TEST(SetBendPins, RefusesWhatNoLayerCanHave) {
  auto const document = pinned();
  auto const refused = [&](std::vector<BendPin> pins) {
    return test::refusal(document, SetBendPins{LayerId{1}, std::move(pins)});
  };
  EXPECT_EQ(refused({{{kNan, 0}}}), ErrorCode::BadInput);
  EXPECT_EQ(refused({{{0, 1.1e6}}}), ErrorCode::BadInput);
  EXPECT_EQ(refused({{{0, 0}, kNan}}), ErrorCode::BadOption);
  EXPECT_EQ(refused({{{0, 0}, -1001}}), ErrorCode::BadOption);
  EXPECT_EQ(refused(kPins), ErrorCode::NothingThere);
  EXPECT_EQ(refused(std::vector<BendPin>(256)), std::nullopt);
  EXPECT_EQ(refused(std::vector<BendPin>(257)), ErrorCode::TooLarge);
  EXPECT_EQ(test::refusal(document, SetBendPins{LayerId{2}, {}}), ErrorCode::BadInput);
  auto const locked =
      with_changed(document, LayerId{1}, [](Layer& layer) { layer.is_locked = true; });
  EXPECT_EQ(test::refusal(locked, SetBendPins{LayerId{1}, {}}), ErrorCode::BadInput);
}

TEST(BendPins, MoveWithTheLayerAndTurnBackInAMirror) {
  auto const turned = [](Affine const& map) {
    return ring_of(*inkflate::apply(pinned(), TransformLayers{{LayerId{1}}, map})).bend_pins;
  };
  Affine const mirror = {-1, 0, 0, 1, 300, 0};
  EXPECT_EQ(turned(mirror), (std::vector<BendPin>{{{200, 50}}, {{150, 100}, -0.5}}));
  Affine const quarter = {0, 1, -1, 0, 0, 0};
  EXPECT_EQ(turned(quarter), (std::vector<BendPin>{{{-50, 100}}, {{-100, 150}, 0.5}}));
}

TEST(BendPins, AreCopiedAndMergedButDroppedByANewShape) {
  auto const document = pinned();
  auto const copied =
      inkflate::apply(document, DuplicateLayer{LayerId{1}, OrderEnd::Front, {1, 0}});
  ASSERT_TRUE(copied);
  EXPECT_EQ(copied->layers->back()->layer.bend_pins.front().position, (Vec2{101, 50}));
  EXPECT_EQ(merged(empty_document(), document).layers->front()->layer.bend_pins, kPins);
  auto shape = ring_of(document);
  auto const open = inkflate::apply(document, OpenLayer{LayerId{1}});
  auto const simplified =
      inkflate::apply(*open, Simplify{{{LayerId{1}, {}, StrokeDepth::Near, {shape}}}});
  ASSERT_TRUE(simplified) << simplified.error().message;
  EXPECT_TRUE(ring_of(*simplified).bend_pins.empty());
}

TEST(BendPins, ThatNoCommandWouldTakeMakeNoDocument) {
  auto project = to_project(pinned());
  EXPECT_TRUE(make_document(project));
  project.drawing.layers.front().bend_pins.front().position.x = 2e6;
  EXPECT_EQ(make_document(project).error().code, ErrorCode::BadInput);
  project.drawing.layers.front().bend_pins.assign(257, {});
  EXPECT_EQ(make_document(project).error().code, ErrorCode::TooLarge);
}

}  // namespace
}  // namespace inkflate
