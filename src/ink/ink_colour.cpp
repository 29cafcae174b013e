// SPDX-License-Identifier: Apache-2.0
#include "ink/ink_colour.h"

#include <algorithm>
#include <vector>

#include "base/check.h"

namespace inkflate {
namespace {

/// Of the light that ink takes: blue must lose at most this share of what red loses, green no more than red. Teal, the
/// colour of help lines on the screen, is at 0.57; grey and black are at 1.
constexpr double kLargestBlueLoss = 0.65;
/// Paler marks have no colour that could be told from noise.
constexpr int kSmallestLoss = 30;

}  // namespace

bool is_blue(Colour colour) {
  int const red_loss = 255 - colour.r;
  int const green_loss = 255 - colour.g;
  int const blue_loss = 255 - colour.b;
  return red_loss >= kSmallestLoss && blue_loss <= kLargestBlueLoss * red_loss &&
         green_loss <= red_loss;
}

Colour median_colour(Picture const& picture, std::span<Vec2 const> points) {
  CHECK(!points.empty(), "no points to take a colour from");
  std::vector<std::uint8_t> channels[3];
  for (auto const p : points) {
    auto const pixel = picture.at(std::clamp(static_cast<int>(p.x), 0, picture.width - 1),
                                  std::clamp(static_cast<int>(p.y), 0, picture.height - 1));
    channels[0].push_back(pixel.r);
    channels[1].push_back(pixel.g);
    channels[2].push_back(pixel.b);
  }
  auto const middle = [](std::vector<std::uint8_t>& values) {
    auto const at = values.begin() + std::ssize(values) / 2;
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  return {middle(channels[0]), middle(channels[1]), middle(channels[2])};
}

}  // namespace inkflate
