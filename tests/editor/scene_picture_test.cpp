// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "document/apply.h"
#include "render/palette.h"
#include "support/scenes.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr Colour kBlack = {0, 0, 0};

int darkness(Colour colour) { return 765 - colour.r - colour.g - colour.b; }

bool is_near(Colour a, Colour b, int tolerance) {
  return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance &&
         std::abs(a.b - b.b) <= tolerance;
}

/// How many pixels of one colour there are.
int count(Picture const& picture, Colour colour) {
  int number = 0;
  for (auto const pixel : picture.values) number += pixel == colour ? 1 : 0;
  return number;
}

Document filled(Document const& document, Colour colour) {
  return with_changed(document, layer_order(document).back(),
                      [&](Layer& layer) { layer.fill = colour; });
}

/// A red disc and, nearer, a green one that covers its right half.
Document two_discs() {
  auto const far = filled(with_disc(empty_document(), {150, 200}, 80), {200, 40, 40});
  return filled(with_disc(far, {230, 200}, 80), {40, 200, 40});
}

TEST(ScenePicture, AnEmptyDocumentIsPaper) {
  SceneMaker maker;
  EXPECT_EQ(maker.picture(empty_document()), Picture(400, 400, palette::kPaper));
  maker.view.has_grid = true;
  auto const picture = maker.picture(empty_document());
  int const paper = count(picture, palette::kPaper);
  EXPECT_GT(paper, 140'000);
  EXPECT_LT(paper, 400 * 400);
}

TEST(ScenePicture, NearerLayersHideFartherAndTheirInkShinesThrough) {
  SceneMaker maker;
  auto const picture = maker.picture(two_discs());
  EXPECT_EQ(picture.at(90, 200), (Colour{200, 40, 40}));
  EXPECT_EQ(picture.at(200, 200), (Colour{40, 200, 40}));
  // The rim of the red disc where the green one hides it: a quarter of ink.
  EXPECT_TRUE(is_near(picture.at(230, 200), {30, 150, 30}, 12)) << int{picture.at(230, 200).g};
  EXPECT_TRUE(is_near(picture.at(70, 200), kBlack, 40));
}

TEST(ScenePicture, FillsAreOpaque) {
  SceneMaker maker;
  auto const document = filled(two_discs(), {40, 200, 40, 0});
  EXPECT_EQ(maker.picture(document).at(200, 200), palette::kSkin);
}

TEST(ScenePicture, AHiddenLayerShowsNothing) {
  SceneMaker maker;
  auto const hide = [](Layer& layer) { layer.is_hidden = true; };
  auto document = two_discs();
  maker.view.selection = layer_order(document);
  for (auto const id : layer_order(document)) document = with_changed(document, id, hide);
  EXPECT_EQ(maker.picture(document), Picture(400, 400, palette::kPaper));
  auto const open = with_open(empty_document(), {line_stroke({{10, 10}, {300, 300}})});
  EXPECT_EQ(maker.picture(with_changed(open, LayerId{1}, hide)),
            Picture(400, 400, palette::kPaper));
}

TEST(ScenePicture, SelectionIsABlueLineInAWhiteHalo) {
  SceneMaker maker;
  auto const document = two_discs();
  auto const plain = maker.picture(document);
  EXPECT_EQ(count(plain, palette::kSelection), 0);
  maker.view.selection = {LayerId{1}};
  auto const selected = maker.picture(document);
  EXPECT_EQ(selected.at(70, 200), palette::kSelection);
  EXPECT_TRUE(is_near(selected.at(71, 200), palette::kHalo, 35));
  maker.view.selection.clear();
  maker.view.hover = LayerId{1};
  auto const hovered = maker.picture(document);
  EXPECT_GT(darkness(plain.at(70, 200)), 500);
  EXPECT_GT(hovered.at(70, 200).b, hovered.at(70, 200).r + 60);
  // An open layer without outlines is chosen along its strokes.
  maker.view.hover = LayerId::None;
  maker.view.selection = {LayerId{1}};
  auto const open = with_open(empty_document(), {line_stroke({{10, 100}, {300, 100}})});
  EXPECT_EQ(maker.picture(open).at(150, 100), palette::kSelection);
}

TEST(ScenePicture, TheFrameIsThereForTheSelectTool) {
  SceneMaker maker;
  maker.view.selection = {LayerId{1}};
  auto const without = maker.picture(two_discs());
  maker.view.tool = Tool::Select;
  auto const with = maker.picture(two_discs());
  // The middle of the square at the top left corner, and of the knob.
  EXPECT_EQ(without.at(70, 120), palette::kPaper);
  EXPECT_EQ(with.at(70, 120), palette::kHalo);
  EXPECT_GT(count(with, palette::kSelection), count(without, palette::kSelection));
  maker.view.selection.clear();
  EXPECT_EQ(count(maker.picture(two_discs()), palette::kSelection), 0);
}

TEST(ScenePicture, AMirroredViewIsAMirroredPicture) {
  SceneMaker maker;
  auto const document = with_loose(two_discs(), line_stroke({{20, 30}, {190, 77}, {300, 20}}));
  auto const straight = maker.picture(document);
  maker.view.camera = mirrored(maker.view.camera);
  auto const turned = maker.picture(document);
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) {
      ASSERT_TRUE(is_near(straight.at(x, y), turned.at(399 - x, y), 3)) << x << ' ' << y;
    }
  }
}

