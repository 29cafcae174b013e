// SPDX-License-Identifier: Apache-2.0
#include "support/sketches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/rng.h"
#include "geometry/crossings.h"

namespace inkflate {

Stroke line_stroke(std::vector<Vec2> const& points, StrokeKind kind) {
  Stroke stroke;
  stroke.kind = kind;
  for (auto const p : points) stroke.samples.push_back({p, 1});
  return stroke;
}

Stroke arc_stroke(Vec2 centre, double radius_x, double radius_y, double from_rad, double to_rad,
                  StrokeKind kind) {
  int const steps = 4 + static_cast<int>(std::abs(to_rad - from_rad) * 40);
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i) {
    double const angle = from_rad + (to_rad - from_rad) * i / steps;
    points.push_back(centre + Vec2{radius_x * std::cos(angle), radius_y * std::sin(angle)});
  }
  return line_stroke(points, kind);
}

Stroke circle_stroke(Vec2 centre, double radius) {
  auto stroke = arc_stroke(centre, radius, radius, 0, 2 * M_PI);
  stroke.samples.back() = stroke.samples.front();
  return stroke;
}

std::vector<Stroke> overdrawn(Stroke const& stroke, int passes, Vec2 aside_px) {
  std::vector<Stroke> strokes(static_cast<std::size_t>(passes), stroke);
  for (int pass = 0; pass < passes; ++pass) {
    for (auto& sample : strokes[pass].samples) sample.position += aside_px * pass;
  }
  return strokes;
}

Sketch sketch_of(std::vector<Stroke> strokes) { return {1000, 1000, {}, std::move(strokes)}; }

namespace {

/// A pass over a part of a wobbly blob, with jitter.
Stroke random_pass(Rng& rng, Vec2 centre, double radius, double wobble, double from_rad,
                   double jitter_px) {
  Stroke stroke;
  double const length_rad = rng.uniform(0.3, 3);
  int const steps = 3 + rng.below(60);
  int const waves = 2 + rng.below(5);
  for (int i = 0; i <= steps; ++i) {
    double const angle = from_rad + length_rad * i / steps;
    double const r = radius * (1 + wobble * std::sin(waves * angle));
    Vec2 const p = centre + Vec2{std::cos(angle), std::sin(angle)} * r;
    stroke.samples.push_back(
        {p + Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)} * jitter_px, rng.uniform()});
  }
  return stroke;
}

void add_blob(Rng& rng, Sketch& sketch) {
  Vec2 const centre = {rng.uniform(100, 900), rng.uniform(100, 900)};
  double const radius = rng.uniform(3, 400);
  double const wobble = rng.uniform(0, 0.5);
  double const jitter_px = rng.below(3) == 0 ? 0 : rng.uniform(0, 8);
  int const passes = 1 + rng.below(12);
  for (int i = 0; i < passes; ++i) {
    auto pass = random_pass(rng, centre, radius, wobble, rng.uniform(0, 6.3), jitter_px);
    if (rng.below(8) == 0) pass.kind = StrokeKind::HelpLine;
    sketch.strokes.push_back(std::move(pass));
  }
}

void add_loose_lines(Rng& rng, Sketch& sketch) {
  int const lines = rng.below(12);
  for (int i = 0; i < lines; ++i) {
    Stroke stroke;
    int const points = 1 + rng.below(6);
    for (int k = 0; k < points; ++k)
      stroke.samples.push_back({{rng.uniform(0, 1000), rng.uniform(0, 1000)}, 1});
    sketch.strokes.push_back(std::move(stroke));
  }
}

/// Coordinates that force coincidence, or strain the range.
void spoil(Rng& rng, Sketch& sketch) {
  double const grid = rng.below(2) == 0 ? 10 : 100;
  double const scale = rng.below(4) == 0 ? 500 : rng.below(3) == 0 ? 1e-4 : 1;
  Vec2 const shift = rng.below(4) == 0 ? Vec2{-9e4, 5e4} : Vec2{};
  bool const is_rounded = rng.below(2) == 0;
  for (auto& stroke : sketch.strokes) {
    for (auto& sample : stroke.samples) {
      auto& p = sample.position;
      if (is_rounded) p = {std::floor(p.x / grid) * grid, std::floor(p.y / grid) * grid};
      p = p * scale + shift;
    }
    if (rng.below(10) == 0) stroke.samples.clear();
  }
}

