// SPDX-License-Identifier: Apache-2.0
#include "inflate/layer_depths.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "geometry/polyline.h"
#include "inflate/depth_rules.h"
#include "inflate/depth_solve.h"

namespace inkflate {
namespace {

/// Violations of rules count this much, per model size squared.
constexpr double kRuleWeight = 1e7;
constexpr double kJointWeight = 1e8;

/// A limb: legs stay side by side instead of leaning to the middle.
PlateStiffness stiffness_of_limb(double model_size) {
  double const area = model_size * model_size;
  return {1, 16 / area, 0.16 / (area * area)};
}

/// A layer that no joint holds. Large ones stay where they are and upright; small ones, as eyes are, give way and tilt to follow what
/// they lie on.
PlateStiffness stiffness_of_body(double layer_size, double model_size) {
  double const area = model_size * model_size;
  double const share = layer_size * layer_size / area;
  double const pull = 1600 / (area * area);
  return {100 * share, 10 * pull * area * share * share * share, pull * share};
}

double model_size(FlatModel const& model) {
  Rect box;
  for (auto const& layer : model.layers) {
    for (auto const p : layer.mesh.points) box.include(p);
  }
  return std::max(box.longer_side(), 1.0);
}

std::vector<double> masses_of(FlatMesh const& mesh) {
  std::vector<double> masses(mesh.points.size(), 0);
  for (auto const& t : mesh.triangles) {
    Vec2 const a = mesh.points[t[0]];
    double const area = cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a) / 2;
    for (int const v : t) masses[v] += area / 3;
  }
  return masses;
}

bool is_limb(FlatModel const& model, int layer) {
  return std::any_of(model.joints.begin(), model.joints.end(),
                     [&](Joint const& joint) { return joint.limb == layer; });
}

}  // namespace

std::vector<std::vector<double>> layer_depths(FlatModel const& model,
                                              std::span<std::vector<double> const> heights) {
  CHECK(heights.size() == model.layers.size(), "heights for each layer");
  std::vector<std::vector<double>> depths;
  for (auto const& h : heights) depths.emplace_back(h.size(), 0.0);
  std::vector<LayerShape> shapes;
  int unknown_count = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    auto const& layer = model.layers[i];
    shapes.push_back({layer.mesh, layer.kinds, heights[i], TriangleGrid(layer.mesh),
                      Plate(layer.mesh, unknown_count)});
    unknown_count += shapes.back().plate.unknown_count();
  }
  double const size = model_size(model);
  double const area = size * size;
  std::vector<DepthRule> rules;
  add_joint_rules(model, shapes, kJointWeight / area, rules);
  add_order_rules(model, shapes, kRuleWeight / area, rules);
  if (rules.empty()) return depths;
  add_slope_rules(shapes, kJointWeight / area, rules);
  std::vector<MatrixEntry> energy;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    auto const stiffness = is_limb(model, static_cast<int>(i))
                               ? stiffness_of_limb(size)
                               : stiffness_of_body(shapes[i].grid.box().longer_side(), size);
    shapes[i].plate.add_energy(shapes[i].mesh, masses_of(shapes[i].mesh), stiffness, energy);
  }
  auto const unknowns = solve_depths(unknown_count, std::move(energy), rules);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t v = 0; v < depths[i].size(); ++v) {
      depths[i][v] = shapes[i].plate.depth(shapes[i].mesh.points[v])(unknowns);
    }
  }
  return depths;
}

}  // namespace inkflate
