// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "document/apply.h"
#include "support/editor_documents.h"
#include "support/random_commands.h"
#include "support/refusals.h"

namespace inkflate {
namespace {

Shared<Picture> picture(int width, int height) {
  return std::make_shared<Picture const>(width, height);
}

TEST(SetTemplate, IsSharedAndMayBeTakenAway) {
  auto const sheet = picture(3, 4);
  auto const after = inkflate::apply(empty_document(), SetTemplate{sheet});
  ASSERT_TRUE(after);
  EXPECT_EQ(after->template_picture, sheet);
  EXPECT_FALSE(is_blank(*after));
  auto const without = inkflate::apply(*after, SetTemplate{});
  ASSERT_TRUE(without);
  EXPECT_EQ(without->template_picture, nullptr);
}

TEST(SetTemplate, RefusesEmptyAndHugePictures) {
  EXPECT_EQ(test::refusal(empty_document(), SetTemplate{}), ErrorCode::NothingThere);
  EXPECT_EQ(test::refusal(empty_document(), SetTemplate{picture(0, 5)}), ErrorCode::TooLarge);
  EXPECT_EQ(test::refusal(empty_document(), SetTemplate{picture(16385, 1)}), ErrorCode::TooLarge);
  EXPECT_EQ(test::refusal(empty_document(), SetTemplate{picture(1, 16385)}), ErrorCode::TooLarge);
  EXPECT_EQ(test::refusal(empty_document(), SetTemplate{picture(5, 0)}), ErrorCode::TooLarge);
  // Refused by its sides alone, so it needs no pixels.
  Picture vast;
  vast.width = vast.height = 8001;
  auto const shared = std::make_shared<Picture const>(std::move(vast));
  EXPECT_EQ(test::refusal(empty_document(), SetTemplate{shared}), ErrorCode::TooLarge);
}

TEST(SetCanvas, HasAtLeastOnePixel) {
  auto const after = inkflate::apply(empty_document(), SetCanvas{1, 16384});
  ASSERT_TRUE(after);
  EXPECT_EQ(after->width_px, 1);
  EXPECT_EQ(after->height_px, 16384);
  EXPECT_EQ(test::refusal(*after, SetCanvas{1, 16384}), ErrorCode::NothingThere);
  for (double const side_px : {0.5, 16385.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(test::refusal(*after, SetCanvas{side_px, 5}), ErrorCode::BadOption);
    EXPECT_EQ(test::refusal(*after, SetCanvas{5, side_px}), ErrorCode::BadOption);
  }
}

TEST(Replace, RefusesDocumentsThatNoFileCouldHold) {
  auto const many_layers = [](std::size_t count) {
    auto document = with_disc(empty_document(), {5, 5}, 2);
    document.layers =
        std::make_shared<std::vector<Shared<DocumentLayer>> const>(count, document.layers->front());
    return document;
  };
  EXPECT_TRUE(inkflate::apply(empty_document(), Replace{many_layers(DocumentLimits::kLayers)}));
  EXPECT_EQ(test::refusal(empty_document(), Replace{many_layers(DocumentLimits::kLayers + 1)}),
            ErrorCode::TooLarge);
  auto late = empty_document();
  late.next_id = DocumentLimits::kIds + 1;
  EXPECT_EQ(test::refusal(empty_document(), Replace{late}), ErrorCode::TooLarge);
}

TEST(Replace, IsTheOtherDocument) {
  auto const other = with_disc(empty_document(), {5, 5}, 2);
  auto const after = inkflate::apply(empty_document(), Replace{other});
  ASSERT_TRUE(after);
  EXPECT_EQ(after->layers, other.layers);
  EXPECT_EQ(after->next_id, other.next_id);
  EXPECT_EQ(test::refusal(other, Replace{}), ErrorCode::BadInput);
}

TEST(RandomCommands, EveryKindIsAllowedAndRefused) {
  Rng rng(5);
  std::array<int, test::kCommandKinds> allowed = {};
  std::array<int, test::kCommandKinds> refused = {};
  for (int round = 0; round < 100; ++round) {
    auto const document = test::random_document(rng);
    for (int kind = 0; kind < test::kCommandKinds; ++kind) {
      auto const sensible = test::random_command(rng, document, kind, test::Wish::Sensible);
      auto const hostile = test::random_command(rng, document, kind, test::Wish::Hostile);
      ASSERT_EQ(static_cast<int>(sensible.index()), kind);
      ASSERT_EQ(static_cast<int>(hostile.index()), kind);
      if (inkflate::apply(document, sensible)) ++allowed[static_cast<std::size_t>(kind)];
      if (!inkflate::apply(document, hostile)) ++refused[static_cast<std::size_t>(kind)];
    }
  }
  for (std::size_t kind = 0; kind < allowed.size(); ++kind) {
    EXPECT_GT(allowed[kind], 20) << "kind " << kind;
    EXPECT_GT(refused[kind], 5) << "kind " << kind;
  }
}

}  // namespace
}  // namespace inkflate
