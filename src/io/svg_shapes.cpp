// SPDX-License-Identifier: Apache-2.0
#include "io/svg_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/svg_path.h"
#include "io/svg_units.h"

namespace inkflate {
namespace {

class Lengths {
 public:
  Lengths(SvgElement const& element, Vec2 viewport) : element_(element), viewport_(viewport) {}

  std::optional<double> find(std::string_view attribute, double percent_base) const {
    return length_px(element_[attribute], percent_base);
  }
  double x(std::string_view attribute) const { return find(attribute, viewport_.x).value_or(0); }
  double y(std::string_view attribute) const { return find(attribute, viewport_.y).value_or(0); }
  double radius(std::string_view attribute) const {
    return find(attribute, viewport_diagonal(viewport_)).value_or(0);
  }

  /// A radius left out is the other one.
  Vec2 radii() const {
    auto const rx = find("rx", viewport_.x);
    auto const ry = find("ry", viewport_.y);
    return {rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0))};
  }

 private:
  SvgElement const& element_;
  Vec2 viewport_;
};

void trace_rect(Lengths const& lengths, PathTracer& tracer) {
  Vec2 const min = {lengths.x("x"), lengths.y("y")};
  Vec2 const size = {lengths.x("width"), lengths.y("height")};
  if (!(size.x > 0) || !(size.y > 0)) return;
  Vec2 const max = min + size;
  Vec2 const wanted = lengths.radii();
  Vec2 const r = {std::clamp(wanted.x, 0.0, size.x / 2), std::clamp(wanted.y, 0.0, size.y / 2)};
  bool const is_round = r.x > 0 && r.y > 0;
  Vec2 const cut = is_round ? r : Vec2{};
  auto const corner = [&](Vec2 to) {
    if (is_round) tracer.arc_to({r, 0, false, true, to});
  };
  tracer.move_to({min.x + cut.x, min.y});
  tracer.line_to({max.x - cut.x, min.y});
  corner({max.x, min.y + cut.y});
  tracer.line_to({max.x, max.y - cut.y});
  corner({max.x - cut.x, max.y});
  tracer.line_to({min.x + cut.x, max.y});
  corner({min.x, max.y - cut.y});
  tracer.line_to({min.x, min.y + cut.y});
  corner({min.x + cut.x, min.y});
  tracer.close();
}

void trace_ellipse(Vec2 centre, Vec2 radii, PathTracer& tracer) {
  if (radii.x > 0 && radii.y > 0) tracer.ellipse(centre, radii);
}

}  // namespace

bool is_shape(std::string_view element_name) {
  constexpr std::array<std::string_view, 7> shapes = {"path", "polyline", "polygon", "line",
                                                      "rect", "circle",   "ellipse"};
  return std::find(shapes.begin(), shapes.end(), element_name) != shapes.end();
}

bool trace_shape(SvgElement const& element, Vec2 viewport_size, PathTracer& tracer) {
  auto const name = element.name();
  Lengths const lengths(element, viewport_size);
  if (name == "path") return trace_path(element["d"], tracer);
  if (name == "polyline") return trace_points(element["points"], PointsEnd::Open, tracer);
  if (name == "polygon") return trace_points(element["points"], PointsEnd::Closed, tracer);
  Vec2 const centre = {lengths.x("cx"), lengths.y("cy")};
  if (name == "rect") trace_rect(lengths, tracer);
  if (name == "circle") trace_ellipse(centre, {lengths.radius("r"), lengths.radius("r")}, tracer);
  if (name == "ellipse") trace_ellipse(centre, lengths.radii(), tracer);
  if (name == "line") {
    tracer.move_to({lengths.x("x1"), lengths.y("y1")});
    tracer.line_to({lengths.x("x2"), lengths.y("y2")});
  }
  return true;
}

double viewport_diagonal(Vec2 viewport_size) { return std::sqrt(squared_norm(viewport_size) / 2); }

}  // namespace inkflate
