// SPDX-License-Identifier: Apache-2.0
#include "render/ground_shadow.h"

#include "image/to_byte.h"
#include "render/model_placement.h"

namespace inkflate {
namespace {

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
  auto const [centre, half_axes_px] = shadow_ellipse(box, picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      Vec2 const d = Vec2{x + 0.5, y + 0.5} - centre;
      Vec2 const reach = {d.x / half_axes_px.x, d.y / half_axes_px.y};
      double const share = 1 - squared_norm(reach);
      if (share > 0) darken(picture.at(x, y), kDarkest / 255 * share * share);
    }
  }
}

}  // namespace inkflate
