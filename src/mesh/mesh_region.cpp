// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh_region.h"

#include <numeric>

#include "mesh/fill_region.h"
#include "mesh/region_triangulation.h"
#include "mesh/relax_region.h"

namespace inkflate {
namespace {

// After three nothing moves that can be seen.
constexpr int kRelaxPasses = 3;
constexpr int kBoxCorners = 4;

FlatMesh without_box(RegionTriangulation const& region) {
  auto const& triangles = region.triangles;
  int const given = triangles.given_count();
  FlatMesh mesh;
  for (int v = 0; v < triangles.vertex_count(); ++v) {
    if (v < given || v >= given + kBoxCorners) mesh.points.push_back(triangles.point(v));
  }
  auto const name = [&](int e) {
    int const v = triangles.corner(e);
    return v < given ? v : v - kBoxCorners;
  };
  for (int t = 0; t < triangles.triangle_count(); ++t) {
    if (region.is_inside[t] != 0)
      mesh.triangles.push_back({name(3 * t), name(3 * t + 1), name(3 * t + 2)});
  }
  return mesh;
}

std::vector<std::vector<int>> numbers(std::vector<std::vector<Vec2>> const& lines, int& next) {
  std::vector<std::vector<int>> result;
  for (auto const& line : lines) {
    result.emplace_back(line.size());
    std::iota(result.back().begin(), result.back().end(), next);
    next += static_cast<int>(line.size());
  }
  return result;
}

}  // namespace

Result<RegionMesh> mesh_region(Region const& region, MeshRegionOptions const& options) {
  auto triangulation = triangulate_region(region.contours, region.seams);
  if (!triangulation) return triangulation.error();
  fill_region(*triangulation, options);
  if (!part_rim(*triangulation))
    return Error{ErrorCode::BadInput, "the region is too thin to be meshed", 0};
  relax_region(*triangulation, kRelaxPasses);
  int next = 0;
  RegionMesh result;
  result.mesh = without_box(*triangulation);
  result.contours = numbers(region.contours, next);
  result.seams = numbers(region.seams, next);
  return result;
}

}  // namespace inkflate
