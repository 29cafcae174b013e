// SPDX-License-Identifier: Apache-2.0
#include "io/write_3mf.h"

#include <gtest/gtest.h>

#include "io/print_objects.h"
#include "io/read_mesh.h"
#include "io/read_zip.h"
#include "io/write_zip.h"
#include "mesh/check_mesh.h"
#include "support/models.h"

namespace inkflate {
namespace {

PrintObject one_triangle() {
  return {"leaf", {{{0, 0, 0}, {1.5, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}}, {0}};
}

std::string model_of(std::vector<std::byte> const& file) {
  auto const entries = read_zip_directory(file);
  EXPECT_TRUE(entries.has_value());
  auto const* const model = find_entry(*entries, "3D/3dmodel.model");
  EXPECT_NE(model, nullptr);
  auto const content = unpack(*model);
  EXPECT_TRUE(content.has_value());
  return {reinterpret_cast<char const*>(content->data()), content->size()};
}

TEST(Write3mf, NamesColoursAndMillimetresAreThere) {
  std::vector<PrintColour> const colours = {{"<leaf>", {1, 171, 16, 255}}};
  auto const model = model_of(write_3mf(std::vector{one_triangle()}, colours, "a \"tree\""));
  for (char const* const part :
       {"unit=\"millimeter\"", "<base name=\"&#60;leaf&#62;\" displaycolor=\"#01AB10FF\"/>",
        "<object id=\"2\" type=\"model\" name=\"leaf\" pid=\"1\" pindex=\"0\">",
        "<vertex x=\"1.5\" y=\"0\" z=\"0\"/>", "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>",
        "name=\"a &#34;tree&#34;\"", "<item objectid=\"3\"/>"}) {
    EXPECT_NE(model.find(part), std::string::npos) << part << "\n" << model;
  }
}

TEST(Write3mf, TrianglesOfAnotherColourSaySo) {
  auto object = one_triangle();
  object.mesh.triangles.push_back({0, 2, 1});
  object.colours = {0, 1};
  std::vector<PrintColour> const colours = {{"a", {}}, {"b", {}}};
  auto const model = model_of(write_3mf(std::vector{object}, colours));
  EXPECT_NE(model.find("v1=\"0\" v2=\"2\" v3=\"1\" pid=\"1\" p1=\"1\"/>"), std::string::npos)
      << model;
}

TEST(PrintObjects, LayersApartAreObjectsOfTheirOwn) {
  auto const objects = print_objects(two_layer_model());
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].name, "body");
  EXPECT_EQ(objects[1].name, "nose");
  for (auto const& object : objects) EXPECT_TRUE(check_mesh(object.mesh).is_sound());
}

TEST(PrintObjects, LayersThatAreJoinedAreOneObjectInTwoColours) {
  auto model = ball_model({}, 100, 4);
  model.layer_names = {"front", "back"};
  for (auto& face : model.faces) face.layer = face.side == Side::Front ? 0 : 1;
  auto const objects = print_objects(model);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].name, "front, back");
  EXPECT_EQ(objects[0].colours.front(), 0);
  EXPECT_EQ(objects[0].colours.back(), 1);
  EXPECT_TRUE(check_mesh(objects[0].mesh).is_sound());
}

/// A 3MF around this model, which may be damaged.
ErrorCode code_of(std::string const& model) {
  ZipFile file = {"3D/3dmodel.model", {}};
  for (char const c : model) file.content.push_back(static_cast<std::byte>(c));
  auto const reading = read_mesh(write_zip(std::vector{file}));
  return reading ? ErrorCode::Cancelled : reading.error().code;
}

std::string object(std::string const& inside, std::string const& id = "1") {
  return "<object id=\"" + id + "\">" + inside + "</object>";
}
std::string const kVertices =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices>)";
std::string mesh_with(std::string const& triangle) {
  return kVertices + "<triangles>" + triangle + "</triangles></mesh>";
}
std::string const kGood = mesh_with(R"(<triangle v1="0" v2="1" v3="2"/>)");
std::string const kShown = R"(<build><item objectid="1"/></build>)";

TEST(Read3mf, DamagedModelsAreRefused) {
  auto const in_model = [](std::string const& inside) { return "<model>" + inside + "</model>"; };
  EXPECT_EQ(code_of(in_model(object(kGood) + kShown)), ErrorCode::Cancelled);  // it is good
  EXPECT_EQ(code_of(in_model(object(mesh_with(R"(<triangle v1="0" v2="1" v3="3"/>)")) + kShown)),
            ErrorCode::BadInput);
  EXPECT_EQ(code_of(in_model(object(mesh_with(R"(<triangle v1="0" v2="1" v3="-1"/>)")) + kShown)),
            ErrorCode::BadInput);
  EXPECT_EQ(code_of(in_model(object(mesh_with(R"(<triangle v1="0" v2="1"/>)")) + kShown)),
            ErrorCode::BadInput);
  EXPECT_EQ(code_of(in_model(kGood + kShown)), ErrorCode::BadInput);  // in no object
  EXPECT_EQ(code_of(in_model(object(kGood) + object(kGood) + kShown)), ErrorCode::BadInput);
  EXPECT_EQ(code_of(in_model(object(kGood))), ErrorCode::NothingThere);
  EXPECT_EQ(code_of(in_model(kShown)), ErrorCode::BadInput);
  EXPECT_EQ(code_of("<model>"), ErrorCode::BadInput);
}

TEST(Read3mf, ComponentsOfComponentsEndInAnError) {
  auto const nested = object(R"(<components><component objectid="1"/></components>)");
  EXPECT_EQ(code_of("<model>" + nested + kShown + "</model>"), ErrorCode::Unsupported);
}

TEST(Read3mf, TransformsAreApplied) {
  auto const parts =
      object(kGood, "7") +
      object(
          R"(<components><component objectid="7" transform="2 0 0 0 2 0 0 0 2 10 0 0"/></components>)") +
      R"(<build><item objectid="1" transform="1 0 0 0 1 0 0 0 1 0 5 0"/></build>)";
  ZipFile file = {"3D/3dmodel.model", {}};
  for (char const c : "<model>" + parts + "</model>")
    file.content.push_back(static_cast<std::byte>(c));
  auto const reading = read_mesh(write_zip(std::vector{file}));
  ASSERT_TRUE(reading.has_value()) << reading.error().message;
  EXPECT_EQ(reading->mesh.points[1], (Vec3{12, 5, 0}));
  EXPECT_EQ(reading->mesh.points[2], (Vec3{10, 7, 0}));
}

}  // namespace
}  // namespace inkflate
