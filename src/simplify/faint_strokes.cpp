// SPDX-License-Identifier: Apache-2.0
#include "simplify/faint_strokes.h"

#include <algorithm>

namespace inkflate {
namespace {

constexpr double kFaintShare = 0.5;

/// 0: white, as the paper; 255: some channel is black.
double strength(Colour colour) {
  int const least = std::min({colour.r, colour.g, colour.b});
  return (255 - least) * (colour.a / 255.0);
}

double length_px(Stroke const& stroke) {
  double sum = 0;
  for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
    sum += distance(stroke.samples[i - 1].position, stroke.samples[i].position);
  }
  return sum;
}

struct Weighted {
  double strength;
  double length_px;
};

/// Half of the ink by length is as strong or stronger.
double median_strength(std::vector<Weighted> strokes) {
  std::stable_sort(strokes.begin(), strokes.end(),
                   [](Weighted const& a, Weighted const& b) { return a.strength > b.strength; });
  double total = 0;
  for (auto const& stroke : strokes) total += stroke.length_px;
  double passed = 0;
  for (auto const& stroke : strokes) {
    passed += stroke.length_px;
    if (passed * 2 >= total) return stroke.strength;
  }
  return 0;
}

}  // namespace

std::vector<bool> faint_strokes(Sketch const& sketch) {
  std::vector<Weighted> ink;
  for (auto const& stroke : sketch.strokes) {
    if (stroke.kind == StrokeKind::Ink) ink.push_back({strength(stroke.colour), length_px(stroke)});
  }
  double const least = kFaintShare * median_strength(std::move(ink));
  std::vector<bool> is_faint;
  for (auto const& stroke : sketch.strokes) {
    is_faint.push_back(stroke.kind == StrokeKind::Ink && strength(stroke.colour) < least);
  }
  return is_faint;
}

}  // namespace inkflate
