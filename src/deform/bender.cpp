// SPDX-License-Identifier: Apache-2.0
#include "deform/bender.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "deform/body_mesh.h"
#include "deform/body_solver.h"
#include "deform/hangers_on.h"
#include "deform/line_anchors.h"
#include "deform/outline_ride.h"
#include "deform/reach.h"
#include "deform/strip_mesh.h"
#include "deform/wire_solver.h"
#include "deform/wire_strip.h"

namespace inkflate {
namespace {

// Cuts of an outline are joined again where that moves nothing by more than this, or by this share of the shape's size if that is
// less: too little to be seen. No less than what rounding does to places at 1e6 px.
constexpr double kJoinPx = 0.02;
constexpr double kLeastJoinPx = 1e-7;
constexpr double kJoinShare = 1e-4;

bool is_outline(Outline const& outline) { return !outline.pieces.empty(); }

Rect box_of(BendShape const& shape) {
  Rect box;
  for (auto const& outline : shape.outlines) {
    for (auto const& piece : outline.pieces) box = united(box, bounds(piece.curve.control));
  }
  for (auto const& line : shape.lines) box = united(box, bounds(line));
  return box;
}

/// The outlines as strips along them, as the thesis has it.
ShapeMesh wire_mesh(std::span<Outline const> outlines, double half_width_px) {
  auto const rims = sample_rims(outlines, rim_edge_px(outlines));
  ShapeMesh result;
  std::vector<Contour> contours;
  for (int i = 0; i < std::ssize(rims); ++i) {
    if (rims[i].points.size() < 3) continue;
    contours.push_back(rims[i].points);
    result.origins.push_back({i, rims[i].parameters});
  }
  result.mesh = wire_strip(contours, half_width_px);
  return result;
}

ShapeMesh strips_along(std::span<Outline const> outlines, double longer_side_px) {
  std::vector<LineSamples> rims;
  double const half_width_px = strip_half_width_px(longer_side_px);
  for (auto const& outline : outlines) rims.push_back(sample_outline(outline, half_width_px / 2));
  return strip_mesh(rims, half_width_px);
}

ShapeMesh mesh_of(BendShape const& shape, BendOptions const& options) {
  double const size = box_of(shape).longer_side();
  if (std::any_of(shape.outlines.begin(), shape.outlines.end(), is_outline)) {
    if (options.mode == BendMode::Wire) {
      auto wire = wire_mesh(shape.outlines, options.strip_half_width_px);
      if (!wire.mesh.lines.empty()) return wire;
    } else if (auto body = body_mesh(shape.outlines, options.body, options.least_edge_px)) {
      return std::move(*body);
    }
    return strips_along(shape.outlines, size);
  }
  std::vector<LineSamples> lines;
  for (auto const& line : shape.lines) lines.push_back(sample_line(line));
  return strip_mesh(lines, strip_half_width_px(size));
}

}  // namespace

struct Bender::Inside {
  using Solver = std::variant<BodySolver, WireSolver>;

  Inside(BendShape shape, ShapeMesh mesh, BendMode mode)
      : rest(std::move(shape)),
        meshed(std::move(mesh)),
        field(meshed.mesh),
        anchors(meshed.mesh),
        places(meshed),
        solver(mode == BendMode::Wire ? Solver(WireSolver(meshed.mesh))
                                      : Solver(BodySolver(meshed.mesh))) {
    double const size_px = box_of(rest).longer_side();
    join_px = std::clamp(kJoinShare * size_px, kLeastJoinPx, kJoinPx);
    grid = PlaceGrid::of_shape(size_px);
    for (int i = 0; i < std::ssize(rest.outlines); ++i)
      outlines.emplace_back(rest.outlines[i], meshed, i, places);
    for (int i = 0; i < std::ssize(rest.lines); ++i) add_line(i);
  }

  void add_line(int index) {
    // Lines are in the mesh themselves where there are no outlines.
    bool const is_own = rest.outlines.empty();
    auto const own = std::find_if(meshed.origins.begin(), meshed.origins.end(),
                                  [&](BendLineOrigin const& o) { return o.index == index; });
    auto const& points = rest.lines[index];
    if (!is_own || own == meshed.origins.end()) {
      auto const added = places.add_line(points);
      line_places.insert(line_places.end(), added.begin(), added.end());
      return;
    }
    int const line = static_cast<int>(own - meshed.origins.begin());
    for (int k = 0; k < std::ssize(points); ++k)
      line_places.push_back(places.add_on_line(line, k, points[k]));
  }