std::string check_outline(Outline const& outline, bool is_hole, double sketch_size_px) {
  auto const& pieces = outline.pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!(pieces[i].curve.end() == pieces[(i + 1) % pieces.size()].curve.start()))
      return "an outline is open";
  }
  // A thousandth of a percent is as fine as outlines are promised to be simple.
  auto const contour = flatten(outline, 1e-5 * sketch_size_px);
  if (contour.size() < 3) return "an outline has fewer than three points";
  if (!is_simple(contour)) return "an outline crosses itself";
  if ((signed_area(contour) < 0) != is_hole) return "an outline has the wrong orientation";
  double last = 0;
  for (auto const& source : outline.sources) {
    if (source.from < last || source.to <= source.from) return "sources are out of order";
    last = source.to;
  }
  return last > static_cast<double>(pieces.size()) ? "a source ends beyond its outline" : "";
}

/// Outlines of a layer have nothing in common but single corners; holes lie inside.
std::string check_together(Layer const& layer, double sketch_size_px) {
  std::vector<Contour> contours;
  for (auto const& outline : layer.outlines)
    contours.push_back(flatten(outline, 1e-5 * sketch_size_px));
  auto const ends = [&](int contour, int edge) {
    auto const& points = contours[contour];
    return std::array{points[edge], points[(edge + 1) % std::ssize(points)]};
  };
  for (auto const& crossing : find_crossings(contours, 10'000)) {
    auto const a = ends(crossing.contour_a, crossing.edge_a);
    auto const b = ends(crossing.contour_b, crossing.edge_b);
    if (a[0] != b[0] && a[0] != b[1] && a[1] != b[0] && a[1] != b[1])
      return "outlines cross each other";
  }
  for (std::size_t i = 1; i < contours.size(); ++i) {
    // Corners that are shared with the outer outline may count either way.
    auto const inside = std::count_if(contours[i].begin(), contours[i].end(),
                                      [&](Vec2 p) { return contains(contours[0], p); });
    if (2 * inside < std::ssize(contours[i])) return "a hole lies outside";
  }
  return "";
}

}  // namespace

Sketch random_sketch(std::uint64_t seed) {
  Rng rng(seed);
  Sketch sketch = sketch_of({});
  int const blobs = rng.below(4);
  for (int i = 0; i < blobs; ++i) add_blob(rng, sketch);
  if (rng.below(2) == 0) add_loose_lines(rng, sketch);
  if (rng.below(3) == 0) spoil(rng, sketch);
  return sketch;
}

std::string what_is_wrong(Drawing const& drawing) {
  Rect box;
  for (auto const& stroke : drawing.sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  std::vector<int> places(drawing.sketch.strokes.size(), 0);
  for (auto const& layer : drawing.layers) {
    if (layer.outlines.empty()) return "a layer has no outline";
    for (std::size_t i = 0; i < layer.outlines.size(); ++i) {
      auto const wrong = check_outline(layer.outlines[i], i > 0, box.longer_side());
      if (!wrong.empty()) return wrong;
    }
    auto const wrong = check_together(layer, box.longer_side());
    if (!wrong.empty()) return wrong;
    for (auto const* list : {&layer.strokes, &layer.details}) {
      for (int const stroke : *list) ++places[stroke];
    }
  }
  for (int const stroke : drawing.stray) ++places[stroke];
  for (std::size_t i = 0; i < places.size(); ++i) {
    int const expected = drawing.sketch.strokes[i].samples.empty() ? 0 : 1;
    if (places[i] != expected)
      return "stroke " + std::to_string(i) + " is in " + std::to_string(places[i]) + " places";
  }
  return "";
}

}  // namespace inkflate
