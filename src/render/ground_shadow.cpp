// SPDX-License-Identifier: Apache-2.0
#include "render/ground_shadow.h"

#include <algorithm>

#include "geometry/rect.h"
#include "image/to_byte.h"

namespace inkflate {
namespace {

/// Height by width of the ellipse.
constexpr double kFlatness = 0.11;
/// In its middle, of 255.
constexpr double kDarkest = 70;

/// Puts black over a pixel.
void darken(Colour& pixel, double alpha) {
  double const below = (1 - alpha) * pixel.a / 255;
  double const keep = below / (alpha + below);
  auto const darker = [&](std::uint8_t value) { return to_byte(value * keep); };
  pixel = {darker(pixel.r), darker(pixel.g), darker(pixel.b), to_byte(255 * (alpha + below))};
}

}  // namespace

void draw_ground_shadow(DrawTriangles const& list, Picture& picture) {
  Rect box;
  for (auto const p : list.positions) box.include({p.x, p.y});
  if (box.is_empty()) return;
  double const radius_px = std::max(0.52 * box.width(), 1e-9);
  // The feet stand in it, not behind it.
  Vec2 const centre = {picture.width * 0.5 + box.centre().x,
                       picture.height * 0.5 - box.min.y - 0.25 * kFlatness * radius_px};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      Vec2 const d = (Vec2{x + 0.5, y + 0.5} - centre) / radius_px;
      double const share = 1 - d.x * d.x - d.y * d.y / (kFlatness * kFlatness);
      if (share > 0) darken(picture.at(x, y), kDarkest / 255 * share * share);
    }
  }
}

}  // namespace inkflate
