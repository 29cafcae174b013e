// SPDX-License-Identifier: Apache-2.0
#include "solidify/print_space.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace inkflate {
namespace {

// A body-centred lattice of period 1.26 has as many nodes as a cubic one of period 1.
constexpr double kPeriodCells = 1.26;
// The share of the height that is cut off for a flat base.
constexpr double kBaseShare = 0.03;
// Thinner than a period and a half, a wall can fall between the nodes. Lattice units.
constexpr double kLeastThickness = 2;
constexpr double kMarginUnits = 5;
// With five bytes for each node: 500 MB.
constexpr double kMostNodes = 1e8;

Error option_error(char const* message) { return {ErrorCode::BadOption, message}; }

std::optional<Error> check_options(SolidifyOptions const& options) {
  if (!(options.longest_mm >= 5 && options.longest_mm <= 1000))
    return option_error("The printed size has to be 5 to 1000 mm.");
  if (!(options.least_mm >= 0 && options.least_mm <= 20))
    return option_error("The least thickness has to be 0 to 20 mm.");
  if (options.least_mm > options.longest_mm / 2)
    return option_error("The least thickness is more than half of the printed size.");
  if (options.cells < 16 || options.cells > 512)
    return option_error("The number of cells has to be 16 to 512.");
  return std::nullopt;
}

std::optional<Error> check_indices(TriMesh const& model) {
  if (model.triangles.empty())
    return Error{ErrorCode::NothingThere, "The model is empty: there is nothing to print."};
  for (int t = 0; t < std::ssize(model.triangles); ++t) {
    for (int const p : model.triangles[t]) {
      if (p < 0 || p >= std::ssize(model.points))
        return Error{ErrorCode::BadInput, "A triangle names a point that is not there.", t};
      if (!is_finite(model.points[p]))
        return Error{ErrorCode::BadInput, "A point of the model is not finite.", p};
    }
  }
  return std::nullopt;
}

/// Closed: every edge is run through equally often both ways.
std::optional<Error> check_closed(TriMesh const& model) {
  std::vector<std::pair<std::int64_t, int>> edges;
  edges.reserve(3 * model.triangles.size());
  auto const count = std::ssize(model.points);
  for (auto const& triangle : model.triangles) {
    for (int c = 0; c < 3; ++c) {
      int const a = triangle[c];
      int const b = triangle[(c + 1) % 3];
      if (a != b) edges.emplace_back(std::min(a, b) * count + std::max(a, b), a < b ? 1 : -1);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::int64_t sum = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    sum += edges[e].second;
    if (e + 1 < edges.size() && edges[e + 1].first == edges[e].first) continue;
    if (sum != 0)
      return Error{ErrorCode::BadInput, "The model has a hole in its surface, so it has no inside.",
                   edges[e].first / count};
  }
  return std::nullopt;
}

struct Box {
  Vec3 min;
  Vec3 max;
};

/// The model's y points up in print, its front to -y.
Vec3 turned(Vec3 p) { return {p.x, -p.z, p.y}; }

/// Of the points that triangles use.
Box turned_box(TriMesh const& model) {
  Vec3 const first = turned(model.points[model.triangles.front()[0]]);
  Box box{first, first};
  for (auto const& triangle : model.triangles) {
    for (int const corner : triangle) {
      Vec3 const p = turned(model.points[corner]);
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
    }
  }
  return box;
}

std::int64_t to_quanta(double units) {
  constexpr double half = static_cast<double>(kQuanta) / 2;
  return 2 * static_cast<std::int64_t>(std::floor(units * half)) + 1;
}

/// The model's box at the corner, scaled and rounded.
LatticeMesh lay_out(TriMesh const& model, Box const& box, double scale, Vec3 corner) {
  LatticeMesh mesh;
  mesh.triangles = model.triangles;
  mesh.points.resize(model.points.size());
  for (auto const& triangle : model.triangles) {
    for (int const p : triangle) {
      Vec3 const place = corner + (turned(model.points[p]) - box.min) * scale;
      mesh.points[p] = {to_quanta(place.x), to_quanta(place.y), to_quanta(place.z)};
    }
  }
  return mesh;
}

/// Nodes along a side whose places are two units apart.
int nodes_along(double units) { return static_cast<int>(std::ceil(units / 2)); }

}  // namespace

Result<PrintSpace> make_print_space(TriMesh const& model, SolidifyOptions const& options) {
  if (auto error = check_options(options)) return *error;
  if (auto error = check_indices(model)) return *error;
  if (auto error = check_closed(model)) return *error;
  Box const box = turned_box(model);
  Vec3 const size = box.max - box.min;
  double const longest = std::max({size.x, size.y, size.z});
  if (!(longest > 0))
    return Error{ErrorCode::NothingThere, "The model has no size: there is nothing to print."};
  if (!std::isfinite(longest)) return Error{ErrorCode::BadInput, "The model is too large."};
  double const units = 2 * options.cells / kPeriodCells;
  double const scale = units / longest;
  if (!std::isfinite(scale))
    return Error{ErrorCode::NothingThere, "The model has no size: there is nothing to print."};

  PrintSpace space;
  space.unit_mm = options.longest_mm / units;
  space.least = std::max(options.least_mm / space.unit_mm, kLeastThickness);
  double const margin = std::ceil(space.least / 2) + kMarginUnits;
  space.lattice.columns = nodes_along(size.x * scale + 2 * margin);
  space.lattice.rows = nodes_along(size.y * scale + 2 * margin);
  space.lattice.planes = 2 * nodes_along(size.z * scale + 2 * margin);
  if (static_cast<double>(space.lattice.columns) * space.lattice.rows * space.lattice.planes >
      kMostNodes)
    return Error{ErrorCode::TooLarge, "The model would need too much memory; use fewer cells."};

  // A base lies halfway between two planes of nodes.
  double const lift = options.has_flat_base ? kBaseShare * size.z * scale : 0;
  double const base = std::floor(margin + lift) + 0.5;
  space.zero = {margin + size.x * scale / 2, margin + size.y * scale / 2, base};
  space.mesh = lay_out(model, box, scale, {margin, margin, base - lift});
  return space;
}

}  // namespace inkflate
