// SPDX-License-Identifier: Apache-2.0
#include "io/read_mesh.h"

#include <gtest/gtest.h>

#include "io/bytes.h"
#include "io/print_objects.h"
#include "io/print_pose.h"
#include "io/write_3mf.h"
#include "io/write_glb.h"
#include "io/write_obj.h"
#include "io/write_stl.h"
#include "support/models.h"

namespace inkflate {
namespace {

constexpr std::string_view kTextStl =
    "solid leaf\n"
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1e0 -2.5\n "
    "endloop\nendfacet\n"
    "endsolid leaf\n";

ErrorCode code_of(Result<MeshReading> const& reading) {
  return reading ? ErrorCode::Cancelled : reading.error().code;
}
ErrorCode code_of(std::string_view text) { return code_of(read_mesh(as_bytes(text))); }

void expect_near(TriMesh const& read, TriMesh const& written, double scale, double tolerance) {
  ASSERT_EQ(read.points.size(), written.points.size());
  for (std::size_t i = 0; i < read.points.size(); ++i) {
    EXPECT_LT(distance(read.points[i], written.points[i] * scale), tolerance);
  }
}

TEST(ReadMesh, GlbReadsBackAsItWasWritten) {
  auto const model = two_layer_model();
  auto const texture = sheet_texture(model, red_over_blue(8));
  auto const reading = read_mesh(write_glb(model, &texture));
  ASSERT_TRUE(reading.has_value()) << reading.error().message;
  EXPECT_EQ(reading->format, FileFormat::Glb);
  EXPECT_EQ(reading->names, model.layer_names);
  EXPECT_TRUE(reading->has_texture);
  ASSERT_EQ(reading->mesh.triangles.size(), model.mesh.triangles.size());
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      auto const read =
          reading->mesh.points[static_cast<std::size_t>(reading->mesh.triangles[t][c])];
      auto const drawn = model.mesh.points[static_cast<std::size_t>(model.mesh.triangles[t][c])];
      EXPECT_LT(distance(read, drawn * 0.01), 1e-6);
    }
  }
}

TEST(ReadMesh, ObjReadsBackAsItWasWritten) {
  auto const model = two_layer_model();
  auto const files = write_obj(model, nullptr, "two");
  auto const reading = read_mesh(as_bytes(files.obj));
  ASSERT_TRUE(reading.has_value()) << reading.error().message;
  EXPECT_EQ(reading->format, FileFormat::Obj);
  EXPECT_EQ(reading->names, model.layer_names);
  EXPECT_FALSE(reading->has_texture);
  EXPECT_EQ(reading->mesh.triangles, model.mesh.triangles);
  expect_near(reading->mesh, model.mesh, 0.01, 1e-6);
}

TEST(ReadMesh, StlReadsBackWithThreePointsForEachTriangle) {
  auto const mesh = print_pose(torus_model(100, 40, 6).mesh);
  auto const reading = read_mesh(write_stl(mesh));
  ASSERT_TRUE(reading.has_value()) << reading.error().message;
  EXPECT_EQ(reading->format, FileFormat::Stl);
  ASSERT_EQ(reading->mesh.triangles.size(), mesh.triangles.size());
  ASSERT_EQ(reading->mesh.points.size(), 3 * mesh.triangles.size());
  EXPECT_LT(distance(reading->mesh.points[3],
                     mesh.points[static_cast<std::size_t>(mesh.triangles[1][0])]),
            1e-5);
}

TEST(ReadMesh, ThreeMfReadsBackAsItWasWritten) {
  auto const model = two_layer_model();
  std::vector<PrintColour> const colours = {{"body", {214, 141, 104}}, {"nose", {200, 20, 20}}};
  auto const reading = read_mesh(write_3mf(print_objects(model, 100), colours));
  ASSERT_TRUE(reading.has_value()) << reading.error().message;
  EXPECT_EQ(reading->format, FileFormat::ThreeMf);
  EXPECT_EQ(reading->names, model.layer_names);
  EXPECT_EQ(reading->mesh.triangles.size(), model.mesh.triangles.size());
  auto const posed = print_pose(model.mesh, 100);
  auto const first = reading->mesh.points[static_cast<std::size_t>(reading->mesh.triangles[7][1])];
  EXPECT_LT(distance(first, posed.points[static_cast<std::size_t>(posed.triangles[7][1])]), 1e-5);
}

TEST(ReadMesh, StlAsText) {
  auto const reading = read_mesh(as_bytes(kTextStl));
  ASSERT_TRUE(reading.has_value()) << reading.error().message;
  EXPECT_EQ(reading->names, std::vector<std::string>{"leaf"});
  EXPECT_EQ(reading->mesh, (TriMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, -2.5}}, {{0, 1, 2}}}));
}

TEST(ReadMesh, ObjOfOthers) {
  auto const reading = read_mesh(as_bytes(
      "# by hand\r\nmtllib a.mtl\r\nv 0 0 0\r\nv 1 0 0 1.0\r\n  v\t1 1 0\nv 0 1 0 .5 .5 .5\n"
      "vt 0 0\ng side\nf 1/1 2/1 3/1 4/1\nf -4//1 -2//2 -1\n"));
  ASSERT_TRUE(reading.has_value()) << reading.error().message;
  EXPECT_EQ(reading->mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 2, 3}}));
  EXPECT_TRUE(reading->has_texture);
}

TEST(ReadMesh, IndicesThatNameNothingAreRefused) {
  EXPECT_EQ(code_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), ErrorCode::BadInput);
  EXPECT_EQ(code_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n"), ErrorCode::BadInput);
  EXPECT_EQ(code_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n"), ErrorCode::BadInput);
  EXPECT_EQ(code_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999\n"), ErrorCode::BadInput);
}

TEST(ReadMesh, FilesCutOffAreRefused) {
  auto const glb = write_glb(ball_model({}, 100, 2));
  auto const stl = write_stl(ball_model({}, 100, 2).mesh);
  for (std::size_t size = 0; size < glb.size(); ++size) {
    EXPECT_FALSE(read_mesh(std::span(glb).first(size)).has_value()) << size;
  }
  for (std::size_t size = 0; size < stl.size(); ++size) {
    EXPECT_FALSE(read_mesh(std::span(stl).first(size)).has_value()) << size;
  }
  for (std::size_t size = 0; size + 10 < kTextStl.size(); ++size) {
    EXPECT_FALSE(read_mesh(as_bytes(kTextStl.substr(0, size))).has_value()) << size;
  }
}

TEST(ReadMesh, WhatIsNoMeshIsNamed) {
  auto const svg = read_mesh(as_bytes("<svg xmlns=\"http://www.w3.org/2000/svg\"/>"));
  ASSERT_FALSE(svg.has_value());
  EXPECT_EQ(svg.error().code, ErrorCode::Unsupported);
  EXPECT_NE(svg.error().message.find("SVG"), std::string::npos);
  EXPECT_EQ(code_of("hello"), ErrorCode::Unsupported);
  EXPECT_EQ(code_of(""), ErrorCode::Unsupported);
  EXPECT_EQ(code_of("v 0 0 0\n"), ErrorCode::NothingThere);
}

}  // namespace
}  // namespace inkflate
