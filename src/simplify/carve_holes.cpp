// SPDX-License-Identifier: Apache-2.0
#include "simplify/carve_holes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/point_grid.h"
#include "simplify/cell_regions.h"

namespace inkflate {
namespace {

// Two white regions are one only where the passage between them is wider than this, work px: gaps below are slips of the pen.
constexpr double kPassagePx = 10;

// Of its part's area: smaller regions are eyes and loops of the pen.
constexpr double kLeastHoleShare = 0.015;

// What lies this near to a line belongs to it, work px: the width of a line that was drawn several times.
constexpr double kBandPx = 16;

// Of a hole's rim may be silhouette.
constexpr double kMostSilhouette = 0.1;

// Ink inside of a hole, as a share of the root of its area: a slip of the pen.
constexpr double kMostInnerInk = 0.15;

// A stroke goes on as the silhouette when this share of it lies there; a woven hole has this share of its rim from such strokes.
constexpr double kStrokeShare = 0.25;
constexpr double kWovenShare = 0.3;

// A ring's part: this share of its ink, at most, is neither silhouette nor the rim of a possible hole.
constexpr double kMostOtherInk = 0.05;

// A ring's hole: its centroid is no farther from its part's than this share of its width, or this share of its rim is no farther
// from the silhouette than half its width.
constexpr double kCentral = 0.15;
constexpr double kNearShare = 0.6;

constexpr double kPi = 3.141592653589793;

double share(std::ptrdiff_t some, std::ptrdiff_t all) {
  return all > 0 ? static_cast<double>(some) / static_cast<double>(all) : 0;
}

/// A set of places that can tell what is near it.
class Line {
 public:
  explicit Line(std::vector<Vec2> places) : places_(std::move(places)), grid_(places_, kBandPx) {}

  std::vector<Vec2> const& places() const { return places_; }
  bool is_near(Vec2 p, double distance_px = kBandPx) const {
    return grid_.any_near(p, distance_px, [&](int i) {
      return squared_norm(places_[i] - p) <= distance_px * distance_px;
    });
  }

 private:
  std::vector<Vec2> places_;
  PointGrid grid_;
};

/// The corners of all edges between inside and outside.
Line find_silhouette(Cells const& cells, CellLabels const& inside) {
  std::vector<Vec2> places;
  for (int e = 0; e < 3 * cells.count(); ++e) {
    if (inside[e / 3] == 0 || (cells.twin(e) >= 0 && inside[cells.twin(e) / 3] != 0)) continue;
    places.push_back(cells.position(cells.corner(e)));
  }
  return Line(std::move(places));
}

/// Looks at the white regions one by one; the tests stand in the order of their cost.
class HoleJudge {
 public:
  HoleJudge(Cells const& cells, CellLabels const& inside)
      : samples_(cells.samples),
        whites_(join_cells(cells, inside, kPassagePx)),
        parts_(join_cells(cells, inside, 0)),
        silhouette_(find_silhouette(cells, inside)) {
    part_of_.assign(whites_.regions.size(), -1);
    for (int t = 0; t < cells.count(); ++t) {
      if (whites_.of_cell[t] >= 0) part_of_[whites_.of_cell[t]] = parts_.of_cell[t];
    }
    for (int k = 0; k < std::ssize(samples_.points); ++k) {
      auto const stroke = static_cast<std::size_t>(samples_.points[k].stroke);
      if (stroke_starts_.size() <= stroke) stroke_starts_.resize(stroke + 1, k);
    }
    for (int r = 0; r < std::ssize(whites_.regions); ++r)
      is_candidate_.push_back(could_be_hole(r) ? 1 : 0);
  }

  CellRegions const& whites() const { return whites_; }

  bool is_hole(int region) const {
    return is_candidate_[region] != 0 && (is_woven(region) || is_ring(region));
  }

 private:
  Vec2 position(int sample) const { return samples_.points[sample].position; }

  bool could_be_hole(int r) const {
    auto const& region = whites_.regions[r];
    if (region.area_px2 < kLeastHoleShare * parts_.regions[part_of_[r]].area_px2) return false;
    if (region.inner_ink_px > kMostInnerInk * std::sqrt(region.area_px2)) return false;
    auto const on_silhouette =
        std::count_if(region.corners.begin(), region.corners.end(),
                      [&](int k) { return silhouette_.is_near(position(k)); });
    return share(on_silhouette, std::ssize(region.corners)) <= kMostSilhouette;
  }

