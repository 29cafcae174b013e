// SPDX-License-Identifier: Apache-2.0
#include "io/write_glb.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/hash.h"
#include "io/glb_parts.h"
#include "io/read_picture.h"
#include "support/models.h"

namespace inkflate {
namespace {

TEST(WriteGlb, LengthsInTheContainerAddUp) {
  for (int rings = 2; rings < 6; ++rings) {  // so that every padding occurs
    auto const file = write_glb(ball_model({}, 100, rings), nullptr, std::string(rings, 'x'));
    auto const json_bytes = little_endian32(std::span(file).subspan(12));
    auto const binary_bytes = little_endian32(std::span(file).subspan(20 + json_bytes));
    EXPECT_EQ(little_endian32(std::span(file).subspan(8)), file.size());
    EXPECT_EQ(28 + json_bytes + binary_bytes, file.size());
    EXPECT_EQ(json_bytes % 4 + binary_bytes % 4, 0U);
    EXPECT_EQ(glb_parts(file).json.at("buffers").at(0).at("byteLength"), binary_bytes);
  }
}

TEST(WriteGlb, BoundsAreThoseOfWhatIsStored) {
  auto const file = write_glb(ball_model({3, 5, 7}, 101.3));
  auto const parts = glb_parts(file);
  auto const positions = parts.floats("POSITION");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float low = positions[axis];
    float high = low;
    for (std::size_t i = axis; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    EXPECT_EQ(parts.accessor("POSITION").at("min").at(axis).get<double>(), double{low});
    EXPECT_EQ(parts.accessor("POSITION").at("max").at(axis).get<double>(), double{high});
  }
}

TEST(WriteGlb, HundredPixelsAreOneUnit) {
  auto const file = write_glb(ball_model({}, 100));
  auto const parts = glb_parts(file);
  EXPECT_FLOAT_EQ(parts.accessor("POSITION").at("max").at(1).get<float>(), 1);
}

TEST(WriteGlb, VerticesAreSplitOnlyAlongTheSeam) {
  auto const model = ball_model({}, 100, 4);
  auto const texture = sheet_texture(model, red_over_blue(8));
  auto const file = write_glb(model, &texture);
  auto const parts = glb_parts(file);
  int const on_the_rim = 16;
  EXPECT_EQ(parts.accessor("POSITION").at("count"), model.mesh.points.size() + on_the_rim);
  auto const plain = write_glb(model);
  EXPECT_EQ(glb_parts(plain).accessor("POSITION").at("count"), model.mesh.points.size());
}

TEST(WriteGlb, PlacesInTheTextureKeepTheirDirection) {
  auto const model = ball_model({}, 100, 4);
  auto const texture = sheet_texture(model, red_over_blue(8));
  auto const file = write_glb(model, &texture);
  auto const positions = glb_parts(file).floats("POSITION");
  auto const uvs = glb_parts(file).floats("TEXCOORD_0");
  ASSERT_EQ(uvs.size() / 2, positions.size() / 3);
  for (std::size_t i = 0; i < uvs.size() / 2; ++i) {
    EXPECT_NEAR(uvs[2 * i + 1], 0.5 - positions[3 * i + 1] / 4, 1e-6);  // v grows downward
  }
}

TEST(WriteGlb, ThePictureInsideIsTheTexture) {
  auto const model = ball_model({}, 100, 4);
  auto const texture = sheet_texture(model, red_over_blue(8));
  auto const file = write_glb(model, &texture);
  auto const parts = glb_parts(file);
  auto const picture = read_picture(parts.view(parts.json.at("images").at(0).at("bufferView")));
  ASSERT_TRUE(picture.has_value()) << picture.error().message;
  EXPECT_EQ(*picture, texture.picture);
}

/// Triangles that share no vertex.
RestModel loose_triangles(int count) {
  RestModel model;
  for (int i = 0; i < count; ++i) {
    double const x = i;
    for (Vec3 const p : {Vec3{x, 0, 0}, Vec3{x, 1, 0}, Vec3{x, 0, 1}})
      model.mesh.points.push_back(p);
    model.mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  model.normals.assign(model.mesh.points.size(), {1, 0, 0});
  model.faces.resize(model.mesh.triangles.size());
  return model;
}

TEST(WriteGlb, MoreThan65535VerticesTakeIndicesOf32Bits) {
  auto const short_file = write_glb(loose_triangles(65'535 / 3));
  auto const long_file = write_glb(loose_triangles(65'538 / 3));
  auto const short_indices = glb_parts(short_file).view(2);
  auto const long_indices = glb_parts(long_file).view(2);
  EXPECT_EQ(glb_parts(short_file).accessor("indices").at("componentType"), 5123);
  EXPECT_EQ(little_endian16(short_indices.last(2)), 65'534U);
  EXPECT_EQ(glb_parts(long_file).accessor("indices").at("componentType"), 5125);
  EXPECT_EQ(little_endian32(long_indices.last(4)), 65'537U);
}

TEST(WriteGlb, ExtrasTellTheTrianglesOfEachLayer) {
  auto const model = two_layer_model();
  auto const file = write_glb(model);
  auto const layers = glb_parts(file).json.at("meshes").at(0).at("extras").at("layers");
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[0].at("name"), "body");
  EXPECT_EQ(layers[1].at("name"), "nose");
  EXPECT_EQ(layers[1].at("first_triangle"), layers[0].at("triangles"));
  EXPECT_EQ(
      layers[0].at("triangles").get<std::size_t>() + layers[1].at("triangles").get<std::size_t>(),
      model.mesh.triangles.size());
}

TEST(WriteGlb, OnlyModelsWithOpenEndsShowTheirInside) {
  auto model = ball_model({}, 100, 2);
  EXPECT_FALSE(glb_parts(write_glb(model)).json.at("materials").at(0).contains("doubleSided"));
  model.mesh.triangles.pop_back();
  model.faces.pop_back();
  EXPECT_EQ(glb_parts(write_glb(model)).json.at("materials").at(0).at("doubleSided"), true);
}

TEST(WriteGlb, NamesThatAreNoUtf8AreWrittenAll) {
  auto model = ball_model({}, 100, 2);
  model.layer_names = {"\xff\"\n"};
  EXPECT_FALSE(write_glb(model, nullptr, "\xc3").empty());
}

TEST(WriteGlb, BytesAreTheSameOnEveryMachine) {
  auto const model = two_layer_model();
  auto const texture = sheet_texture(model, red_over_blue(16));
  auto const file = write_glb(model, &texture);
  auto const parts = glb_parts(file);
  Hash hash;
  hash.add(parts.binary);
  EXPECT_EQ(hash.value(), 13001124807517976042U);
}

}  // namespace
}  // namespace inkflate
