// SPDX-License-Identifier: Apache-2.0
#include "simplify/fit_rims.h"

#include <utility>

#include "geometry/crossings.h"

namespace inkflate {
namespace {

// Outlines are tested for crossings as polygons this close to the curves, work px.
constexpr double kTestTolerance_px = 0.01;

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

}  // namespace

std::vector<Outline> fit_rims(std::vector<Rim> const& rims, std::vector<Contour> const& centred,
                              StrokeSamples const& samples, WorkSpace const& space, double smooth) {
  std::vector<Care> cares(rims.size(), Care::Full);
  std::vector<Outline> outlines(rims.size());
  std::vector<Contour> polygons(rims.size());
  double const tolerance = kTestTolerance_px * space.to_canvas;
  auto const redraw = [&](int r) {
    outlines[r] = on_canvas(draw(rims[r], centred[r], samples, smooth, cares[r]), space);
    polygons[r] = flatten(outlines[r], tolerance);
  };
  for (int r = 0; r < std::ssize(rims); ++r) redraw(r);
  // Every round makes at least one outline safer, so there are at most 3 per rim.
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<std::uint8_t> crosses(rims.size(), 0);
    for (auto const& crossing : find_crossings(polygons, 1000)) {
      crosses[crossing.contour_a] = 1;
      crosses[crossing.contour_b] = 1;
    }
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
