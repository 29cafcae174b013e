// SPDX-License-Identifier: Apache-2.0
#include "pipeline/run_inflate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/polyline.h"
#include "geometry/trig.h"
#include "inflate/inflate.h"
#include "mesh/check_mesh.h"
#include "support/characters.h"
#include "support/depth_order.h"
#include "support/joint_angles.h"

namespace inkflate {
namespace {

RestModel inflated(Drawing const& drawing) {
  auto model = run_inflate(drawing);
  EXPECT_TRUE(model.has_value()) << model.error().message;
  return model ? std::move(*model) : RestModel{};
}

/// Nothing wrong, in as many pieces as expected; returns the rest.
MeshCheck sound_mesh(RestModel const& model, int shells) {
  auto const found = check_mesh(model.mesh);
  EXPECT_TRUE(found.is_closed());
  EXPECT_TRUE(found.is_manifold());
  EXPECT_TRUE(found.is_oriented());
  EXPECT_TRUE(found.is_finite());
  EXPECT_EQ(found.zero_area_triangles, 0);
  EXPECT_EQ(found.flipped_triangles, 0);
  EXPECT_EQ(found.shells, shells);
  EXPECT_GT(found.volume, 0);
  return found;
}

double highest(RestModel const& model) {
  double z = 0;
  for (auto const p : model.mesh.points) z = std::max(z, p.z);
  return z;
}

Drawing mirrored(Drawing drawing) {
  for (auto& layer : drawing.layers) {
    for (auto& outline : layer.outlines) {
      std::reverse(outline.pieces.begin(), outline.pieces.end());
      for (auto& piece : outline.pieces) {
        auto& control = piece.curve.control;
        std::reverse(control.begin(), control.end());
        for (auto& p : control) p.x = drawing.sketch.width_px - p.x;
      }
    }
  }
  return drawing;
}

Vec3 mean_point(RestModel const& model) {
  // Weighted by area, so that it does not depend on where the mesh is fine.
  Vec3 sum;
  double area = 0;
  auto const& points = model.mesh.points;
  for (auto const& [a, b, c] : model.mesh.triangles) {
    double const own = norm(cross(points[b] - points[a], points[c] - points[a]));
    sum += (points[a] + points[b] + points[c]) * own;
    area += own;
  }
  return sum / (3 * area);
}

/// Where the drawn points of a layer at this x came to lie, from top to bottom.
Polyline right_side(FlatLayer const& layer, RestModel const& model, double x) {
  std::map<double, Vec2> places;
  for (std::size_t t = 0; t < layer.mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      int const point = layer.mesh.triangles[t][k];
      Vec2 const drawn = layer.mesh.points[point];
      bool const is_on_it = layer.kinds[point] == VertexKind::Drawn && std::abs(drawn.x - x) < 1e-6;
      if (is_on_it) places[drawn.y] = model.canvas[layer.sheets[0][t][k]];
    }
  }
  Polyline line;
  for (auto const& entry : places) line.push_back(entry.second);
  return line;
}

/// Degrees.
double sharpest_corner(Polyline const& line) {
  double least_cosine = 1;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    least_cosine = std::min(
        least_cosine, dot(normalized(line[i] - line[i - 1]), normalized(line[i + 1] - line[i])));
  }
  return acos_of(least_cosine) * 180 / kPi;
}

TEST(RunInflate, ADiscOfThicknessFourIsABall) {
  auto drawing = drawing_of({drawn_layer("ball", ellipse_contour({500, 500}, 300, 300))});
  drawing.layers[0].thickness = 4;
  auto const model = inflated(drawing);
  auto const found = sound_mesh(model, 1);
  EXPECT_NEAR(highest(model), 300, 3);
  EXPECT_NEAR(found.volume, 4.0 / 3 * M_PI * 300 * 300 * 300, 0.01 * found.volume);
}

TEST(RunInflate, ATubeOfThicknessTwoIsAsThickAsWide) {
  Layer const tube = drawn_layer("tube", {{100, 450}, {900, 450}, {900, 550}, {100, 550}});
  EXPECT_NEAR(highest(inflated(drawing_of({tube}))), 50, 0.5);
}

TEST(RunInflate, HeightGrowsWithTheRootOfTheThickness) {
  auto drawing = drawing_of({drawn_layer("disc", ellipse_contour({500, 500}, 200, 150))});
  double const normal = highest(inflated(drawing));
  drawing.layers[0].thickness = 8;
  EXPECT_NEAR(highest(inflated(drawing)), 2 * normal, 1e-6 * normal);
}

TEST(RunInflate, ARingHasGenusOne) {
  auto const model = inflated(drawing_of({ring_layer("ring", {500, 500}, 120, 300)}));
  EXPECT_EQ(sound_mesh(model, 1).genus, 1);
}

