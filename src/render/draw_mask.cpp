// SPDX-License-Identifier: Apache-2.0
#include "render/draw_mask.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

constexpr double kLargestSidePx = 16384;
/// Far below the half pixel that decides; the curve itself is not known better.
constexpr double kFlattenTolerancePx = 0.01;

int canvas_side(double side_px) {
  return static_cast<int>(std::clamp(std::ceil(side_px), 0.0, kLargestSidePx));
}

/// For each row of pixel centres, where the contour crosses it.
void add_crossings(Contour const& contour, std::vector<std::vector<double>>& rows) {
  for (std::size_t i = 0; i < contour.size(); ++i) {
    Vec2 a = contour[i];
    Vec2 b = contour[(i + 1) % contour.size()];
    if (a.y > b.y) std::swap(a, b);
    // Row centres in [a.y, b.y): a vertex on a centre line counts for one of its two edges.
    double const count = static_cast<double>(rows.size());
    int const first = static_cast<int>(std::clamp(std::ceil(a.y - 0.5), 0.0, count));
    int const end = static_cast<int>(std::clamp(std::ceil(b.y - 0.5), 0.0, count));
    for (int y = first; y < end; ++y) {
      double const t = (y + 0.5 - a.y) / (b.y - a.y);
      rows[static_cast<std::size_t>(y)].push_back(a.x + t * (b.x - a.x));
    }
  }
}

void fill_row(std::vector<double>& crossings, int y, Mask& mask) {
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    double const width = mask.width;
    int const first = static_cast<int>(std::clamp(std::ceil(crossings[i] - 0.5), 0.0, width));
    int const end = static_cast<int>(std::clamp(std::ceil(crossings[i + 1] - 0.5), 0.0, width));
    for (int x = first; x < end; ++x) mask.at(x, y) = 255;
  }
}

}  // namespace

Mask draw_mask(Drawing const& drawing) {
  Mask mask(canvas_side(drawing.sketch.width_px), canvas_side(drawing.sketch.height_px));
  for (auto const& layer : drawing.layers) {
    if (!is_shown(layer)) continue;
    std::vector<std::vector<double>> rows(static_cast<std::size_t>(mask.height));
    for (auto const& outline : layer.outlines) {
      add_crossings(flatten(outline, kFlattenTolerancePx), rows);
    }
    for (int y = 0; y < mask.height; ++y) fill_row(rows[static_cast<std::size_t>(y)], y, mask);
  }
  return mask;
}

}  // namespace inkflate
