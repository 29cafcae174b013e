// SPDX-License-Identifier: Apache-2.0
#include "assemble/untangle_rim.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/crossings.h"
#include "geometry/largest_piece.h"
#include "geometry/nonzero_boundary.h"

namespace inkflate {
namespace {

// What is left of an open run is an opening only if it is at least this share of it: not the corner that shows beside what lies over it.
constexpr double kLeastShareLeft = 0.5;
// Edges of drawn runs and holes. An open run has the tag 1 + its index.
constexpr int kDrawn = 0;

bool is_plain(LayerRim const& rim) {
  std::vector<Contour> contours = {outer_contour(rim)};
  contours.insert(contours.end(), rim.holes.begin(), rim.holes.end());
  auto const is_outer = [&](Contour const& contour) { return &contour == contours.data(); };
  return std::all_of(contours.begin(), contours.end(),
                     [&](Contour const& contour) {
                       return is_outer(contour) == (signed_area(contour) > 0);
                     }) &&
         find_crossings(contours, 1).empty();
}

std::vector<TaggedContour> tagged(LayerRim const& rim) {
  std::vector<TaggedContour> contours = {{outer_contour(rim), {}}};
  for (std::size_t r = 0; r < rim.runs.size(); ++r) {
    int const tag = rim.runs[r].opening == Opening::None ? kDrawn : static_cast<int>(r) + 1;
    contours[0].tags.insert(contours[0].tags.end(), rim.runs[r].points.size() - 1, tag);
  }
  for (auto const& hole : rim.holes) {
    contours.push_back({hole, std::vector<int>(hole.size(), kDrawn)});
  }
  return contours;
}

struct Stretch {
  Polyline points;
  int tag = kDrawn;
};

/// The contour cut where its tag changes; whole and closed, if it does not.
std::vector<Stretch> stretches(TaggedContour const& contour) {
  auto const& [points, tags] = contour;
  std::size_t const count = points.size();
  std::size_t first = 0;
  while (first < count && tags[first] == tags[(first + count - 1) % count]) ++first;
  std::vector<Stretch> result;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t const i = (first + k) % count;
    if (result.empty() || result.back().tag != tags[i]) result.push_back({{points[i]}, tags[i]});
    result.back().points.push_back(points[(i + 1) % count]);
  }
  return result;
}

/// Closes what is left of open runs where that is too little.
TaggedContour without_remains(TaggedContour contour, LayerRim const& rim) {
  std::vector<double> left_px(rim.runs.size() + 1, 0);
  for (auto const& stretch : stretches(contour)) {
    double& most = left_px[static_cast<std::size_t>(stretch.tag)];
    most = std::max(most, length(stretch.points));
  }
  for (int& tag : contour.tags) {
    if (tag == kDrawn) continue;
    double const whole_px = length(rim.runs[static_cast<std::size_t>(tag - 1)].points);
    if (left_px[static_cast<std::size_t>(tag)] < kLeastShareLeft * whole_px) tag = kDrawn;
  }
  return contour;
}

double mean_width(Contour const& contour) {
  return 2 * std::abs(signed_area(contour)) / perimeter(contour);
}

}  // namespace

LayerRim untangled(LayerRim rim, double step_px) {
  if (is_plain(rim)) return rim;
  auto const boundary = nonzero_boundary(tagged(rim), step_px);
  if (!boundary) return rim;
  auto const piece = largest_piece(*boundary);
  if (piece.empty()) return rim;
  LayerRim result;
  for (auto& [points, tag] : stretches(without_remains(piece.front(), rim))) {
    auto const opening =
        tag == kDrawn ? Opening::None : rim.runs[static_cast<std::size_t>(tag - 1)].opening;
    result.runs.push_back({densify(points, step_px), opening});
  }
  for (std::size_t i = 1; i < piece.size(); ++i) {
    if (mean_width(piece[i].points) >= step_px) result.holes.push_back(piece[i].points);
  }
  return result;
}

}  // namespace inkflate
