// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_pins.h"

#include <gtest/gtest.h>

#include <cmath>

#include "editor/pick_bend.h"
#include "geometry/trig.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

constexpr LayerId kDisc{1};

Document pinned_disc(std::vector<BendPin> const& pins) {
  return with_changed(with_disc(empty_document(), {300, 300}, 100), kDisc,
                      [&](Layer& layer) { layer.bend_pins = pins; });
}

View deforming() {
  View view;
  view.tool = Tool::Deform;
  return view;
}

TEST(ScenePins, AreShownWithTheDeformToolAlone) {
  auto const document = pinned_disc({{{200, 300}}});
  View view = deforming();
  EXPECT_FALSE(draw_pins(document, view, ToolIdle{}).empty());
  view.tool = Tool::Select;
  EXPECT_TRUE(draw_pins(document, view, ToolIdle{}).empty());
}

TEST(ScenePins, OfHiddenPartsAndOutOfViewAreNotShown) {
  auto document = pinned_disc({{{5000, 300}}});
  EXPECT_TRUE(draw_pins(document, deforming(), ToolIdle{}).empty());
  document = with_changed(pinned_disc({{{200, 300}}}), kDisc,
                          [](Layer& layer) { layer.is_hidden = true; });
  EXPECT_TRUE(draw_pins(document, deforming(), ToolIdle{}).empty());
}

// By shape, not by colour.
TEST(ScenePins, SelectedTurnedAndLockedOnesLookDifferent) {
  auto const document = pinned_disc({{{200, 300}}});
  auto const plain = draw_pins(document, deforming(), ToolIdle{});
  auto const turned = draw_pins(pinned_disc({{{200, 300}, 0.5}}), deforming(), ToolIdle{});
  auto const locked =
      draw_pins(with_changed(document, kDisc, [](Layer& layer) { layer.is_locked = true; }),
                deforming(), ToolIdle{});
  View view = deforming();
  view.pin = BendPinRef{kDisc, 0};
  auto const selected = draw_pins(document, view, ToolIdle{});
  EXPECT_GT(turned.size(), plain.size());
  EXPECT_GT(locked.size(), plain.size());
  EXPECT_GT(selected.size(), turned.size());
}

TEST(ScenePins, TheKnobStandsAboveThePinAndTurnsWithIt) {
  View view = deforming();
  BendPin pin = {{500, 500}};
  EXPECT_NEAR(distance(pin_knob(pin, view), Vec2{500, 500 - kPinRingPx}), 0, 1e-9);
  pin.turn_rad = kPi / 2;
  EXPECT_NEAR(distance(pin_knob(pin, view), Vec2{500 + kPinRingPx, 500}), 0, 1e-9);
  view.camera = mirrored(view.camera);
  EXPECT_NEAR(distance(pin_knob(pin, view), Vec2{500 - kPinRingPx, 500}), 0, 1e-9);
}

TEST(ScenePins, TheReachIsADashedRingAroundTheHandOnceItIsChanged) {
  auto const document = pinned_disc({});
  ToolBending bend = {{kDisc, {}, {}, {400, 300}}, {}, {420, 300}};
  auto const held = draw_pins(document, deforming(), bend);
  EXPECT_FALSE(held.empty());
  bend.ring_px = 50;
  View view = deforming();
  view.camera = zoomed(view.camera, view.size, {500, 500}, 2);
  auto const list = draw_pins(document, view, bend);
  ASSERT_EQ(list.size(), held.size() + 1);
  auto const& ring = std::get<StrokedPolyline>(list.front());
  EXPECT_FALSE(ring.dashes_px.empty());
  auto const centre = canvas_to_screen(view.camera, view.size)(bend.target);
  for (auto const p : ring.points) EXPECT_NEAR(distance(p, centre), 100, 1e-9);
}

}  // namespace
}  // namespace inkflate
