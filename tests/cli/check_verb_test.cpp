// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "io/print_pose.h"
#include "io/write_glb.h"
#include "io/write_obj.h"
#include "io/write_stl.h"
#include "support/models.h"

namespace inkflate {
namespace {

std::string text_of(std::vector<std::byte> const& bytes) {
  return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
}
std::string obj_of(RestModel const& model) { return write_obj(model, nullptr, "model").obj; }

class CheckVerb : public testing::Test {
 protected:
  ProgramRun check(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "check");
    return run_inkflate(folder_.path(), arguments);
  }
  /// The report of one file with this content, which ends with this status.
  nlohmann::json report(std::string const& content, int status,
                        std::vector<std::string> arguments = {}) const {
    folder_.write("model", content);
    arguments.insert(arguments.begin(), {"model", "--json"});
    auto const run = check(arguments);
    EXPECT_EQ(run.status, status) << run.out << run.err;
    return nlohmann::json::parse(run.out);
  }

  ScratchFolder folder_;
};

TEST_F(CheckVerb, SoundModelsOfEveryFormatAreOk) {
  auto const model = torus_model(100, 40, 12);
  auto const texture = sheet_texture(model, red_over_blue(8));
  for (auto const& content : {text_of(write_glb(model, &texture)), obj_of(model),
                              text_of(write_stl(print_pose(model.mesh)))}) {
    auto const json = report(content, 0, {"--print"});
    EXPECT_EQ(json.at("ok"), true) << json;
    EXPECT_EQ(json.at("vertices"), model.mesh.points.size());  // seams are welded
    EXPECT_EQ(json.at("genus"), 1);
    EXPECT_EQ(json.at("euler"), 0);
    EXPECT_EQ(json.at("shells"), 1);
    EXPECT_GT(json.at("volume").get<double>(), 0);
  }
}

TEST_F(CheckVerb, CrossingPartsCountForPrintsOnly) {
  auto const content = obj_of(two_layer_model());
  auto const json = report(content, 0);
  EXPECT_EQ(json.at("ok"), true);
  EXPECT_EQ(json.at("one_shell"), false);
  EXPECT_EQ(json.at("no_self_crossing"), false);
  EXPECT_GT(json.at("self_crossings"), 0);
  EXPECT_EQ(report(content, 3, {"--print"}).at("ok"), false);
}

TEST_F(CheckVerb, AHoleIsSeen) {
  auto model = torus_model(100, 40, 12);
  model.mesh.triangles.pop_back();
  model.faces.pop_back();
  auto const json = report(obj_of(model), 3);
  EXPECT_EQ(json.at("closed"), false);
  EXPECT_EQ(json.at("boundary_edges"), 3);
  EXPECT_EQ(json.at("manifold"), true);
  EXPECT_EQ(json.at("ok"), false);
}

TEST_F(CheckVerb, ATriangleTurnedOverIsSeen) {
  auto model = torus_model(100, 40, 12);
  std::swap(model.mesh.triangles[5][0], model.mesh.triangles[5][1]);
  EXPECT_EQ(report(obj_of(model), 3).at("oriented"), false);
}

TEST_F(CheckVerb, AModelInsideOutIsSeen) {
  auto model = torus_model(100, 40, 12);
  for (auto& triangle : model.mesh.triangles) std::swap(triangle[0], triangle[1]);
  auto const json = report(obj_of(model), 3);
  EXPECT_EQ(json.at("oriented"), false);
  EXPECT_EQ(json.at("inside_out"), true);
}

TEST_F(CheckVerb, ADoubledTriangleIsSeen) {
  auto model = torus_model(100, 40, 12);
  model.mesh.triangles.push_back(model.mesh.triangles.back());
  model.faces.push_back(model.faces.back());
  EXPECT_EQ(report(obj_of(model), 3).at("manifold"), false);
}

TEST_F(CheckVerb, ACoordinateThatIsNoNumberIsSeen) {
  auto model = ball_model({}, 100, 3);
  auto stl = write_stl(model.mesh);
  for (std::size_t i = 96; i < 100; ++i) stl[i] = std::byte{0xff};  // the first corner's x
  auto const json = report(text_of(stl), 3);
  EXPECT_EQ(json.at("finite"), false);
  EXPECT_EQ(json.at("ok"), false);
}

TEST_F(CheckVerb, TextHasALineForEachProperty) {
  folder_.write("ring.obj", obj_of(torus_model(100, 40, 12)));
  auto const run = check({"ring.obj"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(run.out.starts_with("ring.obj: OBJ, 288 vertices, 576 triangles: ok\n")) << run.out;
  EXPECT_NE(run.out.find("  yes  closed\n"), std::string::npos);
  EXPECT_NE(run.out.find("  1 shell, genus 1, V - E + F = 0"), std::string::npos) << run.out;
}

TEST_F(CheckVerb, ADrawingIsNoMesh) {
  folder_.write("a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  auto const run = check({"a.svg"});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("not a mesh"), std::string::npos) << run.err;
}

TEST_F(CheckVerb, SeveralFilesAreAllChecked) {
  folder_.write("good.obj", obj_of(ball_model({}, 100, 3)));
  folder_.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  auto const run = check({"bad.obj", "good.obj", "--json"});
  EXPECT_EQ(run.status, 3);
  auto const files = nlohmann::json::parse(run.out).at("files");
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].at("ok"), false);
  EXPECT_EQ(files[1].at("ok"), true);
}

TEST_F(CheckVerb, WritesNoFile) {
  folder_.write("good.obj", obj_of(ball_model({}, 100, 3)));
  EXPECT_EQ(check({"good.obj", "-o", "x.glb"}).status, 2);
  EXPECT_EQ(check({"missing.obj"}).status, 4);
}

}  // namespace
}  // namespace inkflate
