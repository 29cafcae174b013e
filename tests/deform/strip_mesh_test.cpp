// SPDX-License-Identifier: Apache-2.0
#include "deform/strip_mesh.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/rng.h"
#include "geometry/trig.h"
#include "support/bend_shapes.h"

namespace inkflate {
namespace {

using support::least_area;

ShapeMesh strips(std::vector<Polyline> const& lines, double half_width_px = 12) {
  std::vector<LineSamples> samples;
  for (auto const& line : lines) samples.push_back(sample_line(line));
  return strip_mesh(samples, half_width_px);
}

/// How many pieces the triangles fall into, by common vertices.
int part_count(FlatMesh const& mesh) {
  std::vector<int> part(mesh.points.size());
  std::iota(part.begin(), part.end(), 0);
  auto const find = [&](int v) {
    while (part[v] != v) v = part[v];
    return v;
  };
  for (auto const& [a, b, c] : mesh.triangles) {
    part[find(b)] = find(a);
    part[find(c)] = find(a);
  }
  int count = 0;
  for (int v = 0; v < std::ssize(part); ++v) count += part[v] == v ? 1 : 0;
  return count;
}

Polyline scribble(Rng& rng, int count, double size) {
  Polyline line;
  Vec2 place;
  for (int i = 0; i < count; ++i) {
    line.push_back(place);
    // Some points are repeated, some far away.
    double const step = rng.below(5) == 0 ? 0 : size * rng.uniform() * rng.uniform();
    place += Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)} * step;
  }
  return line;
}

TEST(StripMesh, HasPositiveAreasWhateverTheLineDoes) {
  Rng rng(7);
  for (int i = 0; i < 300; ++i) {
    auto const line = scribble(rng, 2 + rng.below(80), i % 2 == 0 ? 4 : 80);
    auto const shape = strips({line});
    EXPECT_GT(least_area(shape.mesh.rest, shape.mesh.rest.points), 0) << i;
  }
}

TEST(StripMesh, HasPositiveAreasInHairpinsAndSpirals) {
  Polyline hairpin = {{0, 0}, {100, 0}, {0, 0}, {100, 0}, {0, 1e-9}};
  Polyline spiral;
  for (int i = 0; i < 400; ++i) {
    auto const turn = sin_cos(0.2 * i);
    spiral.push_back(Vec2{turn.cos, turn.sin} * (0.05 * i));
  }
  for (auto const& line : {hairpin, spiral}) {
    auto const shape = strips({line});
    EXPECT_GT(least_area(shape.mesh.rest, shape.mesh.rest.points), 0);
    EXPECT_EQ(part_count(shape.mesh.rest), 1);
  }
}

TEST(StripMesh, IsAsWideAsWantedAlongAStraightLine) {
  auto const shape = strips({{{0, 0}, {500, 0}}});
  for (auto const p : shape.mesh.rest.points)
    EXPECT_TRUE(p.y == 0 || std::abs(std::abs(p.y) - 12) < 1e-9) << p.y;
}

TEST(StripMesh, HasAtMostTwoHundredSpineVerticesPerLine) {
  Rng rng(3);
  Polyline line;
  for (int i = 0; i < 20000; ++i) line.push_back({i * 1.0, 20 * sin_cos(i * 0.001).sin});
  auto const shape = strips({line, {{0, 100}, {60, 100}}});
  ASSERT_EQ(shape.mesh.lines.size(), 2U);
  EXPECT_LE(shape.mesh.lines[0].vertices.size(), 201U);
  EXPECT_GT(shape.mesh.lines[0].vertices.size(), 150U);
  EXPECT_EQ(shape.origins[1].index, 1);
}

TEST(StripMesh, KeepsEachLineAStripOfItsOwn) {
  auto const shape = strips({{{0, 0}, {100, 100}}, {{0, 100}, {100, 0}}});
  EXPECT_EQ(part_count(shape.mesh.rest), 2);
}

TEST(StripMesh, MakesDotsOnlyWhereThereIsNothingElse) {
  auto const alone = strips({{{5, 5}}, {}, {{9, 9}, {9, 9}}});
  ASSERT_EQ(alone.mesh.lines.size(), 2U);
  EXPECT_GT(least_area(alone.mesh.rest, alone.mesh.rest.points), 0);
  EXPECT_EQ(alone.origins[1].index, 2);
  auto const beside = strips({{{5, 5}}, {{0, 0}, {100, 0}}});
  ASSERT_EQ(beside.mesh.lines.size(), 1U);
  EXPECT_EQ(beside.origins[0].index, 1);
  EXPECT_TRUE(strips({{}}).mesh.rest.triangles.empty());
}

TEST(StripMesh, GoesAroundClosedLines) {
  auto samples = sample_outline(support::disc_outline({0, 0}, 100), 2);
  auto const shape = strip_mesh(std::vector{samples}, 5);
  ASSERT_EQ(shape.mesh.lines.size(), 1U);
  EXPECT_TRUE(shape.mesh.lines[0].is_closed);
  EXPECT_GT(least_area(shape.mesh.rest, shape.mesh.rest.points), 0);
  // Two rows of quads.
  EXPECT_EQ(shape.mesh.rest.triangles.size(), 4 * shape.mesh.lines[0].vertices.size());
}

}  // namespace
}  // namespace inkflate
