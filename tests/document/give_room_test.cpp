// SPDX-License-Identifier: Apache-2.0
#include "document/give_room.h"

#include <gtest/gtest.h>

#include "document/document.h"

namespace inkflate {
namespace {

Stroke line(Vec2 from, Vec2 to) {
  Stroke stroke;
  stroke.samples = {{from}, {to}};
  return stroke;
}

Project project_with(Stroke stroke) {
  Project project;
  project.drawing.sketch.width_px = 1000;
  project.drawing.sketch.height_px = 1000;
  project.drawing.sketch.strokes = {std::move(stroke)};
  project.drawing.stray = {0};
  return project;
}

TEST(GiveRoom, WhatLiesOnTheCanvasStays) {
  auto const project = project_with(line({0, 5}, {1000, 900}));
  EXPECT_EQ(give_room(project), project);
  EXPECT_EQ(give_room({}), Project{});
}

TEST(GiveRoom, TheCanvasGrowsToTheRightWithoutMovingAnything) {
  auto const project = project_with(line({10, 10}, {1200.5, 20}));
  auto const roomy = give_room(project);
  EXPECT_EQ(roomy.drawing.sketch.strokes, project.drawing.sketch.strokes);
  EXPECT_EQ(roomy.drawing.sketch.width_px, 1217);
  EXPECT_EQ(roomy.drawing.sketch.height_px, 1000);
}

TEST(GiveRoom, WhatIsLeftOfItMovesOntoItWithAllElse) {
  auto project = project_with(line({-100, 10}, {50, -3.5}));
  project.drawing.choice.outside = {{5, 6}};
  project.pins.push_back({PinId{1}, LayerId{2}, Side::Front, {1, 2}, {3, 4}});
  project.clip.tracks.push_back({PinId{1}, {{0, {7, 8}}}, 0});
  auto const roomy = give_room(project);
  auto const& samples = roomy.drawing.sketch.strokes.front().samples;
  EXPECT_EQ(samples.front().position, (Vec2{16, 30}));
  EXPECT_EQ(samples.back().position, (Vec2{166, 16.5}));
  EXPECT_EQ(roomy.drawing.choice.outside.front(), (Vec2{121, 26}));
  EXPECT_EQ(roomy.pins.front().rest, (Vec2{117, 22}));
  EXPECT_EQ(roomy.pins.front().position, (Vec2{119, 24}));
  EXPECT_EQ(roomy.clip.tracks.front().keys.front().position, (Vec2{123, 28}));
  EXPECT_EQ(roomy.drawing.sketch.width_px, 1116);
}

TEST(GiveRoom, ATemplateHoldsTheCanvas) {
  auto project = project_with(line({-100, 10}, {50, 10}));
  project.template_picture = Picture(2, 2);
  EXPECT_EQ(give_room(project), project);
}

}  // namespace
}  // namespace inkflate