  BendShape rest;
  ShapeMesh meshed;
  MotionField field;
  LineAnchors anchors;
  RidePlaces places;
  Solver solver;
  std::vector<OutlineRide> outlines;
  std::vector<int> line_places;  // of all points of all lines, in order
  double join_px = 0;
  PlaceGrid grid;  // on which bent shapes are kept
};

Bender::Bender(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Bender::~Bender() = default;
Bender::Bender(Bender&&) noexcept = default;
Bender& Bender::operator=(Bender&&) noexcept = default;

Result<Bender> Bender::make(BendShape rest, BendOptions const& options) {
  if (!(options.body >= BendOptions::kLeastBody && options.body <= 1))
    return Error{ErrorCode::BadOption, "the body is out of its range"};
  if (!(options.strip_half_width_px >= 0 && std::isfinite(options.strip_half_width_px)))
    return Error{ErrorCode::BadOption, "the strip's width is out of its range"};
  if (!(options.least_edge_px >= 0 && std::isfinite(options.least_edge_px)))
    return Error{ErrorCode::BadOption, "the least edge is out of its range"};
  auto meshed = mesh_of(rest, options);
  if (meshed.mesh.rest.triangles.empty())
    return Error{ErrorCode::NothingThere, "there is nothing to bend"};
  return Bender(std::make_unique<Inside>(std::move(rest), std::move(meshed), options.mode));
}

BendMesh const& Bender::mesh() const { return inside_->meshed.mesh; }
BendPose const& Bender::rest_pose() const { return inside_->meshed.mesh.rest.points; }

BendAnchor Bender::nearest(BendPose const& pose, Vec2 canvas) const {
  return inside_->anchors.nearest(pose, canvas);
}

std::optional<BendAnchor> Bender::under(BendPose const& pose, Vec2 canvas) const {
  auto const& triangles = mesh().rest.triangles;
  for (int t = 0; t < static_cast<int>(std::ssize(triangles)); ++t) {
    auto const& [a, b, c] = triangles[t];
    Vec2 const to_a = pose[a] - canvas;
    Vec2 const to_b = pose[b] - canvas;
    Vec2 const to_c = pose[c] - canvas;
    // The areas of the triangles between the place and each side.
    std::array<double, 3> areas = {cross(to_b, to_c), cross(to_c, to_a), cross(to_a, to_b)};
    double const whole = areas[0] + areas[1] + areas[2];
    bool const is_in = areas[0] >= 0 && areas[1] >= 0 && areas[2] >= 0 && whole > 0;
    if (!is_in) continue;
    for (auto& area : areas) area /= whole;
    return BendAnchor{t, areas};
  }
  return std::nullopt;
}

BendArea Bender::within_reach(BendAnchor const& from, double reach_px, ReachEnd end) const {
  auto const& mesh = inside_->meshed.mesh.rest;
  auto const ways_px = ways_inside(mesh, from);
  BendArea area;
  for (double const px : ways_px) area.is_fixed.push_back(px > reach_px ? 1 : 0);
  free_hangers_on(mesh, ways_px, area.is_fixed);
  if (end == ReachEnd::Soft) {
    area.tethers = tethers_within(inside_->meshed.mesh, ways_px, reach_px);
  } else {
    area.stiffening = stiffening_within(mesh, ways_px, reach_px);
  }
  return area;
}

BendProgress Bender::step(BendPose& pose, BendHold const& hold, int steps) {
  return std::visit([&](auto& solver) { return solver.step(pose, hold, steps); }, inside_->solver);
}

BendShape Bender::bent(BendPose const& pose) const { return bent(pose, {}); }

BendShape Bender::bent_on_grid(BendPose const& pose) const { return bent(pose, inside_->grid); }

BendShape Bender::bent(BendPose const& pose, PlaceGrid const& grid) const {
  auto const& own = *inside_;
  auto const motions = own.field.motions(pose);
  BendShape shape;
  for (auto const& outline : own.outlines)
    shape.outlines.push_back(outline.bent(own.places, motions, own.join_px, grid));
  shape.lines = own.rest.lines;
  auto next = own.line_places.begin();
  for (auto& line : shape.lines) {
    for (auto& point : line) {
      Vec2 const shift = own.places.shift(motions, *next++);
      // Adding zeros may change a negative zero.
      if (shift != Vec2{}) point = grid(point, point + shift);
    }
  }
  return shape;
}

}  // namespace inkflate
