// SPDX-License-Identifier: Apache-2.0
#include "support/flat_characters.h"

#include <algorithm>
#include <cmath>

#include "geometry/trig.h"
#include "mesh/delaunay.h"

namespace inkflate::support {
namespace {

constexpr double kCanvasPx = 1000;
constexpr double kRimSpacingPx = 7;
constexpr double kInnerSpacingPx = 13;

/// The open run of a limb, with both ends.
Polyline root_line(Part const& part) {
  Vec2 const from = part.rim.back();
  Vec2 const to = part.rim.front();
  int const pieces = std::max(2, static_cast<int>(distance(from, to) / kRimSpacingPx));
  Polyline line;
  for (int i = 0; i <= pieces; ++i) line.push_back(lerp(from, to, static_cast<double>(i) / pieces));
  return line;
}

bool is_near(std::vector<Vec2> const& points, Vec2 p, double radius) {
  return std::any_of(points.begin(), points.end(),
                     [&](Vec2 q) { return squared_norm(p - q) < radius * radius; });
}

/// Triangles of a convex set of points: their rim comes first.
FlatMesh convex_mesh(std::vector<Vec2> points, Contour const& rim) {
  auto const box = bounds(rim);
  double const least = std::min(0.75 * kInnerSpacingPx, std::min(box.width(), box.height()) / 5);
  double const step = least / 0.75;
  auto const fixed = points;
  int row = 0;
  for (double y = box.min.y; y < box.max.y; y += step * 0.866, ++row) {
    for (double x = box.min.x + (row % 2) * step / 2; x < box.max.x; x += step) {
      if (contains(rim, {x, y}) && !is_near(fixed, {x, y}, least)) points.push_back({x, y});
    }
  }
  std::vector<LatticePoint> lattice;
  for (auto const p : points) {
    lattice.push_back(
        {static_cast<int>(std::lround(p.x * 16)), static_cast<int>(std::lround(p.y * 16))});
  }
  auto const triangulation = delaunay(lattice);
  FlatMesh mesh;
  mesh.points = points;
  for (int t = 0; t < triangulation.triangle_count(); ++t) {
    auto const* c = &triangulation.corners[3 * t];
    Vec2 const centre = (points[c[0]] + points[c[1]] + points[c[2]]) / 3;
    double const area = cross(points[c[1]] - points[c[0]], points[c[2]] - points[c[0]]);
    if (area > 1e-3 && contains(rim, centre)) mesh.triangles.push_back({c[0], c[1], c[2]});
  }
  return mesh;
}

}  // namespace

Part blob(std::string name, Vec2 centre, Vec2 radii) {
  Part part;
  part.name = std::move(name);
  int const count = std::max(16, static_cast<int>(kPi * (radii.x + radii.y) / kRimSpacingPx));
  for (int i = 0; i < count; ++i) {
    auto const angle = sin_cos(2 * kPi * i / count);
    part.rim.push_back(centre + Vec2{radii.x * angle.cos, radii.y * angle.sin});
  }
  return part;
}

Part limb(std::string name, Vec2 root, Vec2 tip, double width, int host) {
  Part part;
  part.name = std::move(name);
  part.host = host;
  part.is_open = true;
  Vec2 const along = normalized(tip - root);
  Vec2 const side = perpendicular(along) * (width / 2);
  double const straight = distance(root, tip) - width / 2;
  double const spacing = std::min(kRimSpacingPx, width / 6);
  int const count = std::max(1, static_cast<int>(straight / spacing));
  for (int i = 0; i < count; ++i) part.rim.push_back(root - side + along * (straight * i / count));
  int const turn = std::max(6, static_cast<int>(kPi * width / 2 / spacing));
  for (int i = 0; i <= turn; ++i) {
    auto const angle = sin_cos(kPi * i / turn);
    part.rim.push_back(root + along * (straight + angle.sin * width / 2) - side * angle.cos);
  }
  for (int i = count - 1; i >= 0; --i) {
    part.rim.push_back(root + side + along * (straight * i / count));
  }
  return part;
}

std::vector<Part> one_part() { return {blob("body", {500, 500}, {200, 150})}; }

std::vector<Part> three_parts() {
  return {blob("body", {500, 500}, {200, 150}), limb("arm", {590, 460}, {780, 380}, 60, 0),
          limb("leg", {440, 590}, {400, 800}, 70, 0)};
}

std::vector<Part> five_parts() {
  return {limb("far leg", {560, 600}, {600, 800}, 70, 1), blob("body", {500, 500}, {200, 150}),
          limb("near leg", {440, 590}, {410, 800}, 70, 1),
          limb("arm", {560, 470}, {330, 440}, 50, 1), blob("eye", {620, 430}, {22, 28})};
}

std::vector<Part> twenty_one_parts() {
  return {limb("far ear", {640, 260}, {690, 110}, 60, 6),
          limb("far leg back", {380, 590}, {350, 800}, 60, 4),
          limb("far leg front", {590, 600}, {620, 800}, 60, 4),
          limb("tail", {330, 480}, {120, 330}, 36, 4),
          blob("body", {480, 500}, {210, 150}),
          blob("spot", {430, 450}, {40, 30}),
          blob("head", {650, 320}, {120, 110}),
          limb("near ear", {600, 250}, {560, 90}, 60, 6),
          limb("near leg back", {380, 590}, {350, 800}, 60, 4),
          limb("near leg front", {590, 600}, {620, 800}, 60, 4),
          blob("eye left", {620, 300}, {26, 32}),
          blob("pupil left", {626, 306}, {11, 13}),
          blob("eye right", {690, 300}, {26, 32}),
          blob("pupil right", {696, 306}, {11, 13}),
          blob("snout", {680, 370}, {60, 38}),
          blob("nose", {700, 350}, {20, 14}),
          limb("tooth", {670, 395}, {668, 440}, 18, 14),
          blob("collar", {570, 420}, {60, 22}),
          blob("badge", {575, 446}, {16, 16}),
          limb("arm", {560, 500}, {760, 560}, 50, 4),
          blob("hat", {655, 225}, {90, 40})};
}

FlatModel flat_model_of(std::vector<Part> const& parts) {
  FlatModel model;
  model.width_px = model.height_px = kCanvasPx;
  for (int i = 0; i < std::ssize(parts); ++i) {
    auto points = parts[i].rim;
    int const drawn = static_cast<int>(points.size());
    if (parts[i].is_open) {
      auto const line = root_line(parts[i]);
      points.insert(points.end(), line.begin() + 1, line.end() - 1);
    }
    int const rim_count = static_cast<int>(points.size());
    for (int k = 0; k < std::ssize(parts); ++k) {
      if (parts[k].host != i) continue;
      for (auto const p : root_line(parts[k])) {
        if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
      }
    }
    FlatLayer layer;
    layer.name = parts[i].name;
    layer.thickness = parts[i].thickness;
    layer.mesh = convex_mesh(points, parts[i].rim);
    layer.kinds.assign(layer.mesh.points.size(), VertexKind::Inside);
    for (int v = 0; v < rim_count; ++v) {
      layer.kinds[v] = v < drawn ? VertexKind::Drawn : VertexKind::Open;
    }
    model.layers.push_back(layer);
  }
  for (int i = 0; i < std::ssize(parts); ++i) {
    if (parts[i].host < 0) continue;
    Joint joint;
    joint.limb = i;
    joint.host = parts[i].host;
    joint.side = joint.limb > joint.host ? Side::Front : Side::Back;
    auto const find = [](std::vector<Vec2> const& points, Vec2 p) {
      return static_cast<int>(std::find(points.begin(), points.end(), p) - points.begin());
    };
    for (auto const p : root_line(parts[i])) {
      joint.limb_vertices.push_back(find(model.layers[joint.limb].mesh.points, p));
      joint.host_vertices.push_back(find(model.layers[joint.host].mesh.points, p));
    }
    model.joints.push_back(joint);
  }
  return model;
}

}  // namespace inkflate::support