TEST(ScenePicture, LinesAreSeenFromAnyDistance) {
  SceneMaker maker;
  maker.view.camera.zoom = Camera::kLeastZoom;
  maker.view.camera.centre = {5000, 25};
  auto const loose = with_loose(empty_document(), line_stroke({{0, 0}, {9000, 0}, {9000, 50}}));
  EXPECT_GT(darkness(maker.picture(loose).at(200, 199)), 250);
  auto const disc = with_disc(empty_document(), {5000, 25}, 4000);
  auto const picture = maker.picture(disc);
  int darkest = 0;
  for (int x = 0; x < 400; ++x) darkest = std::max(darkest, darkness(picture.at(x, 200)));
  EXPECT_GT(darkest, 250);
}

TEST(ScenePicture, OutlinesAreNoBeltsCloseUp) {
  SceneMaker maker;
  maker.view.camera.zoom = Camera::kLargestZoom;
  maker.view.camera.centre = {120, 200};
  auto const picture = maker.picture(with_disc(empty_document(), {200, 200}, 80));
  int dark = 0;
  for (int x = 0; x < 400; ++x) dark += darkness(picture.at(x, 200)) > 600 ? 1 : 0;
  EXPECT_GT(dark, 10);
  EXPECT_LT(dark, 20);
}

TEST(ScenePicture, LooseStrokesShowWhatTheyAre) {
  SceneMaker maker;
  auto stroke = line_stroke({{10, 50.5}, {390, 50.5}});
  stroke.width_px = 5;
  auto const near = maker.picture(with_loose(empty_document(), stroke)).at(200, 50);
  EXPECT_EQ(near, kBlack);
  stroke.depth = StrokeDepth::Far;
  auto const far = maker.picture(with_loose(empty_document(), stroke)).at(200, 50);
  EXPECT_LT(darkness(far), 400);
  EXPECT_GT(darkness(far), 150);
  stroke.depth = StrokeDepth::Near;
  stroke.kind = StrokeKind::HelpLine;
  auto const help = maker.picture(with_loose(empty_document(), stroke));
  EXPECT_EQ(help.at(12, 50), palette::kHelpLine);
  EXPECT_GT(count(help, palette::kPaper),
            count(maker.picture(empty_document()), palette::kPaper) - 1400);
}

TEST(ScenePicture, AnOpenLayerShowsItsStrokesOverItsPaleOutlines) {
  SceneMaker maker;
  auto const disc = with_disc(empty_document(), {200, 200}, 80);
  auto const open = with_changed(disc, LayerId{1}, [](Layer& layer) { layer.is_open = true; });
  auto const picture = maker.picture(open);
  EXPECT_TRUE(is_near(picture.at(120, 200), kBlack, 60));
  EXPECT_NE(picture.at(200, 200), palette::kPaper);
  EXPECT_LT(darkness(picture.at(200, 200)), 120);
  // With no stroke left, what it was is still faintly there.
  auto const redrawn = apply(disc, RedrawLayer{LayerId{1}});
  ASSERT_TRUE(redrawn.has_value());
  auto const ghost = darkness(maker.picture(*redrawn).at(120, 200));
  EXPECT_GT(ghost, 60);
  EXPECT_LT(ghost, 400);
}

