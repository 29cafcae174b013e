// SPDX-License-Identifier: Apache-2.0
#include "simplify/fit_rims.h"

#include <array>
#include <utility>

#include "geometry/crossings.h"

namespace inkflate {
namespace {

// Outlines are tested for crossings as polygons this close to the curves, work px: fine ones show where a joint turns back, coarse
// ones where two sides are so close that drawing them would make them cross.
constexpr std::array<double, 2> kTestTolerancesPx = {0.01, 0.2};

// Each way of drawing an outline is safer than the one before; the last one is the rim itself, which crosses nothing.
enum class Care { Full, StraightClosings, Tight, Raw };

Outline draw(Rim const& rim, Contour const& centred, StrokeSamples const& samples, double smooth,
             Care care) {
  switch (care) {
    case Care::Full:
      return fit_rim(rim, centred, samples, {smooth, ClosingShape::Flowing});
    case Care::StraightClosings:
      return fit_rim(rim, centred, samples, {smooth, ClosingShape::Straight});
    case Care::Tight:
      return fit_rim(rim, positions(rim, samples), samples, {0, ClosingShape::Straight});
    case Care::Raw:
      break;
  }
  return straight_outline(rim, samples);
}

Outline on_canvas(Outline outline, WorkSpace const& space) {
  for (auto& piece : outline.pieces) {
    for (auto& control : piece.curve.control) control = space.canvas_point(control);
  }
  return outline;
}

/// Per outline: whether one of its polygons crosses itself or another one.
std::vector<std::uint8_t> crossing_outlines(std::vector<Outline> const& outlines,
                                            WorkSpace const& space) {
  std::vector<std::uint8_t> crosses(outlines.size(), 0);
  std::vector<Contour> polygons(outlines.size());
  for (double const tolerance_px : kTestTolerancesPx) {
    for (std::size_t i = 0; i < outlines.size(); ++i)
      polygons[i] = flatten(outlines[i], tolerance_px * space.to_canvas);
    for (auto const& crossing : find_crossings(polygons, 1000)) {
      crosses[crossing.contour_a] = 1;
      crosses[crossing.contour_b] = 1;
    }
  }
  return crosses;
}

}  // namespace

std::vector<Outline> fit_rims(std::vector<Rim> const& rims, std::vector<Contour> const& centred,
                              StrokeSamples const& samples, WorkSpace const& space, double smooth) {
  std::vector<Care> cares(rims.size(), Care::Full);
  std::vector<Outline> outlines(rims.size());
  auto const redraw = [&](int r) {
    outlines[r] = on_canvas(draw(rims[r], centred[r], samples, smooth, cares[r]), space);
  };
  for (int r = 0; r < std::ssize(rims); ++r) redraw(r);
  // Every round makes at least one outline safer, so there are at most 3 per rim.
  for (bool changed = true; changed;) {
    changed = false;
    auto const crosses = crossing_outlines(outlines, space);
    for (int r = 0; r < std::ssize(rims); ++r) {
      if (crosses[r] == 0 || cares[r] == Care::Raw) continue;
      cares[r] = static_cast<Care>(static_cast<int>(cares[r]) + 1);
      redraw(r);
      changed = true;
    }
  }
  return outlines;
}

}  // namespace inkflate
