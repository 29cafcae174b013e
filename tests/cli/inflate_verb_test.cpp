// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace inkflate {
namespace {

// A body, and an arm in a group of its own whose open end lies on it.
constexpr char const* kFigure =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="400" height="400" fill="none" stroke="black" stroke-width="3">
<g id="body" data-fill="#f0b040"><path d="M200 80 C300 80 300 320 200 320 C100 320 100 80 200 80"/></g>
<g id="arm"><path d="M215 180 C260 170 300 170 350 175"/><path d="M350 175 C375 185 375 205 350 215"/>
<path d="M350 215 C300 220 260 220 215 225"/></g>
</svg>
)";

class InflateVerb : public testing::Test {
 protected:
  InflateVerb() { folder_.write("figure.svg", kFigure); }

  ProgramRun run(std::vector<std::string> const& arguments, std::string const& input = "") const {
    return run_inkflate(folder_.path(), arguments, input);
  }
  nlohmann::json report(std::vector<std::string> const& arguments) const {
    auto const done = run(arguments);
    EXPECT_EQ(done.status, 0) << done.err;
    return nlohmann::json::parse(done.out, nullptr, false);
  }

  ScratchFolder folder_;
};

TEST_F(InflateVerb, WritesEveryFormatThatTheExtensionSays) {
  for (std::string const name : {"a.glb", "a.obj", "a.stl", "a.3mf", "a.inkflate", "a.zip"}) {
    auto const done = run({"inflate", "figure.svg", "-o", name});
    EXPECT_EQ(done.status, 0) << name << done.err;
    EXPECT_EQ(done.out + done.err, "") << name;
    EXPECT_FALSE(folder_.read(name).empty()) << name;
  }
  EXPECT_TRUE(folder_.read("a.glb").starts_with("glTF"));
  EXPECT_FALSE(folder_.read("a.mtl").empty());
  EXPECT_TRUE(folder_.read("a.png").starts_with("\x89PNG"));
}

TEST_F(InflateVerb, TheArmJoinsTheBody) {
  auto const found = report({"inflate", "figure.svg", "--json"});
  EXPECT_EQ(found["layers"], 2);
  EXPECT_EQ(found["shells"], 1);
  EXPECT_EQ(found["genus"], 0);
  EXPECT_EQ(found["ok"], true);
  EXPECT_EQ(found["unit"], "px");
  EXPECT_GT(found["volume"], 0);
  EXPECT_TRUE(found["ms"].contains("total"));
  EXPECT_EQ(report({"inflate", "figure.svg", "--json", "--open", "capped"})["shells"], 2);
}

TEST_F(InflateVerb, ACopyGoesBehind) {
  auto const found = report({"inflate", "figure.svg", "--json", "--duplicate", "arm"});
  EXPECT_EQ(found["layers"], 3);
  EXPECT_EQ(found["shells"], 1);
  EXPECT_EQ(found["ok"], true);
}

TEST_F(InflateVerb, APrintIsOneShellInMillimetres) {
  auto const found = report({"inflate", "figure.svg", "--print", "--print-size", "40",
                             "--flat-base", "-o", "p.stl", "--json"});
  EXPECT_EQ(found["unit"], "mm");
  EXPECT_EQ(found["shells"], 1);
  EXPECT_NEAR(found["bounding_box"]["min"][2], 0, 1e-6);
  auto const checked = run({"check", "--print", "p.stl"});
  EXPECT_EQ(checked.status, 0) << checked.out;
}

TEST_F(InflateVerb, AProjectInflatesLikeItsSketch) {
  EXPECT_EQ(run({"inflate", "figure.svg", "-o", "p.inkflate"}).status, 0);
  EXPECT_EQ(run({"inflate", "figure.svg", "-o", "a.glb"}).status, 0);
  EXPECT_EQ(run({"inflate", "p.inkflate", "-o", "b.glb"}).status, 0);
  auto const a = report({"inflate", "figure.svg", "--json"});
  auto const b = report({"inflate", "p.inkflate", "--json"});
  EXPECT_EQ(a["vertices"], b["vertices"]);
  EXPECT_EQ(a["volume"], b["volume"]);
}

