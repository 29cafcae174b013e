// SPDX-License-Identifier: Apache-2.0
#include "support/artist.h"

#include <algorithm>

#include "base/check.h"
#include "geometry/trig.h"
#include "io/document_hash.h"

namespace inkflate {

bool Artist::has_said(Word word) const {
  return std::any_of(messages.begin(), messages.end(),
                     [&](Message const& message) { return message.word == word; });
}

Layer const& Artist::only_layer() const {
  auto const& layers = *document().layers;
  CHECK(layers.size() == 1, "there is one layer");
  return layers[0]->layer;
}

std::uint64_t Artist::hash() const { return document_hash(to_project(document())); }

void Artist::draw_circle(Vec2 centre, double radius, double gap_px, PointerButton button) {
  constexpr int points = 24;
  double const gap_rad = gap_px / radius;
  for (int half = 0; half < 2; ++half) {
    std::vector<Vec2> line;
    for (int i = 0; i <= points; ++i) {
      double const share = static_cast<double>(i) / points;
      auto const turn = sin_cos(kPi * half + gap_rad / 2 + (kPi - gap_rad) * share);
      line.push_back(centre + radius * Vec2{turn.cos, turn.sin});
    }
    draw(line, button);
  }
}

}  // namespace inkflate
