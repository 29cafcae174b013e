// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "inflate/layer_depths.h"
#include "inflate/layer_heights.h"
#include "support/depth_order.h"
#include "support/flat_meshes.h"

namespace inkflate {
namespace {

/// Two to seven ellipses and strips near each other.
FlatModel arbitrary_pile() {
  FlatModel model;
  int const count = *rc::gen::inRange(2, 8);
  for (int i = 0; i < count; ++i) {
    Vec2 const place = {1.0 * *rc::gen::inRange(0, 300), 1.0 * *rc::gen::inRange(0, 300)};
    Vec2 const size = {1.0 * *rc::gen::inRange(10, 150), 1.0 * *rc::gen::inRange(10, 150)};
    int const rings = static_cast<int>(std::clamp(std::max(size.x, size.y) / 8, 3.0, 16.0));
    auto layer = *rc::gen::inRange(0, 3) > 0
                     ? support::ellipse_layer(place, size, rings)
                     : support::strip_layer(place, place + size, 30, 20, 5, support::Ends::None);
    layer.thickness = *rc::gen::inRange(1, 40) / 8.0;
    model.layers.push_back(std::move(layer));
  }
  return model;
}

struct Depths {
  std::vector<std::vector<double>> heights;
  std::vector<std::vector<double>> depths;
};

Depths depths_of(FlatModel const& model) {
  Depths result;
  for (auto const& layer : model.layers) result.heights.push_back(layer_heights(layer));
  result.depths = layer_depths(model, result.heights);
  return result;
}

RC_GTEST_PROP(LayerDepths, EveryRimLiesOnItsSide, ()) {
  auto const model = arbitrary_pile();
  auto const found = depths_of(model);
  auto const order =
      support::measure_depth_order(support::sheets_of(model, found.heights, found.depths));
  RC_ASSERT(order.wrong_share() <= 0.02);
  RC_ASSERT(order.worst_px <= 2);
}

// A limb whose joint is wherever it happens to be: order and joint may contradict each other.
RC_GTEST_PROP(LayerDepths, AnyJointLeavesAllNear, ()) {
  auto model = arbitrary_pile();
  int const host = *rc::gen::inRange(0, static_cast<int>(model.layers.size()));
  auto const& points = model.layers[host].mesh.points;
  // The host's first points become a run, to which a strip is joined that starts there.
  Vec2 const from = points[0];
  Vec2 const to = from + Vec2{1.0 * *rc::gen::inRange(-200, 200), 1.0 * *rc::gen::inRange(40, 200)};
  auto limb = support::strip_layer(from, to, 16, 20, 2, support::Ends::First);
  Joint joint = {0, host, Joint::Kind::Slit, Side::Front, {0, 1, 2}, {0, 0, 0}};
  if (*rc::gen::inRange(0, 2) == 0) joint.side = Side::Back;
  joint.limb = *rc::gen::inRange(0, static_cast<int>(model.layers.size()) + 1);
  if (joint.limb <= joint.host) ++joint.host;
  model.layers.insert(model.layers.begin() + joint.limb, std::move(limb));
  model.joints = {joint};
  for (auto const& depths : depths_of(model).depths) {
    RC_ASSERT(
        std::all_of(depths.begin(), depths.end(), [](double z) { return std::abs(z) < 800; }));
  }
}

}  // namespace
}  // namespace inkflate
