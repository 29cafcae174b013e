// SPDX-License-Identifier: Apache-2.0
#include "deform/body_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "support/bend_shapes.h"

namespace inkflate {
namespace {

using support::bar_outline;
using support::disc_outline;
using support::least_area;

std::optional<ShapeMesh> filled(std::vector<Outline> const& outlines, double body = 1) {
  return body_mesh(outlines, body);
}

double mesh_area(FlatMesh const& mesh) {
  double sum = 0;
  for (auto const& t : mesh.triangles)
    sum += cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]) / 2;
  return sum;
}

TEST(BodyMesh, VerticesOfTheRimLieOnTheOutlineWhereTheirParametersSay) {
  auto const disc = disc_outline({500, 400}, 300);
  auto const shape = filled({disc});
  ASSERT_TRUE(shape);
  auto const& line = shape->mesh.lines.at(0);
  auto const& parameters = shape->origins.at(0).parameters;
  ASSERT_EQ(line.vertices.size(), parameters.size());
  EXPECT_TRUE(line.is_closed);
  double before = -1;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    double const u = parameters[k];
    EXPECT_GT(u, before);
    before = u;
    int const piece = static_cast<int>(u);
    EXPECT_EQ(shape->mesh.rest.points[line.vertices[k]],
              point_at(disc.pieces[piece].curve, u - piece));
  }
}

TEST(BodyMesh, FillsTheAreaOfAShapeWithAHole) {
  auto const shape = filled({disc_outline({0, 0}, 200), disc_outline({40, 0}, 80, true)});
  ASSERT_TRUE(shape);
  EXPECT_EQ(shape->mesh.lines.size(), 2U);
  EXPECT_EQ(shape->origins.at(1).index, 1);
  EXPECT_GT(least_area(shape->mesh.rest, shape->mesh.rest.points), 0);
  double const wanted = std::acos(-1.0) * (200 * 200 - 80 * 80);
  EXPECT_NEAR(mesh_area(shape->mesh.rest), wanted, 2e-3 * wanted);
}

TEST(BodyMesh, IsAsCoarseAsWantedButNoCoarserThanAHundredEdgesAround) {
  std::vector<Outline> const disc = {disc_outline({500, 400}, 100)};
  auto const edges = [&](double least_edge_px) {
    auto const shape = body_mesh(disc, 1, least_edge_px);
    return shape ? std::ssize(shape->mesh.lines.at(0).vertices) : 0;
  };
  auto const own = edges(0);
  EXPECT_EQ(edges(0.1), own);
  auto const wanted = edges(4);
  EXPECT_LT(wanted, own / 2);
  EXPECT_NEAR(static_cast<double>(wanted), 2 * std::acos(-1.0) * 100 / 4, 10);
  EXPECT_GE(edges(1e9), 90);
}

TEST(BodyMesh, IsTheSameForASmallDrawingAsForALargeOne) {
  auto const small = filled({bar_outline(3, 0.5)});
  auto const large = filled({bar_outline(3 * 8192, 0.5 * 8192)});
  ASSERT_TRUE(small && large);
  ASSERT_EQ(small->mesh.rest.triangles, large->mesh.rest.triangles);
  for (std::size_t v = 0; v < small->mesh.rest.points.size(); ++v)
    EXPECT_LT(distance(small->mesh.rest.points[v] * 8192, large->mesh.rest.points[v]), 1e-6);
}

TEST(BodyMesh, HasAboutFourHundredVerticesAlongItsRims) {
  auto const shape = filled({disc_outline({500, 500}, 500)});
  ASSERT_TRUE(shape);
  EXPECT_NEAR(static_cast<double>(shape->mesh.lines.at(0).vertices.size()), 400, 20);
  EXPECT_NEAR(shape->mesh.edge_px, 2 * std::acos(-1.0) * 500 / 400, 0.4);
}

TEST(BodyMesh, IsStiffAlongTheRimsAndAsWishedInside) {
  auto const shape = filled({disc_outline({0, 0}, 300), disc_outline({0, 0}, 100, true)}, 0.01);
  ASSERT_TRUE(shape);
  std::vector<char> is_rim(shape->mesh.rest.points.size());
  for (auto const& line : shape->mesh.lines) {
    for (int const v : line.vertices) is_rim[v] = 1;
  }
  int inside = 0;
  for (std::size_t t = 0; t < shape->mesh.rest.triangles.size(); ++t) {
    auto const& [a, b, c] = shape->mesh.rest.triangles[t];
    bool const touches = (is_rim[a] | is_rim[b] | is_rim[c]) != 0;
    EXPECT_EQ(shape->mesh.stiffness[t], touches ? 1 : 0.01);
    inside += touches ? 0 : 1;
  }
  EXPECT_GT(inside, 100);
}

TEST(BodyMesh, HasShorterEdgesWhereTheShapeIsThin) {
  // A disc with a bar of 8 px.
  Outline outline = support::polygon_outline(
      {{0, 0}, {400, 0}, {400, 196}, {1000, 196}, {1000, 204}, {400, 204}, {400, 400}, {0, 400}});
  auto const shape = filled({outline});
  ASSERT_TRUE(shape);
  auto const& mesh = shape->mesh;
  auto const& vertices = mesh.lines.at(0).vertices;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    Vec2 const a = mesh.rest.points[vertices[k]];
    Vec2 const b = mesh.rest.points[vertices[(k + 1) % vertices.size()]];
    if (a.x > 450 && a.x < 950) {
      EXPECT_LT(distance(a, b), 5);
    }
  }
}

TEST(BodyMesh, FillsHolesThatCrossTheRim) {
  auto const shape = filled({disc_outline({0, 0}, 200), disc_outline({190, 0}, 40, true),
                             disc_outline({-50, 0}, 40, true)});
  ASSERT_TRUE(shape);
  ASSERT_EQ(shape->mesh.lines.size(), 2U);
  EXPECT_EQ(shape->origins.at(1).index, 2);
}

TEST(BodyMesh, FillsAnOutlineThatLiesOverItselfSheetBySheet) {
  auto const outline = support::polygon_outline(support::folded_limb_corners());
  auto const shape = filled({outline});
  ASSERT_TRUE(shape.has_value());
  auto const& mesh = shape->mesh.rest;
  EXPECT_GT(least_area(mesh, mesh.points), 0);
  EXPECT_NEAR(mesh_area(mesh), signed_area(support::folded_limb_corners()), 1e-6);
  std::set<std::pair<int, int>> edges;
  for (auto const& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  // A disk.
  EXPECT_EQ(std::ssize(mesh.points) - std::ssize(edges) + std::ssize(mesh.triangles), 1);
  ASSERT_EQ(shape->sheets.size(), mesh.triangles.size());
  EXPECT_TRUE(std::is_sorted(shape->sheets.begin(), shape->sheets.end()));
  EXPECT_GE(shape->sheets.back(), 1);
  EXPECT_FALSE(filled({outline, disc_outline({50, 150}, 20, true)}));
}

TEST(BodyMesh, RefusesOutlinesThatAreNoRimOrHaveNoArea) {
  EXPECT_FALSE(filled({support::crossing_outline(500)}));
  EXPECT_FALSE(filled({support::polygon_outline({{5, 5}, {5, 5}})}));
  EXPECT_FALSE(filled({support::polygon_outline({{5, 5}, {80, 5}})}));
  EXPECT_FALSE(filled({Outline{}, disc_outline({0, 0}, 5)}));
}

}  // namespace
}  // namespace inkflate