TEST(RunInflate, ALoneLayerIsAsThickInFrontAsBehind) {
  auto const model =
      inflated(drawing_of({drawn_layer("disc", ellipse_contour({400, 500}, 200, 150))}));
  auto const found = check_mesh(model.mesh);
  EXPECT_NEAR(found.min.z, -found.max.z, 1e-9);
  EXPECT_NEAR((found.min.x + found.max.x) / 2, -100, 0.5);
}

TEST(RunInflate, CharactersAreSoundAndOfOnePiece) {
  for (int const layers : {1, 3, 5, 21}) {
    EXPECT_EQ(sound_mesh(inflated(character(layers)), 1).genus, 0) << layers;
  }
}

TEST(RunInflate, NormalsHaveLengthOneAndLookOutward) {
  auto const model = inflated(character(3));
  auto const& mesh = model.mesh;
  for (auto const& normal : model.normals) EXPECT_NEAR(norm(normal), 1, 1e-9);
  int against = 0;
  for (auto const& [a, b, c] : mesh.triangles) {
    auto const face = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    against += dot(face, model.normals[a] + model.normals[b] + model.normals[c]) < 0 ? 1 : 0;
  }
  EXPECT_LT(against, static_cast<int>(std::ssize(mesh.triangles)) / 100);
}

TEST(RunInflate, LayersLieOneBeforeTheOther) {
  for (int const layers : {3, 5, 21}) {
    auto const model = inflated(character(layers));
    auto const order = measure_depth_order(support::sheets_of(model));
    RecordProperty("samples_" + std::to_string(layers), order.samples);
    EXPECT_GT(order.samples, 0);
    EXPECT_LE(order.wrong_share(), 0.02) << layers;
    EXPECT_LE(order.worst_px, 2) << layers << " at " << order.worst_at.x << ", "
                                 << order.worst_at.y;
  }
}

TEST(RunInflate, TheSurfaceRunsOnSmoothlyAtTheEndsOfJoints) {
  for (int const layers : {3, 5}) {
    auto const flat = assemble(character(layers));
    ASSERT_TRUE(flat.has_value());
    auto const model = inflate(*flat);
    ASSERT_TRUE(model.has_value());
    EXPECT_LE(largest_angle_at_joints(*flat, *model, 10), 25) << layers;
  }
}

TEST(RunInflate, AStraightLimbHasNoStepInItsOutlineWhereItsJointEnds) {
  for (double const half_width_px : {20.0, 30.0, 60.0}) {
    auto const flat =
        assemble(drawing_of({drawn_layer("body", ellipse_contour({500, 350}, 300, 200)),
                             limb_layer("limb", {500, 400}, {500, 850}, half_width_px)}));
    ASSERT_TRUE(flat.has_value());
    auto const model = inflate(*flat);
    ASSERT_TRUE(model.has_value());
    auto const line = right_side(flat->layers[1], *model, 500 + half_width_px);
    ASSERT_GT(line.size(), 20U);
    EXPECT_LE(sharpest_corner(line), 33) << half_width_px;
  }
}

TEST(RunInflate, JointsLeaveTheDrawnOutlineOfTheBodyWhereItWas) {
  auto const model = inflated(character(5));
  double left = 0;
  for (std::size_t v = 0; v < model.canvas.size(); ++v)
    left = std::min(left, model.mesh.points[v].y);
  // The lowest point of the drawing is the right leg's end.
  EXPECT_NEAR(left, 500 - (900 + 65), 1.5);
}

TEST(RunInflate, AMirroredDrawingGivesAMirroredModel) {
  auto const drawing = character(5);
  auto const model = inflated(drawing);
  auto const mirror = inflated(mirrored(drawing));
  auto const found = check_mesh(model.mesh);
  auto const seen = check_mesh(mirror.mesh);
  EXPECT_NEAR(seen.volume, found.volume, 0.01 * found.volume);
  EXPECT_NEAR(seen.min.x, -found.max.x, 1);
  EXPECT_NEAR(seen.max.x, -found.min.x, 1);
  EXPECT_NEAR(seen.min.z, found.min.z, 3);
  EXPECT_NEAR(seen.max.z, found.max.z, 3);
  EXPECT_NEAR(mean_point(mirror).x, -mean_point(model).x, 1);
  EXPECT_NEAR(mean_point(mirror).z, mean_point(model).z, 1);
}

TEST(RunInflate, StagesAreReportedAndCanBeStopped) {
  for (std::string const stage : {"join", "mesh", "stitch", "inflate", "order", "shape"}) {
    std::string last;
    Progress const progress = {[&](std::string_view name) { last = name; },
                               [&] { return last == stage; }};
    auto const model = run_inflate(character(3), {}, progress);
    ASSERT_FALSE(model.has_value()) << stage;
    EXPECT_EQ(model.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(last, stage);
  }
}

}  // namespace
}  // namespace inkflate
