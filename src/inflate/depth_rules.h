// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "inflate/plate.h"
#include "mesh/triangle_grid.h"
#include "model/flat_model.h"

namespace inkflate {

/// One thing that the depths of two plates have to fulfil: near - far == gap, or >= gap.
struct DepthRule {
  PlateRow near;
  PlateRow far;
  double gap = 0;     // px
  double weight = 1;  // of its squared violation
  bool is_equality = false;
  int group = 0;  // the pair of layers of an inequality
};

/// A layer and what is known of it.
struct LayerShape {
  FlatMesh const& mesh;
  std::vector<VertexKind> const& kinds;
  std::vector<double> const& heights;
  TriangleGrid grid;
  Plate plate;
};

/// Rules for every place at which two layers overlap. Of layers i behind j, at a point p of both:
///
///     depth_j(p) - depth_i(p) >= |height_i(p) - height_j(p)| + margin
///
/// On a rim of j its height is 0, so that the rim lies before the front sheet of i; on a rim of i that rim lies behind the back sheet of j.
/// Between, it says that whoever looks from the front sees j, and whoever looks from behind sees i.
void add_order_rules(FlatModel const& model, std::span<LayerShape const> shapes, double weight,
                     std::vector<DepthRule>& rules);

/// Rules that hold the limb of each joint where it belongs: on its host's sheet, or at the mouth of its host.
void add_joint_rules(FlatModel const& model, std::span<LayerShape const> shapes, double weight,
                     std::vector<DepthRule>& rules);

/// Rules that keep every layer from rising more steeply than a limb can bend, whatever the other rules want.
void add_slope_rules(std::span<LayerShape const> shapes, double weight,
                     std::vector<DepthRule>& rules);

}  // namespace inkflate
