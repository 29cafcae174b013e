// SPDX-License-Identifier: Apache-2.0
#include "render/sample_texture.h"

#include <algorithm>

namespace inkflate {
namespace {

/// A place between two texels, in 256 steps.
struct Between {
  int low = 0;
  int high = 0;
  int share = 0;  // of the high one
};

Between between(double place, int count) {
  double const last = count - 1;
  double const texel = std::clamp(place * count - 0.5, 0.0, last);
  int const low = static_cast<int>(texel);
  return {low, std::min(low + 1, count - 1), static_cast<int>((texel - low) * 256)};
}

}  // namespace

Rgb sample_texture(Picture const& picture, Vec2 place) {
  auto const x = between(place.x, picture.width);
  auto const y = between(place.y, picture.height);
  Colour const a = picture.at(x.low, y.low);
  Colour const b = picture.at(x.high, y.low);
  Colour const c = picture.at(x.low, y.high);
  Colour const d = picture.at(x.high, y.high);
  int const right = x.share;
  int const left = 256 - right;
  int const down = y.share;
  int const up = 256 - down;
  auto const channel = [&](int p, int q, int r, int s) {
    return ((p * left + q * right) * up + (r * left + s * right) * down) / 65536.0;
  };
  return {channel(a.r, b.r, c.r, d.r), channel(a.g, b.g, c.g, d.g), channel(a.b, b.b, c.b, d.b)};
}

}  // namespace inkflate
