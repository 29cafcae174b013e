// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace inkflate {
namespace {

// A long bar and, away from it, a small square; each closed by one stroke.
constexpr char const* kParts =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="600" height="400" fill="none" stroke="black">
<g id="bar"><path d="M100 180 H500 V220 H100 Z"/></g>
<g id="box"><path d="M100 300 H160 V360 H100 Z"/></g>
</svg>
)";

class DeformVerb : public testing::Test {
 protected:
  DeformVerb() { folder_.write("parts.svg", kParts); }

  ProgramRun deform(std::vector<std::string> arguments, std::string const& input = "") const {
    arguments.insert(arguments.begin(), "deform");
    return run_inkflate(folder_.path(), arguments, input);
  }

  nlohmann::json report(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "parts.svg");
    arguments.emplace_back("--json");
    auto const run = deform(std::move(arguments));
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out);
  }

  ScratchFolder folder_;
};

TEST_F(DeformVerb, PinsGoWhereTheyShallAndOnlyTheirPartMoves) {
  folder_.write(
      "pins.json",
      R"({"pins": [{"part": "bar", "at": [100, 200]}, {"at": [502, 200], "to": [480, 120]}]})");
  auto const told = report({"--pins", "pins.json", "-o", "bent.inkflate"});
  EXPECT_EQ(told.at("parts"), (nlohmann::json{"bar"}));
  ASSERT_EQ(told.at("pins").size(), 2U);
  for (auto const& pin : told.at("pins")) {
    EXPECT_EQ(pin.at("part"), "bar");
    EXPECT_LT(pin.at("off").get<double>(), 1);
  }
  EXPECT_EQ(told.at("pins")[1].at("to"), (nlohmann::json{480, 120}));
  EXPECT_EQ(told.at("settled"), true);
  EXPECT_GT(told.at("steps").get<int>(), 0);
  EXPECT_GE(told.at("ms").at("total").get<double>(), told.at("ms").at("bend").get<double>());
  EXPECT_TRUE(folder_.read("bent.inkflate").starts_with("PK"));
}

TEST_F(DeformVerb, WritesEveryFormatOfDrawings) {
  for (auto const* const output : {"a.svg", "a.inkflate", "a.zip", "a.png", "folder/"}) {
    auto const run = deform({"parts.svg", "--pin", "bar:500,200:480,120", "-o", output});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out + run.err, "");
  }
  EXPECT_TRUE(folder_.read("a.png").starts_with("\x89PNG"));
  EXPECT_NE(folder_.read("folder/parts.inkflate"), "");
  auto const to_output = deform({"-", "--pin", "bar:500,200:480,120", "-o", "-"}, kParts);
  EXPECT_EQ(to_output.out, folder_.read("a.svg"));
}

TEST_F(DeformVerb, APictureShowsTheBend) {
  std::vector<std::string> const bend = {"parts.svg", "--pin", "bar:500,200:480,120"};
  auto const run = deform({bend[0], bend[1], bend[2], "--picture", "look.png"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"look.png", "parts.svg"}));
  EXPECT_EQ(deform({bend[0], bend[1], bend[2], "-o", "bent.svg"}).status, 0);
  run_inkflate(folder_.path(), {"convert", "bent.svg", "-o", "bent.png"});
  EXPECT_EQ(folder_.read("look.png"), folder_.read("bent.png"));
  EXPECT_EQ(deform({bend[0], bend[1], bend[2]}).status, 2);
  EXPECT_EQ(deform({bend[0], bend[1], bend[2], "--picture", "parts.svg"}).status, 2);
}

TEST_F(DeformVerb, TheSamePinsFromAFileAndTheCommandLineMakeTheSame) {
  folder_.write("pins.json", R"({"mode": "wire", "pins": [
    {"part": 1, "at": [100, 200]}, {"part": "bar", "at": [500, 200], "to": [480, 120], "turn": -20}]})");
  EXPECT_EQ(deform({"parts.svg", "--pins", "pins.json", "-o", "a.svg"}).status, 0);
  EXPECT_EQ(deform({"parts.svg", "--mode", "wire", "--pin", "bar:100,200", "--pin",
                    ":500,200:480,120:-20", "-o", "b.svg"})
                .status,
            0);
  EXPECT_EQ(folder_.read("a.svg"), folder_.read("b.svg"));
  EXPECT_EQ(deform({"parts.svg", "--mode", "body", "--pins", "pins.json", "-o", "c.svg"}).status,
            0);
  EXPECT_NE(folder_.read("a.svg"), folder_.read("c.svg"));
}

