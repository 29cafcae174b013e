// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "io/write_inkflate.h"

namespace inkflate {
namespace {

// A body and an arm, and a fleck beside them that shall not become a layer.
constexpr char const* kFigure =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200" fill="none" stroke="black">
<g id="body" data-fill="#ff8800" data-thickness="3"><path d="M50 50H150V150H50Z"/></g>
<g id="arm"><path d="M140 80H250V120H140"/></g>
<g id="noise"><path d="M270 20h20v20h-20z"/></g>
</svg>
)";

class ConvertVerb : public testing::Test {
 protected:
  ConvertVerb() { folder_.write("figure.svg", kFigure); }

  ProgramRun run(std::vector<std::string> const& arguments, std::string const& input = "") const {
    return run_inkflate(folder_.path(), arguments, input);
  }

  nlohmann::json info(std::string const& name) const {
    auto const told = run({"info", name, "--json"});
    EXPECT_EQ(told.status, 0) << told.err;
    return nlohmann::json::parse(told.out);
  }

  ScratchFolder folder_;
};

TEST_F(ConvertVerb, StrokesStayAsTheyAre) {
  EXPECT_EQ(run({"convert", "figure.svg", "-o", "a.inkflate"}).status, 0);
  EXPECT_EQ(run({"convert", "a.inkflate", "-o", "b.svg"}).status, 0);
  for (auto const* const name : {"a.inkflate", "b.svg"}) {
    auto const told = info(name);
    EXPECT_EQ(told.at("strokes"), 3) << name;
    EXPECT_TRUE(told.at("layers").empty());
    EXPECT_EQ(told.at("groups").at(0).at("fill"), "#ff8800ff");
    EXPECT_EQ(told.at("groups").at(0).at("thickness"), 3);
  }
}

TEST_F(ConvertVerb, LayersAreKept) {
  EXPECT_EQ(run({"simplify", "--parts", "groups", "figure.svg", "-o", "a.inkflate"}).status, 0);
  EXPECT_EQ(run({"convert", "a.inkflate", "-o", "b.zip"}).status, 0);
  EXPECT_EQ(run({"convert", "b.zip", "-o", "c.svg"}).status, 0);
  EXPECT_EQ(run({"convert", "c.svg", "-o", "d.inkflate"}).status, 0);
  EXPECT_EQ(folder_.read("d.inkflate"), folder_.read("a.inkflate"));
  auto const layers = info("b.zip").at("layers");
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[0].at("name"), "body");
  EXPECT_EQ(layers[0].at("thickness"), 3);
}

TEST_F(ConvertVerb, AMonsterMashProjectIsSimplifiedFirstByGroups) {
  EXPECT_EQ(run({"convert", "figure.svg", "-o", "a.zip"}).status, 0);
  EXPECT_EQ(info("a.zip").at("layers").size(), 2U);
  EXPECT_EQ(info("a.zip").at("format"), "Monster Mash");
}

TEST_F(ConvertVerb, PicturesAreLooksOrMasks) {
  EXPECT_EQ(run({"convert", "figure.svg", "-o", "look.png"}).status, 0);
  EXPECT_EQ(run({"convert", "--mask", "figure.svg", "-o", "mask.png"}).status, 0);
  for (auto const* const name : {"look.png", "mask.png"}) {
    EXPECT_EQ(info(name).at("picture").at("width"), 300) << name;
  }
  EXPECT_NE(folder_.read("look.png"), folder_.read("mask.png"));
}

TEST_F(ConvertVerb, AScanBecomesStrokes) {
  EXPECT_EQ(run({"convert", "figure.svg", "-o", "look.png"}).status, 0);
  EXPECT_EQ(run({"convert", "look.png", "-o", "a.inkflate"}).status, 0);
  EXPECT_GT(info("a.inkflate").at("strokes"), 0);
}

TEST_F(ConvertVerb, ABatchGoesIntoAFolder) {
  auto const told = run({"convert", "figure.svg", "-", "-o", "out/", "--json"}, kFigure);
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(nlohmann::json::parse(told.out).at("files").size(), 2U);
  EXPECT_NE(folder_.read("out/figure.inkflate"), "");
  EXPECT_NE(folder_.read("out/standard-input.inkflate"), "");
}

