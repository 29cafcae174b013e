// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "base/rng.h"
#include "image/grid2.h"

namespace inkflate::test {

/// As a phone sees a sheet: half as bright at the right as at the left, a soft round shadow, and grain.
inline Picture photographed(Picture picture, double noise, unsigned seed) {
  Rng rng(seed);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      double const u = static_cast<double>(x) / picture.width - 0.6;
      double const v = static_cast<double>(y) / picture.height - 0.5;
      double const shadow = std::clamp((u * u + v * v) * 10, 0.0, 1.0);
      double const light = (0.8 - 0.4 * u) * (0.8 + 0.2 * shadow);
      double const grain = noise * (rng.uniform(-1, 1) + rng.uniform(-1, 1));
      auto const seen = [&](std::uint8_t value) {
        return static_cast<std::uint8_t>(std::clamp(value * light + grain, 0.0, 255.0));
      };
      auto& pixel = picture.at(x, y);
      pixel = {seen(pixel.r), seen(pixel.g), seen(pixel.b), 255};
    }
  }
  return picture;
}

}  // namespace inkflate::test
