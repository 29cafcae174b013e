// SPDX-License-Identifier: Apache-2.0
#include "rough_character.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/rng.h"
#include "geometry/polyline.h"
#include "geometry/trig.h"
#include "pipeline/place_sketch.h"

namespace inkflate {
namespace {

// The right half of the figure on a canvas of 1000 px, from the top of the head to between the legs.
constexpr double kMiddlePx = 500;
constexpr std::array<Vec2, 21> kHalfFigure = {
    {{500, 70},  {590, 90},  {635, 170}, {615, 260}, {560, 310}, {620, 350}, {760, 330},
     {880, 290}, {930, 330}, {900, 390}, {780, 430}, {660, 450}, {650, 600}, {700, 700},
     {720, 850}, {780, 930}, {720, 970}, {620, 950}, {590, 840}, {540, 730}, {500, 700}}};

struct Disc {
  Vec2 centre;
  double radius_px;
};

// Where there is room for detail: head, trunk, arms, legs.
constexpr std::array<Disc, 8> kRooms = {{{{500, 190}, 75},
                                         {{500, 430}, 75},
                                         {{500, 580}, 90},
                                         {{720, 385}, 25},
                                         {{280, 385}, 25},
                                         {{650, 800}, 35},
                                         {{350, 800}, 35},
                                         {{500, 520}, 60}}};

constexpr double kReachPx = 80;         // what a stroke of the outline adds to the ones before
constexpr double kOverlap = 1.25;       // its length, in reaches
constexpr double kMostPasses = 6;       // over the whole outline
constexpr double kOutlineShare = 0.55;  // of the strokes
constexpr double kFleckShare = 0.04;

/// The closed curve through points by Catmull and Rom, in short chords.
Contour smooth_contour(Contour const& through) {
  constexpr int steps_per_span = 24;
  Contour contour;
  auto const count = std::ssize(through);
  for (int i = 0; i < count; ++i) {
    Vec2 const a = through[(i + count - 1) % count];
    Vec2 const b = through[i];
    Vec2 const c = through[(i + 1) % count];
    Vec2 const d = through[(i + 2) % count];
    for (int k = 0; k < steps_per_span; ++k) {
      double const t = static_cast<double>(k) / steps_per_span;
      contour.push_back(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * (t * t) +
                               (3 * b - a - 3 * c + d) * (t * t * t)));
    }
  }
  return contour;
}

Contour figure() {
  Contour through(kHalfFigure.begin(), kHalfFigure.end());
  for (int i = std::ssize(kHalfFigure) - 2; i > 0; --i)
    through.push_back({2 * kMiddlePx - kHalfFigure[i].x, kHalfFigure[i].y});
  return smooth_contour(through);
}

/// The place of a contour at a length along it; may be asked beyond its end, where it goes round again.
class AlongContour {
 public:
  explicit AlongContour(Contour contour) : contour_(std::move(contour)) {
    along_.push_back(0);
    for (int i = 0; i < std::ssize(contour_); ++i)
      along_.push_back(along_.back() + distance(point(i), point(i + 1)));
  }

  double length_px() const { return along_.back(); }

  Vec2 at(double s) const {
    s -= std::floor(s / length_px()) * length_px();
    int const i = segment(s);
    return lerp(point(i), point(i + 1), (s - along_[i]) / (along_[i + 1] - along_[i]));
  }

  Vec2 normal(double s) const { return perpendicular(normalized(at(s + 2) - at(s - 2))); }

 private:
  Vec2 point(int i) const { return contour_[static_cast<std::size_t>(i) % contour_.size()]; }
  int segment(double s) const {
    auto const next = std::upper_bound(along_.begin(), along_.end(), s);
    return std::clamp(static_cast<int>(next - along_.begin()) - 1, 0,
                      static_cast<int>(contour_.size()) - 1);
  }

  Contour contour_;
  std::vector<double> along_;
};

/// The hand that draws; lengths in px of the figure's canvas.
class Hand {
 public:
  explicit Hand(std::uint64_t seed) : rng_(seed) {}

  Rng& rng() { return rng_; }

  /// A stroke along the outline, beside it by an error that changes slowly, with a tremor.
  Stroke follow(AlongContour const& outline, double from, double to) {
    int const steps = steps_of_stroke();
    double const aside = rng_.uniform(-3, 3);
    double const slope = rng_.uniform(-3, 3);
    double const wave = rng_.uniform(0, 2 * kPi);
    Stroke stroke;
    for (int i = 0; i <= steps; ++i) {
      double const t = static_cast<double>(i) / steps;
      double const s = from + (to - from) * t;
      double const off = aside + slope * (t - 0.5) + 1.5 * sin_cos(wave + 5 * t).sin;
      add(stroke, outline.at(s) + outline.normal(s) * off);
    }
    return stroke;
  }

