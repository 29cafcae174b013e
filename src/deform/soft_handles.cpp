// SPDX-License-Identifier: Apache-2.0
#include "deform/soft_handles.h"

#include <algorithm>
#include <cmath>

#include "deform/grip.h"
#include "geometry/complex.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

// Large enough to hold a limb's width by a few vertices, small enough to leave the rest of it alone.
constexpr double kRingEdges = 2;
// Of one vertex of the ring, beside the handle's own.
constexpr double kRingShare = 0.1;

// The largest turn that is asked for at once, 0.5 rad: chords and arcs are still nearly the same.
constexpr Vec2 kLargestTurn = {0.87758256189037271612, 0.47942553860420300027};

}  // namespace

SoftHandles::SoftHandles(BendMesh const& mesh, std::span<BendHandle const> handles) : mesh_(&mesh) {
  strength_ = kStrength * *std::max_element(mesh.stiffness.begin(), mesh.stiffness.end());
  for (auto const& handle : handles) {
    // What is held by a grip resists the more.
    double const strength = handle.grip_px > 0 ? strength_ * Grips::kStiffest : strength_;
    places_.push_back({handle.anchor, handle.target, handle.firmness * strength});
  }
  add_turned(handles);
}

void SoftHandles::add_turned(std::span<BendHandle const> handles) {
  auto const is_turned = [](BendHandle const& handle) { return handle.turn_rad.has_value(); };
  if (std::none_of(handles.begin(), handles.end(), is_turned)) return;
  TrianglesAt const triangles(mesh_->rest);
  std::vector<char> is_in(mesh_->rest.points.size(), false);
  for (auto const& handle : handles) {
    if (!is_turned(handle)) continue;
    auto const turn = sin_cos(*handle.turn_rad);
    turned_.push_back(
        {&handle, ring_around(handle.anchor, triangles, is_in), {turn.cos, turn.sin}});
  }
}

/// The vertices near a place that hang together with it there: not those across a gap. is_in: all false, and so left
std::vector<SoftHandles::RingVertex> SoftHandles::ring_around(BendAnchor const& anchor,
                                                              TrianglesAt const& triangles,
                                                              std::vector<char>& is_in) const {
  auto const& mesh = mesh_->rest;
  Vec2 const centre = place_of(mesh, mesh.points, anchor);
  double const reach_px = kRingEdges * mesh_->edge_px;
  std::vector<RingVertex> ring;
  auto const add = [&](int triangle, int corner) {
    int const vertex = mesh.triangles[triangle][corner];
    if (is_in[vertex]) return;
    is_in[vertex] = true;
    ring.push_back({vertex, corner_anchor(triangle, corner), mesh.points[vertex] - centre});
  };
  for (int corner = 0; corner < 3; ++corner) add(anchor.triangle, corner);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (int const t : triangles[ring[i].vertex]) {
      auto const& corners = mesh.triangles[t];
      for (int corner = 0; corner < 3; ++corner) {
        if (distance(mesh.points[corners[corner]], centre) <= reach_px) add(t, corner);
      }
    }
  }
  for (auto const& v : ring) is_in[v.vertex] = false;
  return ring;
}

void SoftHandles::add_ring(Turned const& turned, Vec2 direction, std::vector<Pull>& pulls) const {
  for (auto const& v : turned.ring) {
    pulls.push_back(
        {v.anchor, turned.handle->target + product(v.arm, direction), strength_ * kRingShare});
  }
}

std::vector<Pull> SoftHandles::pulls() const {
  auto result = places_;
  for (auto const& turned : turned_) add_ring(turned, turned.direction, result);
  return result;
}

std::vector<Pull> SoftHandles::pulls_from(std::span<Vec2 const> pose) const {
  auto result = places_;
  for (auto const& turned : turned_) {
    // The turn that takes the arms at rest nearest to those of the pose.
    Vec2 const centre = place_of(mesh_->rest, pose, turned.handle->anchor);
    Vec2 sum;
    for (auto const& v : turned.ring) sum += product(pose[v.vertex] - centre, conjugate(v.arm));
    Vec2 const present = normalized(sum);
    Vec2 const rest_of_turn = product(turned.direction, conjugate(present));
    bool const is_within = squared_norm(present) == 0 || rest_of_turn.x >= kLargestTurn.x;
    Vec2 const part = {kLargestTurn.x, rest_of_turn.y < 0 ? -kLargestTurn.y : kLargestTurn.y};
    add_ring(turned, is_within ? turned.direction : product(present, part), result);
  }
  return result;
}

double pull_energy(Pull const& pull, Vec2 place, double edge_px) {
  double const reach = Pull::kReachEdges * edge_px;
  double const squared = squared_norm(place - pull.target);
  if (squared <= reach * reach) return pull.strength * squared;
  return pull.strength * reach * (2 * std::sqrt(squared) - reach);
}

Vec2 pull_gradient(Pull const& pull, Vec2 place, double edge_px) {
  Vec2 const away = place - pull.target;
  double const length = norm(away);
  double const reach = Pull::kReachEdges * edge_px;
  return away * (2 * pull.strength * (length <= reach ? 1 : reach / length));
}

}  // namespace inkflate
