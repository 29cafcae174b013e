// SPDX-License-Identifier: Apache-2.0
#include "support/depth_order.h"

#include <cmath>
#include <map>

#include "mesh/triangle_grid.h"

namespace inkflate::support {
namespace {

constexpr double kSpacingPx = 2;
constexpr double kWrongPx = 1;

/// The edges of a mesh with one triangle only.
std::vector<std::array<int, 2>> border_edges(FlatMesh const& mesh) {
  std::map<std::array<int, 2>, std::array<int, 2>> single;  // sorted edge -> edge
  for (auto const& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      std::array<int, 2> const edge = {t[k], t[(k + 1) % 3]};
      std::array<int, 2> const key = {std::min(edge[0], edge[1]), std::max(edge[0], edge[1])};
      if (auto const twin = single.find(key); twin != single.end()) {
        single.erase(twin);
      } else {
        single.emplace(key, edge);
      }
    }
  }
  std::vector<std::array<int, 2>> result;
  for (auto const& [key, edge] : single) result.push_back(edge);
  return result;
}

Vec3 lift(Vec2 p, double z) { return {p.x, p.y, z}; }

/// Compares one rim with one sheet. sign: 1 where the rim has to be before it
void compare(Sheets const& own, FlatMesh const& mesh, std::vector<double> const& z,
             TriangleGrid const& grid, double sign, std::array<int, 2> layers, DepthOrder& order) {
  for (auto const& [a, b] : own.rim) {
    Vec2 const from = {a.x, a.y};
    Vec2 const to = {b.x, b.y};
    int const pieces = static_cast<int>(std::ceil(distance(from, to) / kSpacingPx));
    for (int n = 0; n < pieces; ++n) {
      double const t = static_cast<double>(n) / pieces;
      Vec2 const p = lerp(from, to, t);
      auto const place = grid.find(p);
      if (!place) continue;
      double const wrong_px = sign * (interpolate(mesh, z, *place) - (a.z + (b.z - a.z) * t));
      ++order.samples;
      if (wrong_px > kWrongPx) ++order.wrong;
      if (wrong_px <= order.worst_px) continue;
      order.worst_px = wrong_px;
      order.worst_at = p;
      order.worst_layers = layers;
    }
  }
}

}  // namespace

std::vector<Sheets> sheets_of(FlatModel const& model, std::span<std::vector<double> const> heights,
                              std::span<std::vector<double> const> depths) {
  std::vector<Sheets> result;
  for (std::size_t i = 0; i < model.layers.size(); ++i) {
    auto const& layer = model.layers[i];
    Sheets sheets;
    for (int side = 0; side < 2; ++side) {
      sheets.meshes[side] = layer.mesh;
      for (std::size_t v = 0; v < heights[i].size(); ++v) {
        sheets.z[side].push_back(depths[i][v] + (side == 0 ? heights[i][v] : -heights[i][v]));
      }
    }
    for (auto const& [a, b] : border_edges(layer.mesh)) {
      if (layer.kinds[a] == VertexKind::Open || layer.kinds[b] == VertexKind::Open) continue;
      sheets.rim.push_back(
          {lift(layer.mesh.points[a], depths[i][a]), lift(layer.mesh.points[b], depths[i][b])});
    }
    result.push_back(sheets);
  }
  return result;
}

std::vector<Sheets> sheets_of(RestModel const& model) {
  std::vector<Sheets> result(model.layer_names.size());
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    auto t = model.mesh.triangles[i];
    Vec2 const a = model.canvas[t[0]];
    if (cross(model.canvas[t[1]] - a, model.canvas[t[2]] - a) < 0) std::swap(t[1], t[2]);
    auto const face = model.faces[i];
    result[face.layer].meshes[face.side == Side::Front ? 0 : 1].triangles.push_back(t);
  }
  for (auto& sheets : result) {
    std::map<std::array<int, 2>, int> border;
    for (int side = 0; side < 2; ++side) {
      sheets.meshes[side].points = model.canvas;
      for (auto const& p : model.mesh.points) sheets.z[side].push_back(p.z);
      for (auto [a, b] : border_edges(sheets.meshes[side])) {
        if (a > b) std::swap(a, b);
        if (++border[{a, b}] < 2) continue;
        sheets.rim.push_back({lift(model.canvas[a], model.mesh.points[a].z),
                              lift(model.canvas[b], model.mesh.points[b].z)});
      }
    }
  }
  return result;
}

DepthOrder measure_depth_order(std::span<Sheets const> layers) {
  DepthOrder order;
  for (int i = 0; i < std::ssize(layers); ++i) {
    for (int side = 0; side < 2; ++side) {
      auto const& mesh = layers[i].meshes[side];
      if (mesh.triangles.empty()) continue;
      TriangleGrid const grid(mesh);
      // The rims of layers before it are before its front sheet; those of layers behind it behind its back sheet.
      int const first = side == 0 ? i + 1 : 0;
      int const last = side == 0 ? static_cast<int>(layers.size()) : i;
      for (int j = first; j < last; ++j) {
        compare(layers[j], mesh, layers[i].z[side], grid, side == 0 ? 1 : -1, {j, i}, order);
      }
    }
  }
  return order;
}

}  // namespace inkflate::support
