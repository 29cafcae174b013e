// SPDX-License-Identifier: Apache-2.0
#include "inflate/layer_heights.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "inflate/point_areas.h"
#include "solvers/sparse_cholesky.h"

namespace inkflate {
namespace {

/// The least u of a vertex that is not drawn, as a share of its c * area: far below what the equation gives, but never 0, since
/// the two sheets may not touch there.
constexpr double kLeastShare = 0.01;

/// A sliver's cotangents are cut at this: beyond it they only spoil the numbers.
constexpr double kLargestCotangent = 1e4;

/// Of the angle at a triangle's corner.
double cotangent(Vec2 corner, Vec2 b, Vec2 c) {
  double const sine = cross(b - corner, c - corner);
  double const cosine = dot(b - corner, c - corner);
  if (std::abs(cosine) >= kLargestCotangent * sine) return std::copysign(kLargestCotangent, cosine);
  return cosine / sine;
}

/// Vertices that are not drawn get numbers, in order; the others -1, as do points that no triangle uses.
std::vector<int> number_free(std::vector<VertexKind> const& kinds,
                             std::vector<double> const& areas) {
  std::vector<int> numbers(kinds.size(), -1);
  int next = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] != VertexKind::Drawn && areas[i] > 0) numbers[i] = next++;
  }
  return numbers;
}

/// The cotangent Laplacian of the free vertices; drawn ones have u = 0 and drop out.
std::vector<MatrixEntry> laplacian(FlatMesh const& mesh, std::vector<int> const& numbers) {
  std::vector<MatrixEntry> entries;
  entries.reserve(mesh.triangles.size() * 9);
  auto const add_edge = [&](int a, int b, double weight) {
    if (a >= 0) entries.push_back({a, a, weight});
    if (b >= 0) entries.push_back({b, b, weight});
    if (a >= 0 && b >= 0) entries.push_back({std::max(a, b), std::min(a, b), -weight});
  };
  for (auto const& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      int const a = t[(k + 1) % 3];
      int const b = t[(k + 2) % 3];
      double const weight = cotangent(mesh.points[t[k]], mesh.points[a], mesh.points[b]) / 2;
      add_edge(numbers[a], numbers[b], weight);
    }
  }
  return entries;
}

}  // namespace

std::vector<double> layer_heights(FlatLayer const& layer) {
  CHECK(layer.kinds.size() == layer.mesh.points.size(), "a kind for each point");
  auto const areas = point_areas(layer.mesh);
  auto const numbers = number_free(layer.kinds, areas);
  std::vector<double> least;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] >= 0) least.push_back(layer.thickness * areas[i]);
  }
  auto u = least;
  auto const solver =
      SparseCholesky::factor(static_cast<int>(u.size()), laplacian(layer.mesh, numbers));
  // Without a solution (a piece without drawn rim) the least heights remain: closed and finite, if flat.
  if (solver) solver->solve(u);
  std::vector<double> heights(numbers.size(), 0);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    int const k = numbers[i];
    if (k >= 0) heights[i] = std::sqrt(std::max(u[k], kLeastShare * least[k]));
  }
  return heights;
}

}  // namespace inkflate
