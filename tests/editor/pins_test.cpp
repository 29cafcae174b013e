// SPDX-License-Identifier: Apache-2.0
#include "editor/pins.h"

#include <gtest/gtest.h>

#include "support/editor_documents.h"

namespace inkflate {
namespace {

constexpr LayerId kBack{1};
constexpr LayerId kFront{2};

Document pinned_discs() {
  auto document = with_disc(with_disc(empty_document(), {300, 300}, 100), {600, 300}, 100);
  document = with_changed(document, kBack, [](Layer& layer) {
    layer.bend_pins = {{{200, 300}}, {{400, 300}}};
  });
  return with_changed(document, kFront, [](Layer& layer) { layer.bend_pins = {{{500, 300}}}; });
}

TEST(Pins, AreGoneThroughFrontToBackInACircle) {
  View const view;
  auto const pins = pins_in_turn(pinned_discs(), view);
  std::vector<BendPinRef> const expected = {{kFront, 0}, {kBack, 0}, {kBack, 1}};
  EXPECT_EQ(pins, expected);
  EXPECT_EQ(pin_after(pins, std::nullopt, 1), expected[0]);
  EXPECT_EQ(pin_after(pins, std::nullopt, -1), expected[2]);
  EXPECT_EQ(pin_after(pins, expected[2], 1), expected[0]);
  EXPECT_EQ(pin_after(pins, expected[0], -1), expected[2]);
  EXPECT_EQ(pin_after({}, expected[0], 1), std::nullopt);
}

TEST(Pins, OfTheSelectedPartsComeAloneWhereTheyHaveAny) {
  View view;
  view.selection = {kBack};
  EXPECT_EQ(pins_in_turn(pinned_discs(), view).size(), 2U);
  view.selection = {LayerId{9}};
  EXPECT_EQ(pins_in_turn(pinned_discs(), view).size(), 3U);
}

TEST(Pins, OfHiddenAndLockedPartsCannotBeTakenHoldOf) {
  for (auto const claim : {&Layer::is_hidden, &Layer::is_locked}) {
    auto const document =
        with_changed(pinned_discs(), kBack, [&](Layer& layer) { layer.*claim = true; });
    EXPECT_EQ(find_pin(document, {kBack, 0}), nullptr);
    EXPECT_EQ(pins_of(document), std::vector<BendPinRef>{(BendPinRef{kFront, 0})});
  }
}

TEST(Pins, ThatAreNotThereAreNotFound) {
  auto const document = pinned_discs();
  EXPECT_NE(find_pin(document, {kBack, 1}), nullptr);
  EXPECT_EQ(find_pin(document, {kBack, 2}), nullptr);
  EXPECT_EQ(find_pin(document, {kBack, -1}), nullptr);
  EXPECT_EQ(find_pin(document, {LayerId{9}, 0}), nullptr);
}

TEST(Pins, TheNextOneHoldsFarthestFromTheOthers) {
  Layer layer;
  EXPECT_EQ(place_for_pin(layer), std::nullopt);
  layer.outlines = {circle_outline({0, 0}, 100)};
  layer.bend_pins = {{{100, 0}}};
  EXPECT_NEAR(distance(*place_for_pin(layer), {-100, 0}), 0, 3);
  layer.bend_pins.push_back({{-100, 0}});
  auto const third = *place_for_pin(layer);
  EXPECT_NEAR(third.x, 0, 3);
  EXPECT_NEAR(norm(third), 100, 0.1);
}

}  // namespace
}  // namespace inkflate
