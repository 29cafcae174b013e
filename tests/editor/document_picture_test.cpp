// SPDX-License-Identifier: Apache-2.0
#include "editor/document_picture.h"

#include <gtest/gtest.h>

#include "render/palette.h"
#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr Colour kClear = {0, 0, 0, 0};

TEST(DocumentPicture, ALayerFillsItsPictureAndTheGroundIsClear) {
  auto const document = with_disc(empty_document(), {5000, -200}, 900);
  auto const picture = picture_of_layer(*document.layers->front(), 64);
  EXPECT_EQ(picture.width, 64);
  EXPECT_EQ(picture.height, 64);
  EXPECT_EQ(picture.at(32, 32), palette::kSkin);
  EXPECT_EQ(picture.at(0, 0), kClear);
  EXPECT_EQ(picture.at(0, 32), kClear);
  EXPECT_NE(picture.at(5, 32), kClear);
}

TEST(DocumentPicture, AHiddenLayerIsShownInItsOwnPictureOnly) {
  auto const document = with_changed(with_disc(empty_document(), {50, 50}, 40), LayerId{1},
                                     [](Layer& layer) { layer.is_hidden = true; });
  EXPECT_EQ(picture_of_layer(*document.layers->front(), 32).at(16, 16), palette::kSkin);
  EXPECT_EQ(picture_of_document(document, 32), Picture(32, 32, palette::kPaper));
}

TEST(DocumentPicture, RoughStrokesAreInThePictureOfTheDocument) {
  auto const document = with_loose(empty_document(), line_stroke({{100, 100}, {300, 300}}));
  auto const picture = picture_of_document(document, 100);
  EXPECT_NE(picture.at(50, 50), palette::kPaper);
  EXPECT_EQ(picture.at(80, 20), palette::kPaper);
}

TEST(DocumentPicture, SidesStayWithinTheirLimits) {
  EXPECT_EQ(picture_of_document(empty_document(), -5).width, kLeastPictureSidePx);
  EXPECT_EQ(picture_of_document(empty_document(), 1'000'000).width, kLargestPictureSidePx);
}

}  // namespace
}  // namespace inkflate
