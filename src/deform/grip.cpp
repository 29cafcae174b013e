// SPDX-License-Identifier: Apache-2.0
#include "deform/grip.h"

#include <algorithm>
#include <utility>

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
    : mesh_(&mesh), triangles_(mesh.rest), factors_(mesh.rest.triangles.size(), 1.0) {}

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
      for (int const t : triangles_[v]) {
        if (is_reached[t]) continue;
        is_reached[t] = true;
        reached.push_back(t);
      }
    }
  }
}

}  // namespace inkflate
