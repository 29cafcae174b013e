// SPDX-License-Identifier: Apache-2.0
#include "support/random_document.h"

#include <iterator>
#include <utility>

#include "base/check.h"
#include "support/random_drawing.h"

namespace inkflate::test {
namespace {

/// Pins, a clip and states of the layers for what random_drawing has made.
void dress(Rng& rng, Project& project) {
  for (auto& layer : project.drawing.layers) {
    layer.id = static_cast<LayerId>(project.next_id++);
    layer.is_open = rng.below(3) == 0;
    layer.is_locked = rng.below(6) == 0;
    layer.is_hidden = rng.below(6) == 0;
    layer.choice = random_choice(rng);
    if (!layer.details.empty() && rng.below(2) == 0) {
      layer.noise.push_back(layer.details.back());
      layer.details.pop_back();
    }
  }
  project.drawing.choice = random_choice(rng);
  project.clip.length_s = rng.below(2) == 0 ? 0 : rng.uniform(0.5, 5);
  int const layer_count = static_cast<int>(std::ssize(project.drawing.layers));
  for (int i = layer_count > 0 ? rng.below(4) : 0; i > 0; --i) {
    auto const& layer = project.drawing.layers[static_cast<std::size_t>(rng.below(layer_count))];
    auto const id = static_cast<PinId>(project.next_id++);
    project.pins.push_back({id, layer.id, rng.below(2) == 0 ? Side::Front : Side::Back,
                            point_on_sheet(rng), point_on_sheet(rng)});
    if (rng.below(2) == 0) {
      project.clip.tracks.push_back({id, {{0, point_on_sheet(rng)}}, rng.uniform(-1, 1)});
    }
  }
  if (rng.below(3) == 0) project.template_picture = Picture(2, 3, Colour{1, 2, 3});
}

}  // namespace

Vec2 point_on_sheet(Rng& rng) { return {rng.uniform(0, kSheetPx), rng.uniform(0, kSheetPx)}; }

CloseChoice random_choice(Rng& rng) {
  CloseChoice choice;
  if (rng.below(2) == 0) choice.gap_px = rng.uniform(0.5, 50);
  for (auto* marks : {&choice.outside, &choice.inside}) {
    for (int i = rng.below(3); i > 0; --i) marks->push_back(point_on_sheet(rng));
  }
  return choice;
}

Document random_document(Rng& rng) {
  Project project = {random_drawing(rng)};
  dress(rng, project);
  auto document = make_document(project);
  CHECK(document.has_value(), "a random document is a document");
  return std::move(document).value();
}

}  // namespace inkflate::test
