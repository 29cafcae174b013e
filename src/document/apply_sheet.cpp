// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "document/apply.h"
#include "document/apply_one.h"
#include "document/check_values.h"
#include "document/edit_layer.h"

namespace inkflate {
namespace {

constexpr int kLongestSidePx = 16384;
constexpr std::int64_t kMostPixels = 64'000'000;

}  // namespace

Result<Document> apply_one(Document const& document, SetTemplate const& command) {
  if (command.picture == document.template_picture) return no_change();
  if (command.picture != nullptr) {
    auto const& picture = *command.picture;
    bool const fits = picture.width >= 1 && picture.width <= kLongestSidePx &&
                      picture.height >= 1 && picture.height <= kLongestSidePx &&
                      std::int64_t{picture.width} * picture.height <= kMostPixels;
    if (!fits) {
      return Error{ErrorCode::TooLarge,
                   "a picture has to have 1 to 16384 px to each side, 64 megapixels at most"};
    }
  }
  auto result = document;
  result.template_picture = command.picture;
  return result;
}

Result<Document> apply_one(Document const& document, SetCanvas const& command) {
  bool const fits = is_within(command.width_px, 1, kLongestSidePx) &&
                    is_within(command.height_px, 1, kLongestSidePx);
  if (!fits) return Error{ErrorCode::BadOption, "a canvas has 1 to 16384 px to each side"};
  auto result = document;
  result.width_px = command.width_px;
  result.height_px = command.height_px;
  bool const is_same =
      result.width_px == document.width_px && result.height_px == document.height_px;
  if (is_same) return no_change();
  return result;
}

Result<Document> apply_one(Document const& /*document*/, Replace const& command) {
  auto const& next = command.document;
  bool const is_whole = next.groups && next.choice && next.layers && next.pins && next.clip;
  if (!is_whole) return Error{ErrorCode::BadInput, "a document that lacks a part"};
  bool const fits = stroke_count(next) <= DocumentLimits::kStrokes &&
                    std::ssize(*next.layers) <= DocumentLimits::kLayers &&
                    std::ssize(*next.pins) <= DocumentLimits::kPins &&
                    next.next_id <= DocumentLimits::kIds;
  if (!fits) {
    return Error{ErrorCode::TooLarge, "more than 1 000 000 strokes, 1024 layers or 1024 pins"};
  }
  return next;
}

}  // namespace inkflate
