// SPDX-License-Identifier: Apache-2.0
#include "inflate/layer_depths.h"

#include <algorithm>

#include "base/check.h"
#include "geometry/polyline.h"
#include "inflate/depth_rules.h"
#include "inflate/depth_solve.h"

namespace inkflate {
namespace {

/// All stiffnesses are in shares of the model's longer side, so that a drawing twice as large becomes a model twice as large.
struct Stiffness {
  double pull = 16;         // of a layer that no joint holds
  double held_pull = 0.16;  // of a limb: enough to place it should its host be held by nothing
  double held_slope = 16;   // of a limb: legs stay side by side instead of leaning to the middle
  double rule = 1e6;
};

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
  Stiffness const stiffness;
  std::vector<DepthRule> rules;
  add_joint_rules(model, shapes, stiffness.rule / area, rules);
  add_order_rules(model, shapes, stiffness.rule / area, rules);
  if (rules.empty()) return depths;
  std::vector<MatrixEntry> energy;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    bool const is_held = is_limb(model, static_cast<int>(i));
    double const pull = is_held ? stiffness.held_pull : stiffness.pull;
    double const slope = is_held ? stiffness.held_slope : 0;
    auto const masses = masses_of(shapes[i].mesh);
    shapes[i].plate.add_energy(shapes[i].mesh, masses, {slope / area, pull / (area * area)},
                               energy);
  }
  auto const unknowns = solve_depths(unknown_count, energy, rules);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t v = 0; v < depths[i].size(); ++v) {
      depths[i][v] = shapes[i].plate.depth(shapes[i].mesh.points[v])(unknowns);
    }
  }
  return depths;
}

}  // namespace inkflate
