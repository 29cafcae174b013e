// SPDX-License-Identifier: Apache-2.0
#include "deform/ride.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "deform/line_in_sheets.h"
#include "geometry/segment.h"

namespace inkflate {
namespace {

// Beside a line, up to so many edges away, a place passes from riding on the line's nearest place to riding after all that is near.
constexpr double kOwnReach = 2;
// What is near: so many times as far away as the nearest point, and so many edges more.
constexpr double kNearFactor = 2.5;
constexpr double kNearEdges = 2;
// What reaches farther than so many edges takes every second point of the lines, what reaches twice as far every fourth, and so on: else
// each of a thousand samples far outside would hang on every point there is. No place beside a line that is its own reaches so far.
constexpr double kFineReachEdges = 8;

double smoothstep(double t) { return t * t * (3 - 2 * t); }

}  // namespace

RidePlaces::RidePlaces(ShapeMesh const& shape) : shape_(&shape), triangles_(shape.mesh.rest) {
  for (auto const& line : shape.mesh.lines) add_line_points(line);
  CHECK(!line_points_.empty(), "a mesh to ride on has lines");
  std::vector<Vec2> points;
  for (auto const& own : line_points_) {
    points.push_back(own.place);
    longest_edge_px_ =
        std::max(longest_edge_px_, distance(own.place, shape.mesh.rest.points[own.next]));
  }
  box_ = bounds(points);
  grid_.emplace(points, kOwnReach * shape.mesh.edge_px);
}

void RidePlaces::add_line_points(BendLine const& line) {
  auto const& points = shape_->mesh.rest.points;
  int const count = static_cast<int>(std::ssize(line.vertices));
  auto const first = line_points_.size();
  for (int i = 0; i < count; ++i) {
    bool const is_end = !line.is_closed && i + 1 == count;
    int const vertex = line.vertices[i];
    line_points_.push_back({vertex, is_end ? vertex : line.vertices[(i + 1) % count],
                            points[vertex], 0, i, count - i});
  }
  for (int i = 0; i < count; ++i) {
    auto& own = line_points_[first + i];
    double const half = distance(own.place, points[own.next]) / 2;
    own.length_px += half;
    line_points_[first + (i + 1) % count].length_px += half;
  }
  // A dot has no length of its own.
  if (count == 1) line_points_.back().length_px = 1;
}

int RidePlaces::finish(Vec2 place) {
  places_.push_back(place);
  starts_.push_back(static_cast<int>(std::ssize(terms_)));
  return static_cast<int>(std::ssize(places_)) - 1;
}

int RidePlaces::add_on_line(int line, double parameter, Vec2 place) {
  auto const& vertices = shape_->mesh.lines[line].vertices;
  auto const& parameters = shape_->origins[line].parameters;
  int const count = static_cast<int>(std::ssize(vertices));
  auto const next = std::upper_bound(parameters.begin(), parameters.end(), parameter);
  int i = static_cast<int>(next - parameters.begin()) - 1;
  if (shape_->mesh.lines[line].is_closed) {
    i = (i + count) % count;
  } else {
    i = std::clamp(i, 0, std::max(0, count - 2));
  }
  add_edge(vertices[i], vertices[(i + 1) % count], place, 1);
  return finish(place);
}

int RidePlaces::add(Vec2 place) {
  return add_in(place, shape_->is_filled ? triangles_.find(place) : std::nullopt);
}

std::vector<int> RidePlaces::add_line(std::span<Vec2 const> line) {
  std::vector<int> indices;
  if (shape_->sheets.empty()) {
    for (Vec2 const place : line) indices.push_back(add(place));
    return indices;
  }
  auto const inside = line_in_sheets(*shape_, triangles_, line);
  for (std::size_t k = 0; k < line.size(); ++k) indices.push_back(add_in(line[k], inside[k]));
  return indices;
}

int RidePlaces::add_in(Vec2 place, std::optional<MeshPlace> const& inside) {
  if (inside) {
    add_triangle(*inside);
  } else {
    add_near(place);
  }
  return finish(place);
}

/// The cubic over a triangle with the shifts and changes of its corners, and a middle that makes it exact for quadratic shifts.
void RidePlaces::add_triangle(MeshPlace const& in) {
  auto const& points = shape_->mesh.rest.points;
  auto const& corners = shape_->mesh.rest.triangles[in.triangle];
  auto const& u = in.shares;
  double const middle = u[0] * u[1] * u[2];
  for (int k = 0; k < 3; ++k) {
    Term term = {corners[k], u[k] * u[k] * u[k] - middle, {}, u[k]};
    for (int const other : {(k + 1) % 3, (k + 2) % 3}) {
      double const part = 3 * u[k] * u[k] * u[other] + 1.5 * middle;
      term.share += part;
      term.arm += (part / 3) * (points[corners[other]] - points[corners[k]]);
    }
    terms_.push_back(term);
  }
}

/// The cubic along an edge with the shifts and changes of its ends; what lies beside the edge follows their changes.
void RidePlaces::add_edge(int from, int to, Vec2 place, double weight) {
  Vec2 const a = shape_->mesh.rest.points[from];
  Vec2 const b = shape_->mesh.rest.points[to];
  double const t = share_along(place, a, b);
  double const s = 1 - t;
  Vec2 const aside = place - lerp(a, b, t);
  double const end = smoothstep(t);
  terms_.push_back(
      {from, weight * (1 - end), weight * (s * s * t * (b - a) + s * aside), weight * s});
  terms_.push_back({to, weight * end, weight * (-s * t * t * (b - a) + t * aside), weight * t});
}

template <typename Visit>
void RidePlaces::visit_near(Vec2 place, double radius, Visit visit) const {
  // Beyond the grid its buckets tell nothing.
  if (radius > box_.longer_side() || !contains(box_.grown(box_.longer_side()), place)) {
    for (auto const& own : line_points_) visit(own);
  } else {
    grid_->near(place, radius, [&](int i) { visit(line_points_[i]); });
  }
}

double RidePlaces::nearest_point_px(Vec2 place) const {
  for (double radius = kOwnReach * shape_->mesh.edge_px;; radius *= 2) {
    double nearest = std::numeric_limits<double>::infinity();
    visit_near(place, radius, [&](LinePoint const& own) {
      nearest = std::min(nearest, squared_norm(own.place - place));
    });
    if (nearest <= radius * radius || radius > box_.longer_side()) return std::sqrt(nearest);
  }
}

void RidePlaces::add_near(Vec2 place) {
  auto const& points = shape_->mesh.rest.points;
  double const nearest_px = nearest_point_px(place);
  double nearest_edge = std::numeric_limits<double>::infinity();
  LinePoint const* edge = nullptr;
  auto const try_edge = [&](LinePoint const& own) {
    double const away = squared_distance_to_segment(place, own.place, points[own.next]);
    if (!(away < nearest_edge)) return;
    nearest_edge = away;
    edge = &own;
  };
  // Whatever is nearer than the nearest point has an end this near.
  visit_near(place, nearest_px + longest_edge_px_, try_edge);
  double const reach = kOwnReach * shape_->mesh.edge_px;
  double const around = smoothstep(std::min(1.0, std::sqrt(nearest_edge) / reach));
  if (around < 1) add_edge(edge->vertex, edge->next, place, 1 - around);
  if (around > 0) add_around(place, nearest_px, around);
}

/// By two of the finenesses of the lines, with a passage from each to the next: so there are no jumps.
void RidePlaces::add_around(Vec2 place, double nearest_px, double weight) {
  double const reach = kNearFactor * nearest_px + kNearEdges * shape_->mesh.edge_px;
  double fine = kFineReachEdges * std::max(shape_->mesh.edge_px, longest_edge_px_);
  int stride = 1;
  for (; reach > 2 * fine && stride < std::ssize(line_points_); stride *= 2) fine *= 2;
  double const coarser = smoothstep(std::clamp(reach / fine - 1, 0.0, 1.0));
  if (coarser < 1) add_all_within(reach, stride, place, nearest_px, weight * (1 - coarser));
  if (coarser > 0) add_all_within(reach, 2 * stride, place, nearest_px, weight * coarser);
}

void RidePlaces::add_all_within(double reach, int stride, Vec2 place, double nearest_px,
                                double weight) {
  auto const first = terms_.size();
  double sum = 0;
  visit_near(place, reach, [&](LinePoint const& own) {
    double const away = distance(own.place, place);
    if (own.rank % stride != 0 || !(away < reach)) return;
    double const fade = (1 - away / reach) * (nearest_px / away);
    double const share = std::min(stride, own.left) * own.length_px * fade * fade;
    terms_.push_back({own.vertex, share, place - own.place, share});
    sum += share;
  });
  for (auto k = first; k < terms_.size(); ++k) {
    auto& term = terms_[k];
    double const share = weight * term.share / sum;
    term = {term.vertex, share, share * term.arm, share};
  }
}

Vec2 RidePlaces::shift(std::span<VertexMotion const> motions, int index) const {
  Vec2 shift;
  for (int k = starts_[index]; k < starts_[index + 1]; ++k) {
    auto const& term = terms_[k];
    auto const& motion = motions[term.vertex];
    shift += term.share * motion.shift + motion.change(term.arm);
  }
  return shift;
}

Linear2 RidePlaces::change(std::span<VertexMotion const> motions, int index) const {
  Linear2 change;
  for (int k = starts_[index]; k < starts_[index + 1]; ++k) {
    auto const& term = terms_[k];
    auto const& own = motions[term.vertex].change;
    change.x += term.frame * own.x;
    change.y += term.frame * own.y;
  }
  return change;
}

}  // namespace inkflate
