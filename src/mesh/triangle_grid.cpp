// SPDX-License-Identifier: Apache-2.0
#include "mesh/triangle_grid.h"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.h"

namespace inkflate {
namespace {

/// How far outside of a triangle, as a share of it, a point still counts as inside: rounding may not open gaps along edges.
constexpr double kEdgeTolerance = 1e-9;

Rect box_of(FlatMesh const& mesh, Triangle const& t) {
  std::array<Vec2, 3> const corners = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
  return bounds(corners);
}

}  // namespace

TriangleGrid::TriangleGrid(FlatMesh const& mesh) : mesh_(mesh), box_(bounds(mesh.points)) {
  double const buckets = static_cast<double>(mesh.triangles.size()) / 2 + 1;
  side_ = std::max({std::sqrt(box_.width() * box_.height() / buckets), box_.width() / buckets,
                    box_.height() / buckets, 1e-9});
  columns_ = static_cast<int>(box_.width() / side_) + 1;
  rows_ = static_cast<int>(box_.height() / side_) + 1;
  starts_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  auto const for_each_bucket = [&](Triangle const& t, auto visit) {
    Rect const box = box_of(mesh, t);
    for (int y = row(box.min.y); y <= row(box.max.y); ++y) {
      for (int x = column(box.min.x); x <= column(box.max.x); ++x) visit(y * columns_ + x);
    }
  };
  for (auto const& t : mesh.triangles) {
    for_each_bucket(t, [&](int bucket) { ++starts_[bucket + 1]; });
  }
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  items_.resize(starts_.back());
  auto next = starts_;
  for (int i = 0; i < std::ssize(mesh.triangles); ++i) {
    for_each_bucket(mesh.triangles[i], [&](int bucket) { items_[next[bucket]++] = i; });
  }
}

int TriangleGrid::column(double x) const {
  return std::clamp(static_cast<int>((x - box_.min.x) / side_), 0, columns_ - 1);
}

int TriangleGrid::row(double y) const {
  return std::clamp(static_cast<int>((y - box_.min.y) / side_), 0, rows_ - 1);
}

template <typename Visit>
void TriangleGrid::visit_at(Vec2 p, Visit visit) const {
  if (p.x < box_.min.x || p.y < box_.min.y || p.x > box_.max.x || p.y > box_.max.y) return;
  int const bucket = row(p.y) * columns_ + column(p.x);
  for (int k = starts_[bucket]; k < starts_[bucket + 1]; ++k) {
    auto const& t = mesh_.triangles[items_[k]];
    Vec2 const a = mesh_.points[t[0]] - p;
    Vec2 const b = mesh_.points[t[1]] - p;
    Vec2 const c = mesh_.points[t[2]] - p;
    std::array<double, 3> const parts = {cross(b, c), cross(c, a), cross(a, b)};
    double const whole = parts[0] + parts[1] + parts[2];
    if (whole <= 0 || std::min({parts[0], parts[1], parts[2]}) < -kEdgeTolerance * whole) continue;
    if (!visit({items_[k], {parts[0] / whole, parts[1] / whole, parts[2] / whole}})) return;
  }
}

std::optional<MeshPlace> TriangleGrid::find(Vec2 p) const {
  std::optional<MeshPlace> found;
  visit_at(p, [&](MeshPlace const& place) {
    found = place;
    return false;
  });
  return found;
}

std::vector<MeshPlace> TriangleGrid::find_all(Vec2 p) const {
  std::vector<MeshPlace> found;
  visit_at(p, [&](MeshPlace const& place) {
    found.push_back(place);
    return true;
  });
  return found;
}

double interpolate(FlatMesh const& mesh, std::vector<double> const& values,
                   MeshPlace const& place) {
  auto const& t = mesh.triangles[place.triangle];
  return values[t[0]] * place.shares[0] + values[t[1]] * place.shares[1] +
         values[t[2]] * place.shares[2];
}

}  // namespace inkflate
