// SPDX-License-Identifier: Apache-2.0
#include "io/json_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace inkflate {
namespace {

using Json = nlohmann::ordered_json;

// A square of 80 px with a hole of 20 px; its right side is a help line, the hole's top a closing.
Drawing framed_square() {
  auto const square = [](double min, double size, bool is_hole) {
    Outline outline;
    Vec2 const corners[] = {
        {min, min}, {min + size, min}, {min + size, min + size}, {min, min + size}};
    for (int i = 0; i < 4; ++i) {
      auto const corner = [&](int k) { return corners[(is_hole ? 8 - k : k) % 4]; };
      outline.pieces.push_back({line_cubic(corner(i), corner(i + 1)), RunKind::Ink});
    }
    return outline;
  };
  Drawing drawing;
  drawing.sketch.width_px = 120;
  drawing.sketch.height_px = 100.5;
  drawing.sketch.strokes.resize(4);
  drawing.sketch.strokes[1].samples.resize(7);
  drawing.layers.push_back({"b\"ody", {square(10, 80, false), square(40, 20, true)}, {0, 1}, {2}});
  drawing.layers[0].outlines[0].pieces[1].kind = RunKind::HelpLine;
  drawing.layers[0].outlines[1].pieces[3].kind = RunKind::Closing;
  drawing.stray = {3};
  return drawing;
}

Json report(Drawing const& drawing, std::vector<StageTime> const& stages = {}) {
  return Json::parse(json_report(drawing, stages));
}

TEST(JsonReport, DescribesTheDrawing) {
  auto const json = report(framed_square());
  EXPECT_EQ(json["canvas"].dump(), R"({"width":120.0,"height":100.5})");
  EXPECT_EQ(json["strokes"], 4);
  EXPECT_EQ(json["samples"], 7);
  EXPECT_EQ(json["stray"], 1);
  ASSERT_EQ(json["layers"].size(), 1U);
  auto const& layer = json["layers"][0];
  EXPECT_EQ(layer["name"], "b\"ody");
  EXPECT_EQ(layer["strokes"], 2);
  EXPECT_EQ(layer["details"], 1);
  EXPECT_EQ(layer["contours"][0].dump(),
            R"({"hole":false,"closed":true,"area":6400.0,"perimeter":320.0,)"
            R"("points":[[90.0,10.0],[90.0,90.0],[10.0,90.0],[10.0,10.0]]})");
  EXPECT_EQ(layer["contours"][1]["hole"], true);
  EXPECT_EQ(layer["contours"][1]["area"], 400);
}

TEST(JsonReport, ListsClosingsAndOpenRuns) {
  auto const json = report(framed_square());
  EXPECT_EQ(json["open"].dump(),
            R"([{"layer":0,"from":[90.0,10.0],"to":[90.0,90.0],"length":80.0}])");
  EXPECT_EQ(json["closings"].dump(),
            R"([{"layer":0,"from":[60.0,40.0],"to":[40.0,40.0],"length":20.0}])");
}

TEST(JsonReport, TotalLeavesOutReadingAndWriting) {
  auto const json = report({}, {{"read", 5}, {"triangulate", 1.25}, {"cut", 2}, {"write", 9}});
  EXPECT_EQ(json["ms"].dump(),
            R"({"read":5.0,"triangulate":1.25,"cut":2.0,"write":9.0,"total":3.25})");
}

TEST(JsonReport, KeysKeepTheirOrder) {
  auto const json = report({});
  std::string keys;
  for (auto const& [key, value] : json.items()) keys += key + " ";
  EXPECT_EQ(keys, "canvas strokes samples layers closings open stray ms ");
}

TEST(JsonReport, BadTextDoesNotStopIt) {
  Drawing drawing;
  drawing.layers.push_back({"\xff", {}, {}, {}});
  EXPECT_EQ(report(drawing)["layers"][0]["name"], "\xef\xbf\xbd");
}

TEST(JsonReport, ErrorsTellCodeMessageAndPlace) {
  EXPECT_EQ(json_error({ErrorCode::BadInput, "a \"word\"", 7}),
            R"({"error":{"code":"bad_input","message":"a \"word\"","where":7}})");
  EXPECT_EQ(json_error({ErrorCode::NothingThere, "", -1}),
            R"({"error":{"code":"nothing_there","message":"","where":null}})");
}

}  // namespace
}  // namespace inkflate
