// SPDX-License-Identifier: Apache-2.0
#include "deform/rigid_freedom.h"

#include <algorithm>

#include "mesh/connected_vertices.h"

namespace inkflate {
namespace {

// Places nearer than this to each other, in edges, cannot hold a piece from turning.
constexpr double kSamePlaceEdges = 1e-6;

// Shifts shorter than this are rounding: a piece that is where it shall be stays so to the last bit.
constexpr double kLeastShiftPx = 1e-7;

}  // namespace

RigidFreedom::RigidFreedom(BendMesh const& mesh)
    : mesh_(&mesh), piece_of_(connected_vertices(mesh.rest)), vertex_anchors_(piece_of_.size()) {
  for (int v = 0; v < static_cast<int>(piece_of_.size()); ++v) {
    if (piece_of_[v] == v) {
      piece_of_[v] = static_cast<int>(pieces_.size());
      pieces_.emplace_back();
    } else {
      piece_of_[v] = piece_of_[piece_of_[v]];
    }
    pieces_[piece_of_[v]].vertices.push_back(v);
  }
  for (int t = 0; t < static_cast<int>(mesh.rest.triangles.size()); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      vertex_anchors_[mesh.rest.triangles[t][corner]] = corner_anchor(t, corner);
    }
  }
}

void RigidFreedom::hold_at(int index, BendAnchor const& anchor) {
  auto& piece = pieces_[index];
  if (piece.freedom == Freedom::All) {
    piece.freedom = Freedom::Turn;
    piece.centre = anchor;
  } else if (piece.freedom == Freedom::Turn) {
    auto const& rest = mesh_->rest;
    double const apart =
        distance(place_of(rest, rest.points, piece.centre), place_of(rest, rest.points, anchor));
    if (apart > kSamePlaceEdges * mesh_->edge_px) piece.freedom = Freedom::None;
  }
}

void RigidFreedom::set_hold(BendHold const& hold) {
  for (auto& piece : pieces_) {
    piece.freedom = Freedom::All;
    piece.handle_count = 0;
  }
  for (auto const& handle : hold.handles) {
    int const index = piece_of_[mesh_->rest.triangles[handle.anchor.triangle][0]];
    auto& piece = pieces_[index];
    hold_at(index, handle.anchor);
    if (handle.turn_rad) piece.freedom = Freedom::None;
    ++piece.handle_count;
    piece.target = handle.target;
  }
  for (int v = 0; v < static_cast<int>(std::ssize(piece_of_)); ++v) {
    bool const is_fixed = !hold.is_fixed.empty() && hold.is_fixed[v];
    bool const is_tethered = !hold.tethers.empty() && hold.tethers[v] > 0;
    if (!is_fixed && !is_tethered) continue;
    hold_at(piece_of_[v], vertex_anchors_[v]);
    pieces_[piece_of_[v]].handle_count = 0;
  }
}

double RigidFreedom::shift_to_targets(BendPose& pose) const {
  double largest_px = 0;
  for (auto const& piece : pieces_) {
    if (piece.freedom != Freedom::Turn || piece.handle_count != 1) continue;
    Vec2 const shift = piece.target - place_of(mesh_->rest, pose, piece.centre);
    if (norm(shift) < kLeastShiftPx) continue;
    for (int const v : piece.vertices) pose[v] += shift;
    largest_px = std::max(largest_px, norm(shift));
  }
  return largest_px;
}

void RigidFreedom::remove_from(std::span<Vec2> moves, std::span<Vec2 const> pose) const {
  for (auto const& piece : pieces_) {
    if (piece.freedom == Freedom::None) continue;
    bool const is_held = piece.freedom == Freedom::Turn;
    Vec2 centre = is_held ? place_of(mesh_->rest, pose, piece.centre) : Vec2{};
    Vec2 shift = is_held ? place_of(mesh_->rest, moves, piece.centre) : Vec2{};
    double const share = is_held ? 0 : 1 / static_cast<double>(piece.vertices.size());
    for (int const v : piece.vertices) {
      centre += pose[v] * share;
      shift += moves[v] * share;
    }
    double turn = 0;
    double inertia = 0;
    for (int const v : piece.vertices) {
      Vec2 const arm = pose[v] - centre;
      turn += cross(arm, moves[v] - shift);
      inertia += squared_norm(arm);
    }
    double const angle = inertia > 0 ? turn / inertia : 0;
    Vec2 const free_shift = is_held ? Vec2{} : shift;
    for (int const v : piece.vertices) {
      moves[v] -= free_shift + perpendicular(pose[v] - centre) * angle;
    }
  }
}

}  // namespace inkflate