TEST_F(ConvertVerb, WhatItCannotDoIsTold) {
  EXPECT_EQ(run({"convert", "figure.svg"}).status, 2);
  EXPECT_EQ(run({"convert", "figure.svg", "-o", "a.glb"}).status, 2);
  EXPECT_EQ(run({"convert", "none.svg", "-o", "a.svg"}).status, 4);
  folder_.write("model.obj", "v 0 0 0\n");
  auto const model = run({"convert", "model.obj", "-o", "a.svg"});
  EXPECT_EQ(model.status, 3);
  EXPECT_NE(model.err.find("a model (OBJ)"), std::string::npos) << model.err;
  folder_.write("line.svg", "<svg stroke='red'><path d='M0 0H9'/></svg>");
  EXPECT_EQ(run({"convert", "line.svg", "-o", "a.zip"}).status, 3);
}

TEST_F(ConvertVerb, SimplifyReadsAndWritesProjects) {
  EXPECT_EQ(run({"convert", "figure.svg", "-o", "a.inkflate"}).status, 0);
  EXPECT_EQ(run({"simplify", "a.inkflate", "--parts", "groups", "-o", "b.zip"}).status, 0);
  EXPECT_EQ(run({"simplify", "b.zip", "--parts", "one", "-o", "c.inkflate"}).status, 0);
  EXPECT_EQ(info("b.zip").at("layers").size(), 2U);
  EXPECT_EQ(info("c.inkflate").at("layers").size(), 1U);
}

TEST_F(ConvertVerb, InfoTellsInLinesOrJson) {
  auto const told = run({"info", "figure.svg"});
  EXPECT_EQ(told.status, 0);
  EXPECT_EQ(told.out.find("figure.svg: SVG, "), 0U) << told.out;
  EXPECT_NE(told.out.find("  canvas 300 x 200 px\n"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("  group \"body\": 1 stroke, thickness 3, colour #ff8800ff\n"),
            std::string::npos);
  folder_.write("model.obj", "v 0 0 0\n");
  EXPECT_EQ(info("model.obj").at("format"), "OBJ");
  EXPECT_EQ(info("model.obj").at("bytes"), 8);
  EXPECT_EQ(run({"info", "figure.svg", "-o", "a"}).status, 2);
  EXPECT_EQ(run({"info", "none.svg"}).status, 4);
  folder_.write("junk", "neither fish nor fowl");
  EXPECT_EQ(run({"info", "junk"}).status, 3);
}

TEST_F(ConvertVerb, InfoTellsStatesOfLayersAndMotion) {
  Project project;
  project.drawing.sketch = {300, 200, {}, {Stroke{{{{1, 2}}}, StrokeKind::Ink, 2, {}}}};
  project.drawing.layers = {{"arm", {}, {}, {}}};
  auto& layer = project.drawing.layers[0];
  layer.noise = {0};
  layer.is_hidden = layer.is_locked = layer.is_open = true;
  project.pins = {{PinId{1}, LayerId{1}, Side::Front, {1, 1}, {2, 2}}};
  project.clip = {2.5, {{PinId{1}, {{0, {2, 2}}}}}};
  auto const bytes = write_inkflate(project);
  folder_.write("a.inkflate", {reinterpret_cast<char const*>(bytes->data()), bytes->size()});
  auto const told = run({"info", "a.inkflate"});
  EXPECT_NE(told.out.find("1 noise stroke, hidden, locked, being drawn\n"), std::string::npos);
  EXPECT_NE(told.out.find("  1 pin\n  clip of 2.5 s, 1 track\n"), std::string::npos) << told.out;
}

TEST_F(ConvertVerb, HostileNamesSteerNoTerminal) {
  folder_.write("a.svg", "<svg stroke='red'><g id='&#27;[2J&#x9b;x'><path d='M0 0H9'/></g></svg>");
  auto const told = run({"info", "a.svg"});
  EXPECT_EQ(told.out.find('\033'), std::string::npos);
  EXPECT_EQ(std::count(told.out.begin(), told.out.end(), '\n'), 4);
}

}  // namespace
}  // namespace inkflate
