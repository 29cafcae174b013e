// SPDX-License-Identifier: Apache-2.0
#include "ink/ink_mask.h"

#include <algorithm>
#include <cmath>

#include "image/components.h"
#include "image/distance.h"
#include "image/filter.h"
#include "image/otsu.h"

namespace inkflate {
namespace {

/// Weaker differences are the texture of paper, however even the rest is.
constexpr double kFaintestInk = 14;
/// Areas of fewer pixels are dust; smaller still in small pictures, where a dot has few.
constexpr int kSmallestDotPx = 6;
constexpr int kLargestSpeckPx = 20;
constexpr double kSpeckSidePx = 1600;
/// An area is solid where a disc of this many pen radii (and a few px) fits in.
constexpr double kSolidRadii = 3;
constexpr double kSolidMarginPx = 3;
/// No pen is thicker than this share of the longer side: a page of nothing but solid areas has no pen to measure.
constexpr double kThickestPen = 0.006;

/// Four standard deviations of the paper's noise, from the lower part of the values, where no ink is.
double noise_floor(std::array<long long, 256> const& counts) {
  double const low = quantile(counts, 0.05);
  double const middle = quantile(counts, 0.3);
  return middle + 4 * (middle - low) + kFaintestInk;
}

Mask at_least(Mask const& values, double threshold) {
  Mask result(values.width, values.height);
  for (std::size_t i = 0; i < values.values.size(); ++i) {
    result.values[i] = values.values[i] >= threshold ? 255 : 0;
  }
  return result;
}

long long speck_area(Mask const& mask) {
  double const scale = std::max(mask.width, mask.height) / kSpeckSidePx;
  return std::clamp(static_cast<int>(kLargestSpeckPx * scale * scale), kSmallestDotPx,
                    kLargestSpeckPx);
}

Grid2<double> distance_to_paper(Mask const& mask) {
  auto result = squared_distance_to_zero(mask);
  // From centre to centre; the border is half a pixel nearer.
  for (auto& value : result.values) value = value > 0 ? std::sqrt(value) - 0.5 : 0;
  return result;
}

/// The median of the distances that no neighbour's exceeds: half the pen's width, measured along its lines.
double pen_radius(Grid2<double> const& radius_px) {
  std::vector<double> ridge;
  for (int y = 1; y + 1 < radius_px.height; ++y) {
    for (int x = 1; x + 1 < radius_px.width; ++x) {
      double const here = radius_px.at(x, y);
      if (here <= 0 || here < radius_px.at(x - 1, y) || here < radius_px.at(x + 1, y)) continue;
      if (here < radius_px.at(x, y - 1) || here < radius_px.at(x, y + 1)) continue;
      ridge.push_back(here);
    }
  }
  if (ridge.empty()) return 1;
  auto const middle = ridge.begin() + std::ssize(ridge) / 2;
  std::nth_element(ridge.begin(), middle, ridge.end());
  double const thickest = kThickestPen * std::max(radius_px.width, radius_px.height);
  return std::min(*middle, std::max(1.0, thickest));
}

/// Parts of the areas deeper than rim_px that are deeper than solid_px somewhere.
Mask solid_cores(Grid2<double> const& radius_px, double rim_px, double solid_px) {
  Mask deep(radius_px.width, radius_px.height);
  for (std::size_t i = 0; i < deep.values.size(); ++i) {
    deep.values[i] = radius_px.values[i] > rim_px ? 255 : 0;
  }
  auto const components = connected_components(deep, Neighbours::Four);
  std::vector<char> is_solid(components.areas.size());
  for (std::size_t i = 0; i < deep.values.size(); ++i) {
    int const label = components.labels.values[i];
    if (label >= 0 && radius_px.values[i] > solid_px) is_solid[static_cast<std::size_t>(label)] = 1;
  }
  for (std::size_t i = 0; i < deep.values.size(); ++i) {
    int const label = components.labels.values[i];
    if (label >= 0 && is_solid[static_cast<std::size_t>(label)] == 0) deep.values[i] = 0;
  }
  return deep;
}

/// Takes the inside of solid areas away, so that a line around them is left.
void hollow_solids(InkMask& ink) {
  double const pen_px = pen_radius(ink.radius_px);
  double const solid_px = kSolidRadii * pen_px + kSolidMarginPx;
  auto const cores = solid_cores(ink.radius_px, 2 * pen_px + 1, solid_px);
  bool has_cores = false;
  for (std::size_t i = 0; i < cores.values.size(); ++i) {
    if (cores.values[i] == 0) continue;
    ink.lines.values[i] = 0;
    has_cores = true;
  }
  if (has_cores) ink.radius_px = distance_to_paper(ink.lines);
}

}  // namespace

InkMask find_ink(Mask const& strength, Mask const& sheet, double threshold_share) {
  std::array<long long, 256> counts{};
  for (std::size_t i = 0; i < strength.values.size(); ++i) {
    if (sheet.values[i] != 0) ++counts[strength.values[i]];
  }
  double const threshold = std::max(threshold_share * otsu_threshold(counts), noise_floor(counts));
  auto mask = at_least(strength, threshold);
  auto const speck_px = speck_area(mask);
  mask = without_specks(std::move(mask), speck_px);
  mask = local_minimum(local_maximum(mask, 1), 1);
  InkMask ink{std::move(mask), {}};
  ink.radius_px = distance_to_paper(ink.lines);
  hollow_solids(ink);
  return ink;
}

}  // namespace inkflate