  bool is_woven(int r) const {
    std::map<int, std::ptrdiff_t> corners_of;  // per stroke
    for (int const k : whites_.regions[r].corners) ++corners_of[samples_.points[k].stroke];
    std::ptrdiff_t woven = 0;
    for (auto const& [stroke, corners] : corners_of) woven += goes_on(stroke) ? corners : 0;
    return share(woven, std::ssize(whites_.regions[r].corners)) >= kWovenShare;
  }

  bool goes_on(int stroke) const {
    std::ptrdiff_t on = 0;
    std::ptrdiff_t all = 0;
    for (int k = stroke_starts_[stroke];
         k < std::ssize(samples_.points) && samples_.points[k].stroke == stroke; ++k) {
      on += silhouette_.is_near(position(k)) ? 1 : 0;
      ++all;
    }
    return share(on, all) >= kStrokeShare;
  }

  bool is_ring(int r) const {
    auto const& region = whites_.regions[r];
    double const width = std::sqrt(region.area_px2 * 4 / kPi);  // of a disc of that area
    bool const is_central =
        distance(region.centroid, parts_.regions[part_of_[r]].centroid) <= kCentral * width;
    return (is_central || is_under_silhouette(region, width)) &&
           other_ink(part_of_[r]) <= kMostOtherInk;
  }

  bool is_under_silhouette(CellRegion const& region, double width) const {
    auto const near = std::count_if(region.corners.begin(), region.corners.end(), [&](int k) {
      return silhouette_.is_near(position(k), width / 2);
    });
    return share(near, std::ssize(region.corners)) >= kNearShare;
  }

  /// The share of a part's ink that is neither silhouette nor the rim of a possible hole.
  double other_ink(int part) const {
    auto places = silhouette_.places();
    for (int r = 0; r < std::ssize(whites_.regions); ++r) {
      if (is_candidate_[r] == 0) continue;
      for (int const k : whites_.regions[r].corners) places.push_back(position(k));
    }
    Line const lines(std::move(places));
    auto const& corners = parts_.regions[part].corners;
    auto const other = std::count_if(corners.begin(), corners.end(),
                                     [&](int k) { return !lines.is_near(position(k)); });
    return share(other, std::ssize(corners));
  }

  StrokeSamples const& samples_;
  CellRegions whites_;
  CellRegions parts_;
  Line silhouette_;
  std::vector<int> part_of_;                // per white region
  std::vector<int> stroke_starts_;          // per stroke: its first sample
  std::vector<std::uint8_t> is_candidate_;  // per white region
};

/// Takes the cells of a hole out, and with them the cells in its narrow corners, which belong to no region.
void open(int region, Cells const& cells, CellRegions const& whites, CellLabels& inside) {
  std::vector<int> opened;
  for (int t = 0; t < cells.count(); ++t) {
    if (whites.of_cell[t] == region) opened.push_back(t);
  }
  for (int const t : opened) inside[t] = 0;
  for (std::size_t next = 0; next < opened.size(); ++next) {
    for (int e = 3 * opened[next]; e < 3 * opened[next] + 3; ++e) {
      int const other = cells.twin(e) / 3;
      if (cells.twin(e) < 0 || cells.is_ink(e) || inside[other] == 0 || whites.of_cell[other] >= 0)
        continue;
      inside[other] = 0;
      opened.push_back(other);
    }
  }
}

}  // namespace

CellLabels carve_holes(Cells const& cells, CellLabels inside, std::span<int const> keep_inside) {
  if (cells.count() == 0) return inside;
  HoleJudge const judge(cells, inside);
  auto const& whites = judge.whites();
  for (int r = 0; r < std::ssize(whites.regions); ++r) {
    bool const is_kept = std::any_of(keep_inside.begin(), keep_inside.end(),
                                     [&](int cell) { return whites.of_cell[cell] == r; });
    if (!is_kept && judge.is_hole(r)) open(r, cells, whites, inside);
  }
  return inside;
}

}  // namespace inkflate
