// SPDX-License-Identifier: Apache-2.0
#include "deform/wire_solver.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/check.h"
#include "deform/wire_system.h"
#include "geometry/complex.h"
#include "geometry/trig.h"
#include "mesh/connected_vertices.h"

namespace inkflate {
namespace {

// Of the last iteration. What follows adds up to some hundred times as much, where convergence is slow.
constexpr double kSettledPx = 1e-8;

// A rotation by t is the complex number (cos t, sin t).
Vec2 unit_rotation(Vec2 sum) {
  auto const rotation = normalized(sum);
  return rotation == Vec2{} ? Vec2{1, 0} : rotation;
}

}  // namespace

struct WireSolver::Inside {
  BendMesh const& mesh;
  std::vector<WireEdge> edges;
  std::vector<int> components;
  WireSystem loose;                // nothing is fixed
  std::optional<WireSystem> held;  // what was fixed last

  explicit Inside(BendMesh const& of)
      : mesh(of),
        edges(wire_edges(of)),
        components(connected_vertices(of.rest)),
        loose(edges, components, std::vector<char>(components.size(), 0)) {}

  WireSystem& system(std::span<char const> is_fixed);
  std::vector<WireConstraint> constraints(std::span<BendHandle const> handles) const;
  std::vector<Vec2> rotations(std::span<Vec2 const> pose) const;
  std::vector<Vec2> residuals(std::span<Vec2 const> pose) const;
  double energy(std::span<Vec2 const> pose) const;
};

WireSystem& WireSolver::Inside::system(std::span<char const> is_fixed) {
  if (std::none_of(is_fixed.begin(), is_fixed.end(), [](char fixed) { return fixed != 0; }))
    return loose;
  CHECK(std::ssize(is_fixed) == std::ssize(components), "one per vertex");
  std::vector<char> now(is_fixed.begin(), is_fixed.end());
  if (!held || held->is_fixed() != now) held.emplace(edges, components, std::move(now));
  return *held;
}

/// A turned handle holds the corners of its triangle, and with them the place between.
std::vector<WireConstraint> WireSolver::Inside::constraints(
    std::span<BendHandle const> handles) const {
  std::vector<WireConstraint> result;
  for (auto const& [anchor, target, turn_rad, grip_px, firmness] : handles) {
    auto const& corners = mesh.rest.triangles[anchor.triangle];
    if (!turn_rad) {
      result.push_back({corners, anchor.weights, target});
      continue;
    }
    auto const& p = mesh.rest.points;
    auto const [sin, cos] = sin_cos(*turn_rad);
    Vec2 place;
    for (int k = 0; k < 3; ++k) place += p[corners[k]] * anchor.weights[k];
    for (int const corner : corners) {
      auto const turned = product({cos, sin}, p[corner] - place);
      result.push_back({{corner, corner, corner}, {1, 0, 0}, target + turned});
    }
  }
  return result;
}

/// Eq. 4.7 and 4.8: of all rotations the one nearest to the sum of products is its direction, as a complex number.
std::vector<Vec2> WireSolver::Inside::rotations(std::span<Vec2 const> pose) const {
  std::vector<Vec2> sums(pose.size());
  for (auto const& [a, b, weight, rest] : edges) {
    auto const turned = product(pose[a] - pose[b], conjugate(rest)) * weight;
    sums[a] += turned;
    sums[b] += turned;
  }
  for (auto& sum : sums) sum = unit_rotation(sum);
  return sums;
}

/// Right minus left side of eq. 4.9.
std::vector<Vec2> WireSolver::Inside::residuals(std::span<Vec2 const> pose) const {
  auto const turns = rotations(pose);
  std::vector<Vec2> result(pose.size());
  for (auto const& [a, b, weight, rest] : edges) {
    auto const wanted = product((turns[a] + turns[b]) / 2, rest);
    auto const pull = (wanted - (pose[a] - pose[b])) * weight;
    result[a] += pull;
    result[b] -= pull;
  }
  return result;
}

/// Eq. 4.2: each edge is in the cells of both of its vertices.
double WireSolver::Inside::energy(std::span<Vec2 const> pose) const {
  auto const turns = rotations(pose);
  double sum = 0;
  for (auto const& [a, b, weight, rest] : edges) {
    auto const now = pose[a] - pose[b];
    sum += weight * (squared_norm(now - product(turns[a], rest)) +
                     squared_norm(now - product(turns[b], rest)));
  }
  return sum;
}

WireSolver::WireSolver(BendMesh const& mesh) : inside_(std::make_unique<Inside>(mesh)) {}
WireSolver::~WireSolver() = default;
WireSolver::WireSolver(WireSolver&&) noexcept = default;
WireSolver& WireSolver::operator=(WireSolver&&) noexcept = default;

BendProgress WireSolver::step(BendPose& pose, BendHold const& hold, int steps) {
  CHECK(pose.size() == inside_->mesh.rest.points.size(), "one place per vertex");
  auto& system = inside_->system(hold.is_fixed);
  system.hold(inside_->constraints(hold.handles));
  BendProgress progress;
  for (int i = 0; i < steps && !progress.is_settled; ++i) {
    auto moves = inside_->residuals(pose);
    system.solve(moves, pose);
    progress.largest_move_px = 0;
    for (std::size_t v = 0; v < pose.size(); ++v) {
      pose[v] += moves[v];
      progress.largest_move_px = std::max(progress.largest_move_px, norm(moves[v]));
    }
    progress.is_settled = progress.largest_move_px <= kSettledPx;
  }
  progress.energy = energy(pose);
  return progress;
}

double WireSolver::energy(std::span<Vec2 const> pose) const { return inside_->energy(pose); }

}  // namespace inkflate
