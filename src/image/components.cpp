// SPDX-License-Identifier: Apache-2.0
#include "image/components.h"

#include <array>

namespace inkflate {
namespace {

struct Step {
  int dx = 0;
  int dy = 0;
};
// Those across sides first.
constexpr std::array<Step, 8> kSteps = {Step{1, 0}, {0, 1},  {-1, 0},  {0, -1},
                                        {1, 1},     {-1, 1}, {-1, -1}, {1, -1}};

struct Pixel {
  int x = 0;
  int y = 0;
};

}  // namespace

Components connected_components(Mask const& mask, Neighbours neighbours) {
  Components result{Grid2<int>(mask.width, mask.height, -1), {}};
  std::size_t const step_count = neighbours == Neighbours::Four ? 4 : 8;
  std::vector<Pixel> open;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) == 0 || result.labels.at(x, y) >= 0) continue;
      auto const label = static_cast<int>(result.areas.size());
      result.areas.push_back(0);
      result.labels.at(x, y) = label;
      open.push_back(Pixel{x, y});
      while (!open.empty()) {
        auto const pixel = open.back();
        open.pop_back();
        ++result.areas.back();
        for (std::size_t i = 0; i < step_count; ++i) {
          int const nx = pixel.x + kSteps[i].dx;
          int const ny = pixel.y + kSteps[i].dy;
          if (!mask.contains(nx, ny) || mask.at(nx, ny) == 0) continue;
          if (result.labels.at(nx, ny) >= 0) continue;
          result.labels.at(nx, ny) = label;
          open.push_back(Pixel{nx, ny});
        }
      }
    }
  }
  return result;
}

Mask without_specks(Mask mask, long long smallest_px) {
  auto const components = connected_components(mask, Neighbours::Eight);
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    int const label = components.labels.values[i];
    if (label >= 0 && components.areas[static_cast<std::size_t>(label)] < smallest_px) {
      mask.values[i] = 0;
    }
  }
  return mask;
}

}  // namespace inkflate
