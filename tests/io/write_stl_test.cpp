// SPDX-License-Identifier: Apache-2.0
#include "io/write_stl.h"

#include <gtest/gtest.h>

#include <cstring>

#include "io/byte_order.h"
#include "io/print_pose.h"
#include "support/models.h"

namespace inkflate {
namespace {

std::array<float, 12> facet(std::span<std::byte const> file, std::size_t index) {
  std::array<float, 12> numbers = {};
  std::memcpy(numbers.data(), file.subspan(84 + 50 * index).data(), sizeof numbers);
  return numbers;
}

TEST(WriteStl, HoldsEveryTriangleInOrder) {
  TriMesh const mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  auto const file = write_stl(mesh);
  ASSERT_EQ(file.size(), 84U + 2 * 50);
  EXPECT_EQ(little_endian32(std::span(file).subspan(80)), 2U);
  EXPECT_EQ(facet(file, 0), (std::array<float, 12>{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(facet(file, 1), (std::array<float, 12>{1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1}));
}

TEST(WriteStl, IsNotTakenForText) {
  auto const file = write_stl(ball_model({}, 10, 2).mesh);
  EXPECT_NE(std::memcmp(file.data(), "solid", 5), 0);
}

TEST(WriteStl, TrianglesWithoutAreaHaveNoNormal) {
  TriMesh const mesh = {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}};
  auto const numbers = facet(write_stl(mesh), 0);
  EXPECT_EQ((std::array{numbers[0], numbers[1], numbers[2]}), (std::array<float, 3>{}));
}

TEST(PrintPose, StandsUprightOnThePlateAndFacesTheUser) {
  // As tall as 400, with a nose towards the viewer.
  TriMesh const model = {{{-10, 100, 0}, {10, 500, 0}, {0, 300, 50}}, {{0, 1, 2}}};
  auto const posed = print_pose(model, 100);
  EXPECT_EQ(posed.points[0].z, 0);
  EXPECT_EQ(posed.points[1].z, 100);
  EXPECT_LT(posed.points[2].y, posed.points[0].y);  // the front faces -y
  EXPECT_LT(posed.points[0].x, posed.points[1].x);
  EXPECT_EQ(posed.triangles, model.triangles);
}

TEST(PrintPose, KeepsTheOrientation) {
  auto const model = ball_model({5, 6, 7}, 30, 3).mesh;
  auto const posed = print_pose(model, 60);
  Vec3 const middle = {0, 0, 30};
  for (auto const& t : posed.triangles) {
    auto const& a = posed.points[static_cast<std::size_t>(t[0])];
    auto const& b = posed.points[static_cast<std::size_t>(t[1])];
    auto const& c = posed.points[static_cast<std::size_t>(t[2])];
    EXPECT_GT(dot(cross(b - a, c - a), a - middle), 0);
  }
}

TEST(PrintPose, OnePointIsNotScaled) {
  EXPECT_EQ(print_pose({{{5, 5, 5}}, {}}).points[0], Vec3{});
  EXPECT_TRUE(print_pose({}).points.empty());
}

}  // namespace
}  // namespace inkflate
