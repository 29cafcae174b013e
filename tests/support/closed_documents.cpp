// SPDX-License-Identifier: Apache-2.0
#include "support/closed_documents.h"

#include <gtest/gtest.h>

#include "document/apply.h"

namespace inkflate {

Document must(Result<Document> const& result) {
  EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message);
  return result ? *result : empty_document();
}

Document drawn(Document document, std::vector<Stroke> const& strokes, LayerId layer) {
  for (auto const& stroke : strokes) document = must(apply(document, AddStroke{stroke, layer}));
  return document;
}

Document drawn(std::vector<Stroke> const& strokes) { return drawn(empty_document(), strokes); }

ClosedDocument closed(Document const& document) {
  auto const result = close_document(document);
  EXPECT_TRUE(result.has_value());
  return result ? *result : ClosedDocument{};
}

Document simplified(Document const& document) {
  auto const result = closed(document);
  EXPECT_TRUE(result.command.has_value());
  return result.command ? must(apply(document, *result.command)) : document;
}

Layer const& layer_at(Document const& document, int index) {
  return (*document.layers)[index]->layer;
}

double area(Layer const& layer) { return signed_area(flatten(layer.outlines.front(), 0.1)); }

}  // namespace inkflate
