// SPDX-License-Identifier: Apache-2.0
#include "support/bend_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "document/apply.h"
#include "support/characters.h"
#include "support/editor_documents.h"
#include "support/extremes.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Document with_limb(Document const& document, std::string name, Vec2 from, Vec2 to,
                   double half_width_px) {
  return with_layer(document, limb_layer(std::move(name), from, to, half_width_px),
                    {line_stroke({from, lerp(from, to, 0.5), to})});
}

}  // namespace

Document jointed_document() {
  auto document =
      with_layer(empty_document(), drawn_layer("body", ellipse_contour({400, 450}, 160, 260)),
                 {line_stroke({{400, 300}, {400, 450}, {400, 600}}),
                  line_stroke({{470.30, 361.19}, {480, 400}, {489.70, 438.81}})});
  document = with_limb(document, "arm", {480, 400}, {720, 340}, 40);
  document = with_limb(document, "hand", {715, 341}, {860, 305}, 25);
  return with_limb(document, "leg", {430, 640}, {460, 860}, 50);
}

BendGrab body_at(Vec2 place) { return {kBody, {}, {}, place}; }

bool is_shared(Document const& a, Document const& b, LayerId layer) {
  return find_layer(a, layer) == find_layer(b, layer);
}

std::vector<Command> BendHand::drag(BendGrab const& what, Vec2 to, BendReach reach,
                                    std::optional<double> turn_rad) {
  auto const fault = session.grab(document, what, reach, options);
  EXPECT_FALSE(fault.has_value()) << fault->message;
  constexpr int moves = 8;
  for (int i = 1; i <= moves; ++i) {
    double const share = static_cast<double>(i) / moves;
    auto const turn = turn_rad ? std::optional(share * *turn_rad) : std::nullopt;
    session.drag(lerp(what.place, to, share), turn);
  }
  session.finish();
  auto commands = session.commands();
  apply_all(commands);
  session.release(commands.empty() ? nullptr : &document);
  return commands;
}

std::vector<Command> BendHand::drag_pin(LayerId layer, int pin, Vec2 to,
                                        std::optional<double> turn_rad) {
  auto const at = layer_of_hand(document, layer).bend_pins[static_cast<std::size_t>(pin)].position;
  return drag({layer, {}, pin, at}, to, {}, turn_rad);
}

void BendHand::set_pins(LayerId layer, std::vector<BendPin> pins) {
  apply_all({SetBendPins{layer, std::move(pins)}});
}

void BendHand::apply_all(std::vector<Command> const& commands) {
  if (commands.empty()) return;
  auto const result = inkflate::apply(document, commands);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  document = *result;
}

Layer const& layer_of_hand(Document const& document, LayerId layer) {
  return find_layer(document, layer)->layer;
}

double outline_distance(Document const& a, Document const& b, LayerId layer) {
  auto const& first = layer_of_hand(a, layer).outlines.front().pieces;
  auto const& second = layer_of_hand(b, layer).outlines.front().pieces;
  if (first.size() != second.size()) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      most = support::larger(most, distance(first[i].curve.control[k], second[i].curve.control[k]));
    }
  }
  return most;
}

double contour_distance(Layer const& a, Layer const& b) {
  auto const first = flatten(a.outlines.front(), 0.01);
  auto second = flatten(b.outlines.front(), 0.01);
  second.push_back(second.front());
  double most = 0;
  for (auto const p : first) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < second.size(); ++i) {
      least = std::min(least, squared_distance_to_segment(p, second[i - 1], second[i]));
    }
    most = support::larger(most, least);
  }
  return std::sqrt(most);
}

}  // namespace inkflate
