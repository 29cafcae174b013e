// SPDX-License-Identifier: Apache-2.0
#include "support/bend_meshes.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/mesh_region.h"
#include "support/extremes.h"

namespace inkflate::support {
namespace {

/// Each corner cut at a quarter of its sides, again and again (Chaikin).
Contour rounded(Contour corners) {
  for (int round = 0; round < 3; ++round) {
    Contour next;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Vec2 const a = corners[i];
      Vec2 const b = corners[(i + 1) % corners.size()];
      next.push_back(lerp(a, b, 0.25));
      next.push_back(lerp(a, b, 0.75));
    }
    corners = next;
  }
  return corners;
}

/// That many points at the same distance along a contour.
Contour evenly_sampled(Contour contour, int count) {
  contour.push_back(contour.front());
  double const step = length(contour) / count;
  Contour result;
  double passed = 0;
  for (std::size_t i = 0; i + 1 < contour.size(); ++i) {
    double const edge = distance(contour[i], contour[i + 1]);
    while (static_cast<int>(result.size()) < count &&
           static_cast<double>(result.size()) * step < passed + edge) {
      double const along = (static_cast<double>(result.size()) * step - passed) / edge;
      result.push_back(lerp(contour[i], contour[i + 1], along));
    }
    passed += edge;
  }
  return result;
}

}  // namespace

BendMesh bar_mesh(double length_px, double width_px, int columns, int rows) {
  BendMesh mesh;
  for (int i = 0; i <= columns; ++i) {
    for (int j = 0; j <= rows; ++j) {
      mesh.rest.points.push_back({length_px * i / columns, width_px * (2 * j - rows) / (2 * rows)});
    }
  }
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      int const p = i * (rows + 1) + j;
      int const q = p + rows + 1;
      if (2 * j < rows) {
        mesh.rest.triangles.push_back({p, q, q + 1});
        mesh.rest.triangles.push_back({p, q + 1, p + 1});
      } else {
        mesh.rest.triangles.push_back({p, q, p + 1});
        mesh.rest.triangles.push_back({q, q + 1, p + 1});
      }
    }
  }
  mesh.stiffness.assign(mesh.rest.triangles.size(), 1);
  mesh.edge_px = length_px / columns;
  return mesh;
}

BendMesh figure_mesh(int contour_points) {
  Contour const half = {{500, 90},  {590, 90},  {610, 200}, {560, 270}, {640, 290}, {780, 250},
                        {900, 190}, {930, 270}, {800, 340}, {650, 390}, {650, 560}, {690, 700},
                        {730, 900}, {620, 910}, {580, 740}, {540, 610}, {500, 600}};
  Contour outline = half;
  for (std::size_t i = half.size() - 2; i > 0; --i)
    outline.push_back({1000 - half[i].x, half[i].y});
  Contour const contour = evenly_sampled(rounded(outline), contour_points);
  double const edge_px = distance(contour[0], contour[1]);
  auto const meshed = mesh_region({{contour}, {}}, {2 * edge_px, 0.35});
  CHECK(meshed.has_value(), "a figure that can be meshed");
  BendMesh mesh;
  mesh.rest = meshed->mesh;
  mesh.stiffness.assign(mesh.rest.triangles.size(), 1);
  mesh.lines.push_back({meshed->contours[0], true});
  mesh.edge_px = edge_px;
  return mesh;
}

int nearest_vertex(FlatMesh const& mesh, Vec2 place) {
  auto const nearest =
      std::min_element(mesh.points.begin(), mesh.points.end(),
                       [&](Vec2 a, Vec2 b) { return distance(a, place) < distance(b, place); });
  return static_cast<int>(nearest - mesh.points.begin());
}

BendAnchor anchor_of(FlatMesh const& mesh, int vertex) {
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      if (mesh.triangles[t][corner] != vertex) continue;
      BendAnchor anchor{t, {0, 0, 0}};
      anchor.weights[corner] = 1;
      return anchor;
    }
  }
  CHECK(false, "a vertex of a triangle");
  return {};
}

BendAnchor anchor_near(BendMesh const& mesh, Vec2 place) {
  return anchor_of(mesh.rest, nearest_vertex(mesh.rest, place));
}

double largest_distance(BendPose const& a, BendPose const& b) {
  CHECK(a.size() == b.size(), "poses of one mesh");
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = larger(largest, distance(a[v], b[v]));
  return largest;
}

BendMesh side_by_side(BendMesh const& a, BendMesh const& b) {
  auto mesh = a;
  int const first = static_cast<int>(a.rest.points.size());
  mesh.rest.points.insert(mesh.rest.points.end(), b.rest.points.begin(), b.rest.points.end());
  for (auto corners : b.rest.triangles) {
    for (auto& v : corners) v += first;
    mesh.rest.triangles.push_back(corners);
  }
  mesh.stiffness.insert(mesh.stiffness.end(), b.stiffness.begin(), b.stiffness.end());
  return mesh;
}

}  // namespace inkflate::support