TEST(ScenePicture, ThePreviewLiesUnderTheInkAndItsBridgesOverIt) {
  SceneMaker maker;
  auto stroke = line_stroke({{50, 100.5}, {350, 100.5}});
  stroke.width_px = 5;
  auto const document = with_loose(empty_document(), stroke);
  maker.preview.contours = {{{50, 50}, {350, 50}, {350, 150}, {50, 150}}};
  maker.preview.closings = {{{100, 100.5}, {300, 100.5}}, {}};
  auto const picture = maker.picture(document);
  EXPECT_NE(picture.at(200, 70), palette::kPaper);
  EXPECT_EQ(picture.at(70, 100), kBlack);
  EXPECT_GT(count(picture, palette::kClosing), 50);
}

TEST(ScenePicture, TheLineBeingDrawnAndTheBoxAreShown) {
  SceneMaker maker;
  ToolDrawing drawing;
  maker.tool = drawing;
  EXPECT_TRUE(maker.scene(empty_document()).chunks.empty());
  drawing.smooth = line_stroke({{50, 100.5}, {350, 100.5}});
  drawing.smooth.width_px = 4;
  maker.tool = drawing;
  EXPECT_EQ(maker.picture(empty_document()).at(200, 100), kBlack);
  maker.tool = ToolBoxing{{300, 50}, {100, 250}, {}};
  auto const box = maker.picture(empty_document());
  EXPECT_EQ(box.at(50, 100), palette::kPaper);
  EXPECT_NE(box.at(200, 100), palette::kPaper);
}

TEST(ScenePicture, MarksHaveSignsWhereSomethingIsRough) {
  SceneMaker maker;
  auto document = with_loose(empty_document(), line_stroke({{10, 10}, {20, 10}}));
  auto choice = *document.choice;
  choice.inside = {{100, 100}, {1e6, 1e6}};
  choice.outside = {{300, 100}};
  document.choice = std::make_shared<CloseChoice const>(choice);
  auto const picture = maker.picture(document);
  EXPECT_EQ(picture.at(100, 97), palette::kHelpLine);  // the upper end of a plus
  EXPECT_EQ(picture.at(300, 97), palette::kHalo);
  EXPECT_EQ(picture.at(297, 100), palette::kClosing);
  // Without loose strokes their marks say nothing; those of closed layers are there for the Mark tool.
  document.loose = {};
  EXPECT_TRUE(maker.scene(document).chunks.empty());
  document = with_changed(with_disc(document, {200, 250}, 60), LayerId{1},
                          [&](Layer& layer) { layer.choice = choice; });
  EXPECT_EQ(maker.picture(document).at(297, 100), palette::kPaper);
  maker.view.tool = Tool::Mark;
  EXPECT_EQ(maker.picture(document).at(297, 100), palette::kClosing);
}

TEST(ScenePicture, TheTemplateLiesPaleInTheMiddleOfTheCanvas) {
  SceneMaker maker;
  auto document = empty_document();
  document.width_px = 400;
  document.height_px = 400;
  document.template_picture = std::make_shared<Picture const>(40, 20, kBlack);
  auto const picture = maker.picture(document);
  Colour const pale = {151, 149, 145};  // 60 % of the paper
  EXPECT_TRUE(is_near(picture.at(200, 200), pale, 1));
  EXPECT_TRUE(is_near(picture.at(5, 105), pale, 1));
  EXPECT_EQ(picture.at(200, 90), palette::kPaper);
  document.template_picture = std::make_shared<Picture const>();
  EXPECT_TRUE(maker.scene(document).chunks.empty());
}

TEST(ScenePicture, DetailsLieOnTheirLayerAndHelpLinesDoNot) {
  SceneMaker maker;
  auto detail = line_stroke({{180, 200.5}, {220, 200.5}});
  detail.width_px = 4;
  detail.colour = {180, 0, 90};
  auto help = detail;
  help.kind = StrokeKind::HelpLine;
  for (auto& sample : help.samples) sample.position.y += 20;
  Layer layer;
  layer.outlines = {circle_outline({200, 200}, 80)};
  auto document =
      with_layer(empty_document(), layer, {circle_stroke({200, 200}, 80), detail, help});
  document = with_changed(document, LayerId{1}, [](Layer& changed) {
    changed.strokes = {0};
    changed.details = {1, 2};
  });
  auto const picture = maker.picture(document);
  EXPECT_EQ(picture.at(200, 200), detail.colour);
  EXPECT_EQ(picture.at(200, 220), palette::kSkin);
  // A layer without outlines has no area, but it may have details.
  document = with_changed(document, LayerId{1}, [](Layer& changed) { changed.outlines.clear(); });
  EXPECT_EQ(maker.picture(document).at(200, 200), detail.colour);
}

}  // namespace
}  // namespace inkflate
