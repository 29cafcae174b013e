// SPDX-License-Identifier: Apache-2.0
#include "inflate/layer_depths.h"

#include <algorithm>

#include "base/check.h"
#include "inflate/depth_rules.h"
#include "inflate/depth_solve.h"
#include "inflate/point_areas.h"

namespace inkflate {
namespace {

/// What a squared px of a broken rule costs, per model size squared: about a million times what bending costs, so that rules hold to
/// a hundredth of a px where they can. Where joints and order want what cannot be, the joints win.
constexpr double kOrderWeight = 1e7;
constexpr double kJointWeight = 1e8;

/// Stiffness grows with the square of a layer's size: where two push each other, the small one gives way.
PlateStiffness stiffness_of(double layer_size, double model_size, bool is_limb) {
  double const area = model_size * model_size;
  double const share = layer_size * layer_size / area;
  // A limb is held by its joint and only has to be kept from leaning: legs stay side by side.
  if (is_limb) return {10 * share, 2000 * share / area, 1.6 * share / (area * area)};
  // What no joint holds is drawn back to the middle. If large it stays upright; if small, as an eye is, it tilts to lie on what is
  // behind it.
  double const pull = 1600 * share / (area * area);
  return {100 * share, 10 * pull * area * share * share, pull};
}

double model_size(FlatModel const& model) {
  Rect box;
  for (auto const& layer : model.layers) {
    for (auto const p : layer.mesh.points) box.include(p);
  }
  return std::max(box.longer_side(), 1.0);
}

bool is_limb(FlatModel const& model, int layer) {
  return std::any_of(model.joints.begin(), model.joints.end(),
                     [&](Joint const& joint) { return joint.limb == layer; });
}

std::vector<LayerShape> shapes_of(FlatModel const& model,
                                  std::span<std::vector<double> const> heights) {
  std::vector<LayerShape> shapes;
  int next = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    auto const& layer = model.layers[i];
    shapes.push_back(
        {layer.mesh, layer.kinds, heights[i], TriangleGrid(layer.mesh), Plate(layer.mesh, next)});
    next += shapes.back().plate.unknown_count();
  }
  return shapes;
}

std::vector<MatrixEntry> energy_of(FlatModel const& model, std::span<LayerShape const> shapes,
                                   double size) {
  std::vector<MatrixEntry> energy;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    auto const& shape = shapes[i];
    auto const stiffness =
        stiffness_of(shape.grid.box().longer_side(), size, is_limb(model, static_cast<int>(i)));
    shape.plate.add_energy(shape.mesh, point_areas(shape.mesh), stiffness, energy);
  }
  return energy;
}

}  // namespace

std::vector<std::vector<double>> layer_depths(FlatModel const& model,
                                              std::span<std::vector<double> const> heights) {
  CHECK(heights.size() == model.layers.size(), "heights for each layer");
  auto const shapes = shapes_of(model, heights);
  double const size = model_size(model);
  std::vector<DepthRule> rules;
  add_joint_rules(model, shapes, kJointWeight / (size * size), rules);
  add_order_rules(model, shapes, kOrderWeight / (size * size), rules);
  std::vector<std::vector<double>> depths;
  for (auto const& h : heights) depths.emplace_back(h.size(), 0.0);
  if (rules.empty()) return depths;
  add_slope_rules(shapes, kJointWeight / (size * size), rules);
  int unknown_count = 0;
  for (auto const& shape : shapes) unknown_count += shape.plate.unknown_count();
  auto const unknowns = solve_depths(unknown_count, energy_of(model, shapes, size), rules);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t v = 0; v < depths[i].size(); ++v) {
      depths[i][v] = shapes[i].plate.depth(shapes[i].mesh.points[v])(unknowns);
    }
  }
  return depths;
}

}  // namespace inkflate