TEST_F(DeformVerb, RefusesPinsThatMeanNothingAndSaysWhich) {
  struct Case {
    std::string pins;
    std::string says;
  };
  for (auto const& [pins, says] :
       {Case{"[]", "wants"}, Case{R"({"pins": 7})", "wants"}, Case{"{", "pins.json"},
        Case{R"({"pins": [7]})", "pin 1"},
        Case{R"({"pins": [{"at": [100, 200]}, {"at": [100]}]})", "pin 2"},
        Case{R"({"pins": [{"at": [100, 200], "two": [1, 2]}]})", "\"two\""},
        Case{R"({"pins": [{"at": [100, 200], "to": [1e7, 2]}]})", "1 000 000 px"},
        Case{R"({"pins": [{"at": [100, "nan"]}]})", "1 000 000 px"},
        Case{R"({"pins": [{"at": [100, 200], "turn": 3601}]})", "3600"},
        Case{R"({"pins": [{"at": [100, 200], "part": "leg"}]})",
             R"(no part "leg"; there are 1 "bar", 2 "box")"},
        Case{R"({"pins": [{"at": [100, 200], "part": 3}]})", "no part \"3\""},
        Case{R"({"pins": [{"at": [100, 200], "part": "box"}]})", "px from the line of \"box\""},
        Case{R"({"pins": [{"at": [300, 270]}]})",
             "50 px from the line of the nearest part, \"bar\""},
        Case{R"({"pins": [], "mode": "soft"})", "\"soft\""},
        Case{R"({"pins": [], "body": 2})", "0.003 to 1"},
        Case{R"({"pins": [], "pin": []})", "\"pin\""}}) {
    folder_.write("pins.json", pins);
    auto const run = deform({"parts.svg", "--pins", "pins.json", "-o", "bent.svg"});
    EXPECT_EQ(run.status, 3) << pins << run.err;
    EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("pins.json"), std::string::npos) << run.err;
  }
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"parts.svg", "pins.json"}));
}

TEST_F(DeformVerb, RefusesWrongUsage) {
  std::vector<std::vector<std::string>> const wrong = {
      {"-o", "bent.svg"},
      {"--pin", "bar:500,200:480,120"},
      {"--pin", "bar", "-o", "bent.svg"},
      {"--pin", "bar:500", "-o", "bent.svg"},
      {"--pin", "bar:500,200:480,120:4000", "-o", "bent.svg"},
      {"--pin", "bar:500,200:480,120", "-o", "bent.glb"},
      {"--pin", "bar:500,200:480,120", "-o", "parts.svg"},
      {"--pin", "bar:500,200:480,120", "-o", "bent.svg", "--mode", "soft"},
      {"--pin", "bar:500,200:480,120", "-o", "bent.svg", "--body", "0"},
      {"--pin", "bar:500,200:480,120", "-o", "bent.svg", "--body", "1", "--mode", "wire"},
      {"--pin", "bar:500,200:480,120", "-o", "-", "--json"}};
  for (auto arguments : wrong) {
    arguments.insert(arguments.begin(), "parts.svg");
    auto const run = deform(arguments);
    EXPECT_EQ(run.status, 2) << arguments[2] << run.err;
  }
  EXPECT_EQ(deform({"parts.svg", "--pins", "none.json", "-o", "bent.svg"}).status, 4);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"parts.svg"});
}

TEST_F(DeformVerb, PinsThatMoveNothingAreRefused) {
  auto const run = deform({"parts.svg", "--pin", "bar:500,200", "-o", "bent.svg"});
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_NE(run.err.find("nothing moves; a pin that goes somewhere"), std::string::npos) << run.err;
}

TEST_F(DeformVerb, PinsThatDoNotGetThereAreToldUnlessQuiet) {
  std::vector<std::string> const pulled = {"parts.svg",   "--pin", "bar:500,200:560,260", "--pin",
                                           "bar:100,200", "--pin", "bar:500,200:460,260", "-o",
                                           "bent.svg"};
  auto const told = deform(pulled);
  EXPECT_EQ(told.status, 0) << told.err;
  std::string const says = "parts.svg: warning: --pin 1 ends 55 px from where it was to go (1 more";
  EXPECT_NE(told.err.find(says), std::string::npos) << told.err;
  EXPECT_EQ(std::count(told.err.begin(), told.err.end(), '\n'), 1) << told.err;
  auto quiet = pulled;
  quiet.emplace_back("--quiet");
  EXPECT_EQ(deform(quiet).err, "");
}

TEST_F(DeformVerb, BatchGoesOnAfterAFileWithoutSuchAPart) {
  folder_.write("other.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" width="600" height="400">
<g id="box"><path d="M100 300 H160 V360 H100 Z" fill="none" stroke="black"/></g></svg>)");
  auto const run = deform({"other.svg", "parts.svg", "--pin", "bar:500,200:480,120", "-o", "out/"});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("other.svg: --pin 1: there is no part \"bar\""), std::string::npos)
      << run.err;
  EXPECT_NE(folder_.read("out/parts.inkflate"), "");
}

}  // namespace
}  // namespace inkflate
