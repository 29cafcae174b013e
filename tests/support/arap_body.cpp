// SPDX-License-Identifier: Apache-2.0
#include "support/arap_body.h"

#include <algorithm>
#include <utility>

#include "geometry/complex.h"

namespace inkflate::support {
namespace {

// As soft_handles has it.
constexpr double kStrength = 1000;

/// J as z -> turn z + fold conj(z).
struct Motion {
  Vec2 turn;
  Vec2 fold;
};

Motion motion_of(RestTriangle const& rest, Triangle const& corners, std::span<Vec2 const> pose) {
  Motion motion;
  for (std::size_t k = 0; k < 3; ++k) {
    motion.turn += product(pose[corners[k]], conjugate(rest.slopes[k])) / 2;
    motion.fold += product(pose[corners[k]], rest.slopes[k]) / 2;
  }
  return motion;
}

std::vector<RestTriangle> rest_of(BendMesh const& mesh) {
  std::vector<RestTriangle> rest;
  for (std::size_t t = 0; t < mesh.rest.triangles.size(); ++t) {
    auto const& [a, b, c] = mesh.rest.triangles[t];
    auto const& points = mesh.rest.points;
    rest.push_back(rest_triangle({points[a], points[b], points[c]}, mesh.stiffness[t]));
  }
  return rest;
}

SparseCholesky factor_of(BendMesh const& mesh, std::span<RestTriangle const> rest,
                         std::span<BendHandle const> handles) {
  std::vector<MatrixEntry> entries;
  auto const add = [&](Triangle const& corners, auto const& value) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (corners[i] >= corners[j]) entries.push_back({corners[i], corners[j], value(i, j)});
      }
    }
  };
  for (std::size_t t = 0; t < rest.size(); ++t) {
    add(mesh.rest.triangles[t], [&](std::size_t i, std::size_t j) {
      return rest[t].weight * dot(rest[t].slopes[i], rest[t].slopes[j]);
    });
  }
  for (auto const& handle : handles) {
    auto const& weights = handle.anchor.weights;
    add(mesh.rest.triangles[handle.anchor.triangle],
        [&](std::size_t i, std::size_t j) { return kStrength * weights[i] * weights[j]; });
  }
  return SparseCholesky::factor(static_cast<int>(std::ssize(mesh.rest.points)), entries).value();
}

}  // namespace

ArapBody::ArapBody(BendMesh const& mesh, std::vector<BendHandle> handles)
    : mesh_(mesh),
      handles_(std::move(handles)),
      rest_(rest_of(mesh)),
      factor_(factor_of(mesh, rest_, handles_)) {}

double ArapBody::energy(std::span<Vec2 const> pose) const {
  double sum = 0;
  for (std::size_t t = 0; t < rest_.size(); ++t) {
    auto const [turn, fold] = motion_of(rest_[t], mesh_.rest.triangles[t], pose);
    sum += 2 * rest_[t].weight * (squared_norm(turn - normalized(turn)) + squared_norm(fold));
  }
  for (auto const& handle : handles_) {
    sum += kStrength * squared_norm(place_of(mesh_.rest, pose, handle.anchor) - handle.target);
  }
  return sum;
}

BendPose ArapBody::next(std::span<Vec2 const> pose) const {
  BendPose right(pose.size());
  for (std::size_t t = 0; t < rest_.size(); ++t) {
    auto const& corners = mesh_.rest.triangles[t];
    auto const turn = normalized(motion_of(rest_[t], corners, pose).turn);
    for (std::size_t k = 0; k < 3; ++k)
      right[corners[k]] += product(rest_[t].slopes[k], turn) * rest_[t].weight;
  }
  for (auto const& [anchor, target, turn_rad, grip_px, firmness] : handles_) {
    for (std::size_t k = 0; k < 3; ++k)
      right[mesh_.rest.triangles[anchor.triangle][k]] += target * (kStrength * anchor.weights[k]);
  }
  std::vector<double> values;
  for (Vec2 const p : right) values.insert(values.end(), {p.x, p.y});
  factor_.solve(values, 2);
  for (std::size_t v = 0; v < right.size(); ++v) right[v] = {values[2 * v], values[2 * v + 1]};
  return right;
}

}  // namespace inkflate::support