  /// A part of an ellipse; a full turn runs a little over its start.
  Stroke arc(Vec2 centre, double radius_px, double from_rad, double to_rad) {
    int const steps = steps_of_stroke();
    double const flat = rng_.uniform(0.6, 1);
    Stroke stroke;
    for (int i = 0; i <= steps; ++i) {
      auto const [sin, cos] = sin_cos(from_rad + (to_rad - from_rad) * i / steps);
      add(stroke, centre + Vec2{cos, sin * flat} * radius_px);
    }
    return stroke;
  }

  Stroke straight(Vec2 from, Vec2 to) {
    int const steps = steps_of_stroke();
    Stroke stroke;
    for (int i = 0; i <= steps; ++i) add(stroke, lerp(from, to, static_cast<double>(i) / steps));
    return stroke;
  }

 private:
  int steps_of_stroke() { return 19 + rng_.below(21); }
  void add(Stroke& stroke, Vec2 place) {
    constexpr double tremor_px = 0.35;
    Vec2 const tremor = {rng_.uniform(-1, 1), rng_.uniform(-1, 1)};
    stroke.samples.push_back({place + tremor * tremor_px, rng_.uniform(0.3, 1)});
  }

  Rng rng_;
};

void draw_outline(Hand& hand, int count, std::vector<Stroke>& strokes) {
  AlongContour const outline(figure());
  // A drawing of few strokes has longer ones: they go round once and a bit.
  double const reach_px = std::max(kReachPx, 1.15 * outline.length_px() / count);
  int const most = static_cast<int>(kMostPasses * outline.length_px() / reach_px);
  for (int i = 0; i < std::min(count, most); ++i) {
    double const from = (i + hand.rng().uniform(-0.2, 0.2)) * reach_px;
    strokes.push_back(hand.follow(outline, from, from + kOverlap * reach_px));
  }
}

void draw_hatching(Hand& hand, Vec2 place, double radius_px, std::vector<Stroke>& strokes) {
  int const lines = 4 + hand.rng().below(6);
  double const length_px = radius_px * hand.rng().uniform(0.5, 1);
  for (int i = 0; i < lines; ++i) {
    Vec2 const from = place + Vec2{5.0 * i, hand.rng().uniform(-3, 3)};
    strokes.push_back(hand.straight(from, from + Vec2{-0.4, 0.9} * length_px));
  }
}

/// An eye or a button, a crease, or hatching.
void draw_detail(Hand& hand, std::vector<Stroke>& strokes) {
  auto& rng = hand.rng();
  auto const& room = kRooms[static_cast<std::size_t>(rng.below(std::ssize(kRooms)))];
  double const radius_px = room.radius_px;
  Vec2 const place = room.centre + Vec2{rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.6)} * radius_px;
  int const kind = rng.below(3);
  if (kind == 0) {
    draw_hatching(hand, place, radius_px, strokes);
  } else {
    double const from_rad = rng.uniform(0, 2 * kPi);
    double const turn_rad = kind == 1 ? 2.1 * kPi : rng.uniform(0.5, 2);
    double const size_px = kind == 1 ? rng.uniform(5, 14) : rng.uniform(15, 50);
    strokes.push_back(hand.arc(place, size_px, from_rad, from_rad + turn_rad));
  }
}

void draw_fleck(Hand& hand, std::vector<Stroke>& strokes) {
  Vec2 const place = {hand.rng().uniform(30, 970), hand.rng().uniform(30, 970)};
  strokes.push_back(
      hand.straight(place, place + Vec2{hand.rng().uniform(-8, 8), hand.rng().uniform(-8, 8)}));
}

}  // namespace

Sketch rough_character(int stroke_count, double size_px, std::uint64_t seed) {
  Hand hand(seed);
  Sketch sketch;
  auto& strokes = sketch.strokes;
  draw_outline(hand, static_cast<int>(kOutlineShare * stroke_count), strokes);
  int const fleck_count = static_cast<int>(kFleckShare * stroke_count);
  while (std::ssize(strokes) < stroke_count - fleck_count) draw_detail(hand, strokes);
  strokes.resize(static_cast<std::size_t>(stroke_count - fleck_count));
  for (int i = 0; i < fleck_count; ++i) draw_fleck(hand, strokes);
  return *place_sketch(sketch, {size_px, PlaceMode::FitStrokes});
}

}  // namespace inkflate
