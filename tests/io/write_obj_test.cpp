// SPDX-License-Identifier: Apache-2.0
#include "io/write_obj.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/models.h"

namespace inkflate {
namespace {

/// One triangle on a canvas of 400 px whose first corner is the top left one.
RestModel one_triangle() {
  RestModel model;
  model.mesh = {{{-200, 200, 0}, {-200, -200, 0}, {200, 200, 0}}, {{0, 1, 2}}};
  model.normals.assign(3, {0, 0, 1});
  model.faces = {{0, Side::Front}};
  model.layer_names = {"leaf"};
  return model;
}

TEST(WriteObj, IsWhatTheFormatSays) {
  Texture const texture = {Picture(1, 1), {{{{0, 0}, {0, 1}, {1, 0}}}}};
  auto const files = write_obj(one_triangle(), &texture, "tree");
  EXPECT_EQ(files.obj.substr(files.obj.find('\n') + 1),
            "mtllib tree.mtl\n"
            "v -2 2 0\nv -2 -2 0\nv 2 2 0\n"
            "vt 0 1\nvt 0 0\nvt 1 1\n"  // v grows upward
            "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\n"
            "o leaf\nusemtl drawing\n"
            "f 1/1/1 2/2/2 3/3/3\n");
  EXPECT_NE(files.mtl.find("map_Kd tree.png\n"), std::string::npos);
  EXPECT_FALSE(files.png.empty());
}

TEST(WriteObj, WithoutATextureThereIsClayAndNoPicture) {
  auto const files = write_obj(one_triangle(), nullptr, "tree");
  EXPECT_NE(files.obj.find("usemtl clay\nf 1//1 2//2 3//3\n"), std::string::npos);
  EXPECT_NE(files.mtl.find("newmtl clay\n"), std::string::npos);
  EXPECT_TRUE(files.png.empty());
}

TEST(WriteObj, EveryLayerIsAnObject) {
  auto const files = write_obj(two_layer_model(), nullptr, "two");
  EXPECT_NE(files.obj.find("\no body\n"), std::string::npos);
  EXPECT_NE(files.obj.find("\no nose\n"), std::string::npos);
}

TEST(WriteObj, NamesCannotSmuggleLinesIn) {
  auto model = one_triangle();
  model.layer_names = {"leaf\nf 1 1 1"};
  auto const files = write_obj(model, nullptr, "a\nmtllib b");
  EXPECT_EQ(files.obj.find("\nf 1 1 1"), std::string::npos);
  EXPECT_EQ(files.obj.find("\nmtllib b"), std::string::npos);
}

}  // namespace
}  // namespace inkflate
