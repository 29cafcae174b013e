// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/artist.h"

namespace inkflate {
namespace {

constexpr Vec2 kMiddle = {500, 500};

Artist with_disc() {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  return artist;
}

TEST(ViewHandlers, TwoShowsTheModelAndOneTheDrawing) {
  auto artist = with_disc();
  artist.key("2");
  EXPECT_EQ(artist.state().view.mode, Mode::Inflate);
  auto const scene = artist.engine().scene();
  ASSERT_TRUE(scene.model);
  EXPECT_FALSE(scene.model->model->mesh.triangles.empty());
  artist.key("3");
  EXPECT_EQ(artist.state().view.mode, Mode::Animate);
  artist.key("1");
  EXPECT_FALSE(artist.engine().scene().model);
}

TEST(ViewHandlers, RoughStrokesAreClosedOnTheWayToTheModel) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("2");
  EXPECT_EQ(artist.state().view.mode, Mode::Inflate);
  EXPECT_EQ(artist.state().undo_name, "simplify");
}

TEST(ViewHandlers, WithoutPartsThereIsNoModel) {
  Artist artist;
  artist.key("2");
  EXPECT_EQ(artist.state().view.mode, Mode::Draw);
  EXPECT_TRUE(artist.has_said(Word::NothingToInflate));
}

TEST(ViewHandlers, AModelThatCannotBeMadeIsSaidAndTheDrawingShown) {
  bool is_cancelled = false;
  Artist artist({{}, [&] { return is_cancelled; }});
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  is_cancelled = true;
  artist.key("2");
  EXPECT_EQ(artist.state().view.mode, Mode::Draw);
  EXPECT_TRUE(artist.has_said(Word::Cancelled));
  is_cancelled = false;
  artist.key("2");
  EXPECT_EQ(artist.state().view.mode, Mode::Inflate);
}

TEST(ViewHandlers, TheModelIsMadeOnceForTheSameParts) {
  auto artist = with_disc();
  artist.key("2");
  auto const id = artist.engine().scene().model->id;
  artist.key("1");
  artist.key("2");
  EXPECT_EQ(artist.engine().scene().model->id, id);
  artist.key("1");
  artist.act("select_all");
  artist.act("thickness", "4");
  artist.key("2");
  EXPECT_NE(artist.engine().scene().model->id, id);
}

TEST(ViewHandlers, UndoInTheModelGoesBackToTheDrawing) {
  auto artist = with_disc();
  artist.key("2");
  artist.key("z", {.is_ctrl = true});
  EXPECT_EQ(artist.state().view.mode, Mode::Draw);
  EXPECT_TRUE(artist.state().has_rough_strokes);
}

TEST(ViewHandlers, ArrowsAndDragsTurnTheModel) {
  auto artist = with_disc();
  artist.key("2");
  artist.key("ArrowRight");
  EXPECT_NEAR(artist.state().view.model.turn_rad, 0.2618, 1e-4);
  artist.key("ArrowLeft");
  EXPECT_NEAR(artist.state().view.model.turn_rad, 0, 1e-12);
  for (int i = 0; i < 20; ++i) artist.key("ArrowUp");
  EXPECT_LE(artist.state().view.model.tilt_rad, 1.5708);
  artist.key("ArrowDown");
  artist.act("reset_turn");
  EXPECT_EQ(artist.state().view.model.tilt_rad, 0);
  artist.draw({{500, 500}, {600, 520}});
  EXPECT_NE(artist.state().view.model.turn_rad, 0);
  EXPECT_TRUE(artist.document().loose.is_empty());
}

TEST(ViewHandlers, LooksAreChosenByName) {
  auto artist = with_disc();
  artist.key("2");
  for (auto const* const name : {"matcap", "lines", "textured"}) artist.act("look", name);
  EXPECT_EQ(artist.state().view.shading, Shading::Textured);
  artist.act("look", "gold");
  EXPECT_TRUE(artist.has_said(Word::CannotDo));
}

TEST(ViewHandlers, ZoomKeysZoomThePaperOrTheModel) {
  auto artist = with_disc();
  artist.key("+");
  EXPECT_NEAR(artist.state().view.camera.zoom, 1.25, 1e-12);
  artist.key("-");
  artist.key("-");
  artist.key("0", {.is_ctrl = true});
  EXPECT_NEAR(artist.state().view.camera.zoom, 1, 1e-12);
  artist.key("2");
  artist.key("+");
  EXPECT_NEAR(artist.state().view.model.zoom, 1.25, 1e-12);
  artist.key("0", {.is_ctrl = true});
  EXPECT_EQ(artist.state().view.model.zoom, 1);
}

TEST(ViewHandlers, FitShowsAllAndSelectionWhatIsSelected) {
  auto artist = with_disc();
  artist.act("zoom_fit");
  EXPECT_GT(artist.state().view.camera.zoom, 1.5);
  artist.act("zoom_actual");
  artist.act("select_all");
  artist.act("zoom_selection");
  auto const camera = artist.state().view.camera;
  EXPECT_NEAR(camera.centre.x, 500, 2);
  EXPECT_GT(camera.zoom, 1.5);
  Artist empty;
  empty.act("zoom_fit");
  EXPECT_GT(empty.state().view.camera.zoom, 0.5);
}

TEST(ViewHandlers, AShownPlaceFillsTheView) {
  auto artist = with_disc();
  artist.act("show_place", "100,200,50,40");
  auto const camera = artist.state().view.camera;
  EXPECT_NEAR(camera.centre.x, 125, 1e-9);
  EXPECT_NEAR(camera.centre.y, 220, 1e-9);
  EXPECT_GT(camera.zoom, 5);
  for (auto const* const wrong : {"", "1", "1,2", "1,2,3", "1,2,3,x", "nan,0,1,1"}) {
    artist.act("show_place", wrong);
    EXPECT_EQ(artist.state().view.camera, camera) << wrong;
  }
}

TEST(ViewHandlers, MirrorAndGridTurnRound) {
  auto artist = with_disc();
  artist.key("m");
  EXPECT_TRUE(artist.state().view.camera.is_mirrored);
  artist.key("m");
  EXPECT_FALSE(artist.state().view.camera.is_mirrored);
  artist.act("grid");
  EXPECT_FALSE(artist.state().view.has_grid);
}

TEST(ToolHandlers, KeysChooseTools) {
  Artist artist;
  std::vector<std::pair<std::string, Tool>> const keys = {
      {"l", Tool::HelpLine}, {"e", Tool::Eraser}, {"o", Tool::Mark}, {"d", Tool::Deform},
      {"v", Tool::Select},   {"h", Tool::Hand},   {"b", Tool::Brush}};
  for (auto const& [key, tool] : keys) {
    artist.key(key);
    EXPECT_EQ(artist.state().view.tool, tool) << key;
  }
}

TEST(ToolHandlers, BracketsChangeTheSizeOfTheToolInHand) {
  Artist artist;
  artist.key("]");
  EXPECT_NEAR(artist.state().view.settings.brush_px, 3.75, 1e-12);
  EXPECT_EQ(artist.state().view.settings.eraser_px, 12);
  artist.key("e");
  artist.key("[");
  EXPECT_NEAR(artist.state().view.settings.eraser_px, 9.6, 1e-12);
  for (int i = 0; i < 60; ++i) artist.key("[");
  EXPECT_EQ(artist.state().view.settings.eraser_px, ToolSettings::kLeastEraserPx);
  artist.key("b");
  for (int i = 0; i < 60; ++i) artist.key("]");
  EXPECT_EQ(artist.state().view.settings.brush_px, ToolSettings::kLargestBrushPx);
}

TEST(ToolHandlers, SettingsTakeValuesInTheirRange) {
  Artist artist;
  artist.act("brush_size", "5");
  artist.act("eraser_size", "20");
  artist.act("smoothing", "0.25");
  artist.act("ink_colour", "#ff0080");
  auto const settings = artist.state().view.settings;
  EXPECT_EQ(settings.brush_px, 5);
  EXPECT_EQ(settings.eraser_px, 20);
  EXPECT_EQ(settings.smoothing, 0.25);
  EXPECT_EQ(settings.ink, (Colour{255, 0, 128}));
  for (auto const* const action : {"brush_size", "eraser_size", "smoothing", "ink_colour"}) {
    for (auto const* const value : {"", "-3", "nan", "1e999", "a lot"}) artist.act(action, value);
  }
  EXPECT_EQ(artist.state().view.settings, settings);
}

TEST(FileHandlers, LanguageAndSingleKeysAreChosen) {
  Artist artist;
  artist.act("language", "cs");
  EXPECT_EQ(artist.state().language, Language::Czech);
  artist.act("language", "xx");
  EXPECT_EQ(artist.state().language, Language::Czech);
  artist.act("language", "en");
  artist.act("single_keys", "off");
  artist.key("e");
  EXPECT_EQ(artist.state().view.tool, Tool::Brush);
  artist.act("single_keys", "maybe");
  artist.act("single_keys", "on");
  artist.key("e");
  EXPECT_EQ(artist.state().view.tool, Tool::Eraser);
}

}  // namespace
}  // namespace inkflate
