// SPDX-License-Identifier: Apache-2.0
#include "editor/layer_looks.h"

#include <gtest/gtest.h>

#include "support/editor_documents.h"

namespace inkflate {
namespace {

Shared<DocumentLayer> const& only_layer(Document const& document) {
  return document.layers->front();
}

TEST(LayerLooks, WhatIsNotSeenChangesNothing) {
  LayerLooks looks;
  auto const document = with_disc(empty_document(), {100, 100}, 50);
  auto const look = looks.look(only_layer(document));
  EXPECT_EQ(looks.look(only_layer(document)), look);
  auto const renamed = with_changed(document, LayerId{1}, [](Layer& layer) {
    layer.name = "ear";
    layer.thickness = 3;
    layer.is_locked = layer.is_hidden = true;
  });
  EXPECT_EQ(looks.look(only_layer(renamed)), look);
}

TEST(LayerLooks, AnotherFillIsAnotherLook) {
  LayerLooks looks;
  auto const document = with_disc(empty_document(), {100, 100}, 50);
  auto const look = looks.look(only_layer(document));
  auto const filled = with_changed(document, LayerId{1}, [](Layer& layer) {
    layer.fill = Colour{1, 2, 3};
  });
  EXPECT_NE(looks.look(only_layer(filled)), look);
  EXPECT_NE(looks.look(only_layer(document)), look);
}

TEST(LayerLooks, NumbersOfForgottenLayersDoNotComeAgain) {
  LayerLooks looks;
  auto const document = with_disc(empty_document(), {100, 100}, 50);
  auto const look = looks.look(only_layer(document));
  looks.keep_only(empty_document());
  EXPECT_GT(looks.look(only_layer(document)), look);
}

}  // namespace
}  // namespace inkflate
