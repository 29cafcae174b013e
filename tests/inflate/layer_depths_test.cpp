// SPDX-License-Identifier: Apache-2.0
#include "inflate/layer_depths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "inflate/layer_heights.h"
#include "support/depth_order.h"
#include "support/flat_characters.h"
#include "support/flat_meshes.h"

namespace inkflate {
namespace {

using support::Ends;
using support::Part;

/// A model with its heights and depths.
struct Raised {
  FlatModel model;
  std::vector<std::vector<double>> heights;
  std::vector<std::vector<double>> depths;

  support::DepthOrder order() const {
    return support::measure_depth_order(support::sheets_of(model, heights, depths));
  }
  double least(int layer) const {
    return *std::min_element(depths[layer].begin(), depths[layer].end());
  }
  double most(int layer) const {
    return *std::max_element(depths[layer].begin(), depths[layer].end());
  }
};

Raised raise(FlatModel model) {
  Raised raised = {std::move(model), {}, {}};
  for (auto const& layer : raised.model.layers) raised.heights.push_back(layer_heights(layer));
  raised.depths = layer_depths(raised.model, raised.heights);
  return raised;
}

Raised raise(std::vector<FlatLayer> layers) {
  FlatModel model;
  model.layers = std::move(layers);
  return raise(std::move(model));
}

Raised raise(std::vector<Part> const& parts) { return raise(support::flat_model_of(parts)); }

void expect_order(Raised const& raised, int least_samples) {
  auto const order = raised.order();
  EXPECT_GT(order.samples, least_samples);
  EXPECT_EQ(order.wrong, 0);
  EXPECT_LT(order.worst_px, 0.2);
}

TEST(LayerDepths, ALoneLayerStaysInTheMiddle) {
  auto const raised = raise({support::disc_layer({100, 100}, 50, 8)});
  EXPECT_EQ(raised.depths[0], std::vector<double>(raised.depths[0].size(), 0));
}

TEST(LayerDepths, LayersSideBySideStayInTheMiddle) {
  auto const raised =
      raise({support::disc_layer({100, 100}, 50, 8), support::disc_layer({250, 100}, 50, 8)});
  for (int i : {0, 1}) {
    EXPECT_NEAR(raised.least(i), 0, 1e-9);
    EXPECT_NEAR(raised.most(i), 0, 1e-9);
  }
}

TEST(LayerDepths, OfTwoAlikeEachGivesWayByHalf) {
  auto const raised =
      raise({support::disc_layer({100, 100}, 60, 8), support::disc_layer({160, 100}, 60, 8)});
  expect_order(raised, 50);
  EXPECT_NEAR(raised.least(0), -raised.most(1), 0.1);
  EXPECT_NEAR(raised.most(0), -raised.least(1), 0.1);
}

TEST(LayerDepths, AnEyeLiesOnTheHeadAndTheHeadHardlyMoves) {
  auto const raised =
      raise({support::disc_layer({200, 200}, 150, 20), support::disc_layer({260, 150}, 18, 4)});
  expect_order(raised, 30);
  EXPECT_LT(std::max(-raised.least(0), raised.most(0)), 0.5);
  auto const sheets = support::sheets_of(raised.model, raised.heights, raised.depths);
  // No point of its rim floats far above: the head's slope there is nearly 1, its rise across the eye 24 px.
  for (auto const& [a, b] : sheets[1].rim) {
    double const r = distance(Vec2{a.x, a.y}, Vec2{200, 200});
    double const head = std::sqrt((150.0 * 150 - r * r) / 2);
    EXPECT_NEAR(a.z, head, 3.5) << a.x << " " << a.y;
  }
}

TEST(LayerDepths, OfDiscsThatLieOnOneAnotherEachIsBeforeTheOneBelow) {
  std::vector<FlatLayer> discs(4, support::disc_layer({100, 100}, 50, 8));
  auto const raised = raise(discs);
  for (int i = 1; i < 4; ++i) EXPECT_GT(raised.least(i), raised.most(i - 1));
}

TEST(LayerDepths, AThinPlateBeforeABallIsNotPierced) {
  auto plate = support::disc_layer({200, 200}, 150, 20);
  plate.thickness = 0.1;
  auto const raised = raise({support::disc_layer({200, 200}, 100, 14), plate});
  // In the middle, where both are seen: the plate's front before the ball's, the ball's back behind the plate's.
  EXPECT_GT(raised.depths[1][0] + raised.heights[1][0], raised.depths[0][0] + raised.heights[0][0]);
  EXPECT_LT(raised.depths[0][0] - raised.heights[0][0], raised.depths[1][0] - raised.heights[1][0]);
}

TEST(LayerDepths, ALimbStandsOnTheSheetOfItsHost) {
  auto const raised = raise(support::three_parts());
  expect_order(raised, 100);
  for (auto const& joint : raised.model.joints) {
    for (std::size_t i = 0; i < joint.limb_vertices.size(); ++i) {
      int const v = joint.host_vertices[i];
      double const sheet = raised.depths[joint.host][v] + raised.heights[joint.host][v];
      bool const is_end = i == 0 || i + 1 == joint.limb_vertices.size();
      EXPECT_NEAR(raised.depths[joint.limb][joint.limb_vertices[i]], sheet, is_end ? 0.1 : 2);
    }
  }
}

TEST(LayerDepths, ACopyBehindTheBodyMirrorsTheLimbBeforeIt) {
  auto parts = support::three_parts();
  auto copy = parts[2];
  for (auto& part : parts) part.host = part.host < 0 ? -1 : part.host + 1;
  copy.host = 1;
  parts.insert(parts.begin(), copy);
  parts.erase(parts.begin() + 2);  // the arm
  auto const raised = raise(parts);
  for (std::size_t v = 0; v < raised.depths[0].size(); ++v) {
    EXPECT_NEAR(raised.depths[0][v], -raised.depths[2][v], 0.1);
  }
  EXPECT_GT(raised.least(2), raised.most(0) + 60) << "the legs stand side by side";
}

TEST(LayerDepths, MouthsThatMeetGoOnInOneDepth) {
  FlatModel model;
  // Two halves of a beam, and a block behind which the second one has to go.
  model.layers = {support::strip_layer({300, 200}, {100, 200}, 40, 20, 6, Ends::First),
                  support::strip_layer({300, 200}, {500, 200}, 40, 20, 6, Ends::First),
                  support::disc_layer({450, 200}, 60, 8)};
  Joint joint = {0, 1, Joint::Kind::Mouth, Side::Front, {}, {}};
  for (int j = 0; j <= 6; ++j) {
    joint.limb_vertices.push_back(j);
    joint.host_vertices.push_back(6 - j);
  }
  model.joints = {joint};
  auto const raised = raise(model);
  EXPECT_LT(raised.least(1), -5);
  for (int j = 0; j <= 6; ++j) {
    EXPECT_EQ(raised.model.layers[0].mesh.points[j], raised.model.layers[1].mesh.points[6 - j]);
    double const here = raised.depths[0][j];
    EXPECT_NEAR(here, raised.depths[1][6 - j], 0.05);
    // The slope goes on too: the next points on both sides lie on a line.
    EXPECT_NEAR(raised.depths[0][j + 7] + raised.depths[1][13 - j], 2 * here, 0.2);
  }
}

TEST(LayerDepths, FiveLayersLieOneBeforeTheOther) {
  expect_order(raise(support::five_parts()), 400);
}

TEST(LayerDepths, TwentyOneLayersLieOneBeforeTheOther) {
  expect_order(raise(support::twenty_one_parts()), 3000);
}

TEST(LayerDepths, AMirroredDrawingGetsMirroredDepths) {
  auto parts = support::twenty_one_parts();
  auto const raised = raise(parts);
  for (auto& part : parts) {
    for (auto& p : part.rim) p.x = 1000 - p.x;
    std::reverse(part.rim.begin(), part.rim.end());
  }
  auto const mirrored = raise(parts);
  // The meshes differ, so means are compared.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    double sum = 0;
    double mirrored_sum = 0;
    for (double const z : raised.depths[i]) sum += z / static_cast<double>(raised.depths[i].size());
    for (double const z : mirrored.depths[i]) {
      mirrored_sum += z / static_cast<double>(mirrored.depths[i].size());
    }
    EXPECT_NEAR(sum, mirrored_sum, 3) << raised.model.layers[i].name;
  }
}

TEST(LayerDepths, JointsAgainstTheOrderEndInACompromiseThatStaysNear) {
  auto parts = support::three_parts();
  auto model = support::flat_model_of(parts);
  // The arm is joined to the body's back, but a block that is behind the body lies all over the joint.
  std::swap(model.layers[1], model.layers[2]);
  for (auto& joint : model.joints) {
    joint.limb = 3 - joint.limb;
    joint.side = Side::Back;
  }
  model.layers.push_back(support::disc_layer({590, 460}, 90, 12));
  std::rotate(model.layers.begin(), model.layers.end() - 1, model.layers.end());
  for (auto& joint : model.joints) {
    ++joint.limb;
    ++joint.host;
  }
  auto const raised = raise(model);
  for (auto const& depths : raised.depths) {
    for (double const z : depths) EXPECT_LT(std::abs(z), 600);
  }
}

TEST(LayerDepths, AreTheSameBitsOnEveryMachine) {
  auto const raised = raise(support::five_parts());
  Hash hash;
  for (auto const& depths : raised.depths) {
    for (double const z : depths) hash.add(z);
  }
  EXPECT_EQ(hash.value(), 0x69dd6c70dbc247c6U) << std::hex << hash.value();
}

}  // namespace
}  // namespace inkflate
