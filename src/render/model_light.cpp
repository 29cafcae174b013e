// SPDX-License-Identifier: Apache-2.0
#include "render/model_light.h"

#include <algorithm>

namespace inkflate {
namespace {

// Directions to the key light and half way from it to the viewer.
constexpr Vec3 kKey = {-0.4558, 0.6077, 0.6503};
constexpr Vec3 kHalfWay = {-0.2508, 0.3345, 0.9084};

constexpr Rgb kClay = {232, 158, 116};
constexpr Rgb kClayShade = {128, 70, 68};
constexpr Rgb kClayLit = {255, 226, 196};
constexpr Rgb kShade = {0.70, 0.62, 0.68};
constexpr Rgb kLit = {1.03, 1.02, 1.00};
constexpr Rgb kPaper = {255, 253, 249};
constexpr Rgb kPaperShade = {226, 222, 220};

double smooth_step(double x) {
  double const t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// How much of the key light arrives; it reaches around the edge a little, as light from a large window does.
double key_light(Vec3 normal) { return smooth_step((dot(normal, kKey) + 0.55) / 1.45); }

/// The share of open sky below a surface that looks down.
double openness(Vec3 normal) {
  double const down = std::max(-normal.y, 0.0);
  return 1 - 0.22 * down * down;
}

double highlight(Vec3 normal, int doublings) {
  double power = std::max(dot(normal, kHalfWay), 0.0);
  for (int i = 0; i < doublings; ++i) power *= power;
  return power;
}

double rim(Vec3 normal) {
  double const away = 1 - std::clamp(normal.z, 0.0, 1.0);
  return away * away * away;
}

}  // namespace

Rgb clay_colour(Vec3 normal) {
  auto const body = mix(kClayShade, kClay, key_light(normal));
  auto const lit = mix(body, kClayLit, 0.45 * highlight(normal, 4));
  double const above = 0.35 + 0.65 * std::clamp(0.5 + normal.y, 0.0, 1.0);
  return openness(normal) * mix(lit, kClayLit, 0.38 * above * rim(normal));
}

Light soft_light(Vec3 normal) {
  double const gloss = 14 * highlight(normal, 4) + 16 * rim(normal) * std::max(normal.y, 0.0);
  return {openness(normal) * mix(kShade, kLit, key_light(normal)), {gloss, gloss, gloss}};
}

Rgb paper_colour(Vec3 normal) {
  // A narrow ramp instead of a step keeps the border of the tone antialiased.
  return mix(kPaperShade, kPaper, smooth_step((dot(normal, kKey) - 0.02) / 0.08));
}

}  // namespace inkflate
