// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/picture_in.h"
#include "cli/program.h"

namespace inkflate {
namespace {

// A red disc, drawn with two strokes.
constexpr char const* kDisc =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100" fill="none" stroke="black" stroke-width="2">
<g id="disc" data-fill="#ff2020"><path d="M60 50 A40 40 0 0 1 140 50"/><path d="M140 50 A40 40 0 0 1 60 50"/></g>
</svg>
)";

class RenderVerb : public testing::Test {
 protected:
  RenderVerb() { folder_.write("disc.svg", kDisc); }

  ProgramRun render(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "render");
    return run_inkflate(folder_.path(), arguments);
  }

  Picture picture(std::string const& name) const { return picture_in(folder_, name); }

  ScratchFolder folder_;
};

TEST_F(RenderVerb, TheModelStandsInTheMiddleOfAClearPicture) {
  auto const run = render({"disc.svg", "-o", "disc.png", "--size", "120x80"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  auto const disc = picture("disc.png");
  EXPECT_EQ(disc.width, 120);
  EXPECT_EQ(disc.height, 80);
  EXPECT_EQ(disc.at(0, 0).a, 0);
  EXPECT_EQ(disc.at(60, 40).a, 255);
  EXPECT_GT(disc.at(60, 40).r, disc.at(60, 40).g + 100);
}

TEST_F(RenderVerb, ShadingsDiffer) {
  std::vector<Picture> pictures;
  for (std::string const shading : {"textured", "matcap", "lines", "drawing"}) {
    auto const run =
        render({"disc.svg", "-o", shading + ".png", "--size", "64", "--shading", shading});
    EXPECT_EQ(run.status, 0) << run.err;
    for (auto const& other : pictures) EXPECT_NE(picture(shading + ".png"), other);
    pictures.push_back(picture(shading + ".png"));
  }
}

TEST_F(RenderVerb, TheBackgroundIsAnyColour) {
  auto const run =
      render({"disc.svg", "-o", "disc.png", "--size", "64", "--background", "#102030", "--shadow"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(picture("disc.png").at(0, 0), (Colour{0x10, 0x20, 0x30}));
}

TEST_F(RenderVerb, JsonTellsSizeAndTimes) {
  auto const run = render({"disc.svg", "-o", "disc.png", "--size", "64x32", "--json"});
  auto const report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report["width"], 64);
  EXPECT_EQ(report["height"], 32);
  EXPECT_TRUE(report["ms"].contains("render"));
}

TEST_F(RenderVerb, BadOptionsAreNamed) {
  for (auto const& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--size", "0"},
                                                        {"--size", "10x"},
                                                        {"--size", "12.5"},
                                                        {"--size", "16384x16384"},
                                                        {"--turn", "left"},
                                                        {"--tilt", "nan"},
                                                        {"--background", "papery"},
                                                        {"--shading", "oil"}}) {
    auto const run = render({"disc.svg", "-o", "disc.png", option, value});
    EXPECT_EQ(run.status, 2) << option << ' ' << value;
    EXPECT_NE(run.err.find(option), std::string::npos) << run.err;
  }
  EXPECT_EQ(render({"disc.svg"}).status, 2);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"disc.svg"});
}

}  // namespace
}  // namespace inkflate
