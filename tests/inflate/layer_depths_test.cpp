// SPDX-License-Identifier: Apache-2.0
#include "inflate/layer_depths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "inflate/layer_heights.h"
#include "support/depth_order.h"
#include "support/flat_characters.h"

namespace inkflate {
namespace {

using support::Part;

std::vector<std::vector<double>> all_heights(FlatModel const& model) {
  std::vector<std::vector<double>> heights;
  for (auto const& layer : model.layers) heights.push_back(layer_heights(layer));
  return heights;
}

support::DepthOrder order_of(std::vector<Part> const& parts) {
  auto const model = support::flat_model_of(parts);
  auto const heights = all_heights(model);
  auto const depths = layer_depths(model, heights);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    auto const [low, high] = std::minmax_element(depths[i].begin(), depths[i].end());
    std::cout << i << " " << model.layers[i].name << " points " << depths[i].size() << " depth "
              << *low << " .. " << *high << " height "
              << *std::max_element(heights[i].begin(), heights[i].end()) << "\n";
  }
  auto const order = support::measure_depth_order(support::sheets_of(model, heights, depths));
  std::cout << "samples " << order.samples << " wrong " << order.wrong << " worst "
            << order.worst_px << " at " << order.worst_at.x << " " << order.worst_at.y << " rim of "
            << order.worst_layers[0] << " in " << order.worst_layers[1] << "\n";
  return order;
}

TEST(LayerDepths, FiveLayersLieOneBeforeTheOther) {
  auto const order = order_of(support::five_parts());
  EXPECT_GT(order.samples, 200);
  EXPECT_LE(order.wrong_share(), 0.02);
  EXPECT_LE(order.worst_px, 2);
}

TEST(LayerDepths, TwentyOneLayersLieOneBeforeTheOther) {
  auto const order = order_of(support::twenty_one_parts());
  EXPECT_GT(order.samples, 1000);
  EXPECT_LE(order.wrong_share(), 0.02);
  EXPECT_LE(order.worst_px, 2);
}

}  // namespace
}  // namespace inkflate
