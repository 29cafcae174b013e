// SPDX-License-Identifier: Apache-2.0
#include "figure_drag.h"

#include <array>

#include "support/bend_meshes.h"

namespace inkflate {
namespace {

constexpr Vec2 kDrag = {-60, -143};
constexpr Vec2 kHand = {920, 230};
constexpr Vec2 kOtherHand = {80, 230};
constexpr std::array<Vec2, 2> kPins = {{{325, 905}, {650, 560}}};

enum class Part { LeftArm, RightArm, Head, Trunk, LeftLeg, RightLeg };
constexpr std::array kParts = {Part::LeftArm, Part::RightArm, Part::Head,
                               Part::Trunk,   Part::LeftLeg,  Part::RightLeg};

Part part_of(Vec2 rest) {
  bool const is_above_hips = rest.y < 420;
  if (is_above_hips && rest.x < 350) return Part::LeftArm;
  if (is_above_hips && rest.x > 650) return Part::RightArm;
  if (rest.y < 270) return Part::Head;
  if (rest.y < 620) return Part::Trunk;
  return rest.x < 500 ? Part::LeftLeg : Part::RightLeg;
}

/// Takes +x to a direction of length 1: the turn that best takes the one list to the other, both around their means.
class BestTurn {
 public:
  void add(Vec2 from, Vec2 to, double weight = 1) {
    sum_ += Vec2{dot(from, to), cross(from, to)} * weight;
  }
  Vec2 of(Vec2 p) const {
    auto const [cos, sin] = normalized(sum_);
    return {cos * p.x - sin * p.y, sin * p.x + cos * p.y};
  }

 private:
  Vec2 sum_;
};

Vec2 mean(std::span<Vec2 const> points) {
  Vec2 sum;
  for (auto const p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

BendHandle at_rest(BendMesh const& mesh, Vec2 place) {
  int const v = support::nearest_vertex(mesh.rest, place);
  return {support::anchor_of(mesh.rest, v), mesh.rest.points[v]};
}

/// The sum over the points of one part.
double misfit(std::span<Vec2 const> rest, std::span<Vec2 const> now) {
  if (rest.empty()) return 0;
  Vec2 const from = mean(rest);
  Vec2 const to = mean(now);
  BestTurn turn;
  for (std::size_t i = 0; i < rest.size(); ++i) turn.add(rest[i] - from, now[i] - to);
  double sum = 0;
  for (std::size_t i = 0; i < rest.size(); ++i)
    sum += distance(to + turn.of(rest[i] - from), now[i]);
  return sum;
}

}  // namespace

Contour figure_contour(int points) {
  auto const mesh = support::figure_mesh(points);
  Contour contour;
  for (int const v : mesh.lines[0].vertices) contour.push_back(mesh.rest.points[v]);
  return contour;
}

Outline figure_outline(int points) {
  auto const contour = figure_contour(points);
  Outline outline;
  for (std::size_t i = 0; i < contour.size(); ++i)
    outline.pieces.push_back({line_cubic(contour[i], contour[(i + 1) % contour.size()])});
  return outline;
}

std::vector<BendHandle> figure_handles(BendMesh const& mesh, double share) {
  std::vector<BendHandle> handles;
  for (auto const place : kPins) handles.push_back(at_rest(mesh, place));
  handles.push_back(at_rest(mesh, kHand));
  handles.back().target += kDrag * share;
  return handles;
}

BendHandle figure_pin(BendMesh const& mesh) { return at_rest(mesh, kOtherHand); }

double figure_shape_error(std::span<Vec2 const> rest, std::span<Vec2 const> now) {
  double sum = 0;
  for (auto const part : kParts) {
    std::vector<Vec2> own_rest;
    std::vector<Vec2> own_now;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (part_of(rest[i]) != part) continue;
      own_rest.push_back(rest[i]);
      own_now.push_back(now[i]);
    }
    sum += misfit(own_rest, own_now);
  }
  return sum / static_cast<double>(rest.size());
}

Vec2 moved_by_least_squares(Vec2 place, std::span<Vec2 const> from, std::span<Vec2 const> to) {
  Vec2 from_sum;
  Vec2 to_sum;
  double weights = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] == place) return to[i];
    double const weight = 1 / squared_norm(place - from[i]);
    from_sum += from[i] * weight;
    to_sum += to[i] * weight;
    weights += weight;
  }
  BestTurn turn;
  for (std::size_t i = 0; i < from.size(); ++i)
    turn.add(from[i] - from_sum / weights, to[i] - to_sum / weights,
             1 / squared_norm(place - from[i]));
  return to_sum / weights + turn.of(place - from_sum / weights);
}

}  // namespace inkflate
