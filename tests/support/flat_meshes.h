// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/trig.h"
#include "model/flat_model.h"

namespace inkflate::support {

/// Triangles between two closed rings of points, given by index and starting at the same angle.
inline void sew_rings(FlatMesh& mesh, std::vector<int> const& inner,
                      std::vector<int> const& outer) {
  std::size_t i = 0;
  std::size_t o = 0;
  while (i < inner.size() || o < outer.size()) {
    auto const share = [](std::size_t k, std::size_t n) {
      return static_cast<double>(k + 1) / static_cast<double>(n);
    };
    int const a = inner[i % inner.size()];
    int const b = outer[o % outer.size()];
    if (o < outer.size() &&
        (i >= inner.size() || share(o, outer.size()) <= share(i, inner.size()))) {
      mesh.triangles.push_back({a, b, outer[++o % outer.size()]});
    } else {
      mesh.triangles.push_back({a, b, inner[++i % inner.size()]});
    }
  }
}

inline std::vector<int> add_ring(FlatMesh& mesh, Vec2 centre, Vec2 radii, int count) {
  std::vector<int> ring;
  for (int i = 0; i < count; ++i) {
    auto const angle = sin_cos(2 * kPi * i / count);
    ring.push_back(static_cast<int>(mesh.points.size()));
    mesh.points.push_back(centre + Vec2{radii.x * angle.cos, radii.y * angle.sin});
  }
  return ring;
}

/// An ellipse of `rings` rings around its centre, 6 points more on each; the rim is drawn.
inline FlatLayer ellipse_layer(Vec2 centre, Vec2 radii, int rings) {
  FlatLayer layer;
  layer.mesh.points.push_back(centre);
  std::vector<int> inner = {0};
  for (int k = 1; k <= rings; ++k) {
    auto const outer =
        add_ring(layer.mesh, centre, radii * (static_cast<double>(k) / rings), 6 * k);
    if (k == 1) {
      for (int i = 0; i < 6; ++i) layer.mesh.triangles.push_back({0, outer[i], outer[(i + 1) % 6]});
    } else {
      sew_rings(layer.mesh, inner, outer);
    }
    inner = outer;
  }
  layer.kinds.assign(layer.mesh.points.size(), VertexKind::Inside);
  for (int const v : inner) layer.kinds[v] = VertexKind::Drawn;
  return layer;
}

inline FlatLayer disc_layer(Vec2 centre, double radius, int rings) {
  return ellipse_layer(centre, {radius, radius}, rings);
}

/// A ring between two circles; both rims are drawn.
inline FlatLayer annulus_layer(Vec2 centre, double inner, double outer, int rows, int columns) {
  FlatLayer layer;
  std::vector<int> last;
  for (int k = 0; k <= rows; ++k) {
    double const radius = inner + (outer - inner) * k / rows;
    auto const ring = add_ring(layer.mesh, centre, {radius, radius}, columns);
    if (k > 0) sew_rings(layer.mesh, last, ring);
    last = ring;
  }
  layer.kinds.assign(layer.mesh.points.size(), VertexKind::Inside);
  for (int i = 0; i < columns; ++i) {
    layer.kinds[i] = layer.kinds[layer.kinds.size() - 1 - i] = VertexKind::Drawn;
  }
  return layer;
}

/// Which ends of a strip are open.
enum class Ends { None, First, Both };

/// A straight strip from a to b: columns along it, rows across. Its long sides are drawn, as are ends that are not open.
inline FlatLayer strip_layer(Vec2 a, Vec2 b, double width, int columns, int rows, Ends open) {
  FlatLayer layer;
  Vec2 const side = perpendicular(normalized(b - a)) * width;
  for (int i = 0; i <= columns; ++i) {
    bool const is_open = (i == 0 && open != Ends::None) || (i == columns && open == Ends::Both);
    bool const is_end = i == 0 || i == columns;
    for (int j = 0; j <= rows; ++j) {
      double const across = static_cast<double>(j) / rows - 0.5;
      layer.mesh.points.push_back(lerp(a, b, static_cast<double>(i) / columns) + side * across);
      bool const is_side = j == 0 || j == rows;
      layer.kinds.push_back(is_side             ? VertexKind::Drawn
                            : is_end && is_open ? VertexKind::Open
                            : is_end            ? VertexKind::Drawn
                                                : VertexKind::Inside);
    }
  }
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      int const p = i * (rows + 1) + j;
      int const q = p + rows + 1;
      layer.mesh.triangles.push_back({p, q, q + 1});
      layer.mesh.triangles.push_back({p, q + 1, p + 1});
    }
  }
  return layer;
}

}  // namespace inkflate::support