TEST_F(InflateVerb, StandardOutputGetsAGlb) {
  auto const done = run({"inflate", "-", "-o", "-"}, kFigure);
  EXPECT_EQ(done.status, 0);
  EXPECT_TRUE(done.out.starts_with("glTF"));
}

TEST_F(InflateVerb, MoreThicknessMeansMoreVolume) {
  double const thin = report({"inflate", "figure.svg", "--json", "--thickness", "1"})["volume"];
  double const thick = report({"inflate", "figure.svg", "--json", "--thickness", "4"})["volume"];
  EXPECT_NEAR(thick / thin, 2, 0.1);
}

TEST_F(InflateVerb, WrongUseIsSaidAndNothingIsWritten) {
  for (auto const& arguments : std::vector<std::vector<std::string>>{
           {"inflate", "figure.svg"},
           {"inflate", "figure.svg", "-o", "a.txt"},
           {"inflate", "figure.svg", "-o", "a.glb", "--thickness", "0"},
           {"inflate", "figure.svg", "-o", "a.glb", "--density", "x"},
           {"inflate", "figure.svg", "-o", "a.glb", "--print"},
           {"inflate", "figure.svg", "-o", "a.stl", "--least", "2"},
           {"inflate", "figure.svg", "-o", "a.glb", "--duplicate", "tail"},
           {"inflate", "figure.svg", "-o", "a.glb", "--wear", "template"}}) {
    auto const done = run(arguments);
    EXPECT_EQ(done.status, 2) << arguments.back();
    EXPECT_NE(done.err, "");
  }
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"figure.svg"});
}

TEST_F(InflateVerb, ADrawingWithoutAShapeIsRefused) {
  folder_.write(
      "line.svg",
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><path d="M1 1 L8 8" stroke="black"/></svg>)");
  auto const done = run({"inflate", "line.svg", "-o", "a.glb", "--json"});
  EXPECT_EQ(done.status, 3);
  EXPECT_NE(done.out.find("nothing_there"), std::string::npos);
}

TEST_F(InflateVerb, HiddenLayersAreKeptButNotInflated) {
  EXPECT_EQ(run({"simplify", "--parts", "groups", "figure.svg", "-o", "a.svg"}).status, 0);
  auto text = folder_.read("a.svg");
  std::string const arm = "inkflate:name=\"arm\"";
  ASSERT_NE(text.find(arm), text.npos);
  text.insert(text.find(arm), "inkflate:hidden=\"yes\" ");
  folder_.write("hidden.svg", text);
  EXPECT_EQ(report({"inflate", "hidden.svg", "--json"})["layers"], 1);
  EXPECT_EQ(report({"inflate", "hidden.svg", "-o", "b.inkflate", "--json"})["layers"], 1);
  auto const kept = report({"info", "b.inkflate", "--json"});
  ASSERT_EQ(kept["layers"].size(), 2U);
  EXPECT_EQ(kept["layers"][1]["hidden"], true);
  EXPECT_EQ(run({"render", "b.inkflate", "-o", "b.png", "--size", "64"}).status, 0);
  EXPECT_EQ(run({"inflate", "b.inkflate", "-o", "b.3mf"}).status, 0);
  auto const again = run({"simplify", "--json", "b.inkflate"});
  EXPECT_NE(again.err.find("hidden"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(again.out)["strokes"], 1);
}

TEST_F(InflateVerb, WhereAllIsHiddenThereIsNothing) {
  EXPECT_EQ(run({"simplify", "figure.svg", "-o", "a.svg"}).status, 0);
  auto text = folder_.read("a.svg");
  text.insert(text.find("inkflate:name="), "inkflate:hidden=\"yes\" ");
  folder_.write("a.svg", text);
  auto const done = run({"inflate", "a.svg", "-o", "a.glb", "--json"});
  EXPECT_EQ(done.status, 3);
  EXPECT_EQ(nlohmann::json::parse(done.out)["error"]["code"], "nothing_there");
}

}  // namespace
}  // namespace inkflate
