// SPDX-License-Identifier: Apache-2.0
#include "deform/grip.h"

#include <algorithm>

namespace inkflate {
namespace {

Vec2 middle(FlatMesh const& mesh, Triangle const& corners) {
  return (mesh.points[corners[0]] + mesh.points[corners[1]] + mesh.points[corners[2]]) / 3;
}

double factor_at(double squared_share) {
  double const left = 1 - squared_share;
  return 1 + (Grips::kStiffest - 1) * left * left;
}

}  // namespace

Grips::Grips(BendMesh const& mesh)
    : mesh_(&mesh),
      starts_(mesh.rest.points.size() + 1, 0),
      fans_(3 * mesh.rest.triangles.size()),
      factors_(mesh.rest.triangles.size(), 1.0) {
  for (auto const& corners : mesh.rest.triangles) {
    for (int const v : corners) ++starts_[v + 1];
  }
  for (std::size_t v = 1; v < starts_.size(); ++v) starts_[v] += starts_[v - 1];
  auto next = starts_;
  for (int t = 0; t < static_cast<int>(mesh.rest.triangles.size()); ++t) {
    for (int const v : mesh.rest.triangles[t]) fans_[next[v]++] = t;
  }
}

bool Grips::update(std::span<BendHandle const> handles) {
  std::vector<Grip> grips;
  for (auto const& handle : handles) {
    if (handle.grip_px > 0) grips.push_back({handle.anchor, handle.grip_px});
  }
  if (grips == grips_) return false;
  grips_ = std::move(grips);
  std::fill(factors_.begin(), factors_.end(), 1.0);
  for (auto const& grip : grips_) stiffen(grip);
  return true;
}

void Grips::stiffen(Grip const& grip) {
  auto const& rest = mesh_->rest;
  Vec2 const centre = place_of(rest, rest.points, grip.anchor);
  double const squared_radius = grip.radius_px * grip.radius_px;
  std::vector<int> reached = {grip.anchor.triangle};
  std::vector<char> is_reached(rest.triangles.size(), false);
  is_reached[grip.anchor.triangle] = true;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    auto const& corners = rest.triangles[reached[i]];
    double const share = squared_norm(middle(rest, corners) - centre) / squared_radius;
    if (share >= 1) continue;
    auto& factor = factors_[reached[i]];
    factor = std::max(factor, factor_at(share));
    for (int const v : corners) {
      for (int k = starts_[v]; k < starts_[v + 1]; ++k) {
        if (is_reached[fans_[k]]) continue;
        is_reached[fans_[k]] = true;
        reached.push_back(fans_[k]);
      }
    }
  }
}

}  // namespace inkflate
