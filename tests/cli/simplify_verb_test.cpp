// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace inkflate {
namespace {

// A square drawn with four strokes whose corners do not quite meet.
constexpr char const* kSquare =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="200" height="200" fill="none" stroke="black">
<path d="M52 50 H148"/><path d="M150 52 V148"/><path d="M148 150 H52"/><path d="M50 148 V52"/>
</svg>
)";

class SimplifyVerb : public testing::Test {
 protected:
  SimplifyVerb() { folder_.write("square.svg", kSquare); }

  ProgramRun simplify(std::vector<std::string> arguments, std::string const& input = "") const {
    arguments.insert(arguments.begin(), "simplify");
    return run_inkflate(folder_.path(), arguments, input);
  }

  ScratchFolder folder_;
};

std::ptrdiff_t line_count(std::string const& text) {
  return std::count(text.begin(), text.end(), '\n');
}

TEST_F(SimplifyVerb, WritesWhatTheExtensionSays) {
  auto const run = simplify({"square.svg", "-o", "clean.svg", "--picture", "look.png"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  EXPECT_EQ(simplify({"square.svg", "-o", "MASK.PNG"}).status, 0);
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"MASK.PNG", "clean.svg", "look.png", "square.svg"}));
  EXPECT_NE(folder_.read("clean.svg").find("<svg"), std::string::npos);
  EXPECT_TRUE(folder_.read("MASK.PNG").starts_with("\x89PNG"));
  EXPECT_TRUE(folder_.read("look.png").starts_with("\x89PNG"));
}

TEST_F(SimplifyVerb, MasksOfTheSameSketchAreTheSameBytes) {
  EXPECT_EQ(simplify({"square.svg", "-o", "a.png"}).status, 0);
  EXPECT_EQ(simplify({"-", "-o", "b.png"}, kSquare).status, 0);
  EXPECT_EQ(folder_.read("a.png"), folder_.read("b.png"));
}

TEST_F(SimplifyVerb, StandardOutputGetsTheDrawingAndNothingElse) {
  auto const run = simplify({"-", "-o", "-"}, kSquare);
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(run.out.starts_with("<"));
  EXPECT_TRUE(run.out.ends_with("</svg>\n"));
}

TEST_F(SimplifyVerb, JsonIsOneObjectWithTimes) {
  auto const run = simplify({"square.svg", "-o", "a.svg", "--json"});
  auto const report = nlohmann::json::parse(run.out);
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(report.at("layers").is_array());
  EXPECT_GE(report.at("ms").at("total").get<double>(), 0);
}

TEST_F(SimplifyVerb, BatchGoesOnAfterABadFile) {
  folder_.write("bad.svg", "<svg");
  auto const run = simplify({"bad.svg", "none.svg", "square.svg", "-o", "out/", "--json"});
  EXPECT_EQ(run.status, 4);  // the worst: none.svg cannot be read
  EXPECT_EQ(line_count(run.err), 2);
  EXPECT_NE(folder_.read("out/square.svg"), "");
  auto const files = nlohmann::json::parse(run.out).at("files");
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].at("error").at("code"), "bad_input");
  EXPECT_EQ(files[1].at("error").at("code"), "file_system");
  EXPECT_TRUE(files[2].contains("layers"));
}

TEST_F(SimplifyVerb, RefusedInputIsOneLineAndStatus3) {
  folder_.write("a.svg", "neither fish nor fowl");
  auto const run = simplify({"a.svg", "-o", "b.svg", "--json"});
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(run.err.starts_with("inkflate: a.svg: ")) << run.err;
  EXPECT_EQ(line_count(run.err), 1);
  EXPECT_EQ(nlohmann::json::parse(run.out).at("error").at("code"), "unsupported");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.svg", "square.svg"}));
}

TEST_F(SimplifyVerb, UnwritableOutputIsStatus4) {
  EXPECT_EQ(simplify({"square.svg", "-o", "no/such/folder.svg"}).status, 4);
  EXPECT_EQ(simplify({"square.svg", "-o", "square.svg/"}).status, 4);
}

TEST_F(SimplifyVerb, NamesThatLookLikeOptionsComeAfterTwoDashes) {
  folder_.write("-o", kSquare);
  EXPECT_EQ(simplify({"-o", "a.svg", "--", "-o"}).status, 0);
  EXPECT_NE(folder_.read("a.svg"), "");
}

TEST_F(SimplifyVerb, HostileNamesStayOneLineOnTheTerminal) {
  auto const run = simplify({"a\n\033[2Jb.svg", "-o", "c.svg"});
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(line_count(run.err), 1);
  EXPECT_EQ(run.err.find('\033'), std::string::npos);
}

TEST_F(SimplifyVerb, MarksAreGivenWithOrWithoutEqualsSign) {
  auto const run = simplify(
      {"--outside", "-5,3", "square.svg", "--outside=1,2", "--inside", "100,100", "-o", "a.svg"});
  EXPECT_EQ(run.status, 0) << run.err;
}

class WrongUsage : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(WrongUsage, IsStatus2AndOneLine) {
  ScratchFolder const folder;
  folder.write("square.svg", kSquare);
  auto const run = run_inkflate(folder.path(), GetParam());
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(line_count(run.err), 1) << run.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"square.svg"});
}

using Words = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(
    SimplifyVerb, WrongUsage,
    testing::Values(Words{}, Words{"simplfy"}, Words{"simplify"},
                    Words{"simplify", "square.svg"},                               // no output
                    Words{"simplify", "square.svg", "-o"},                         // no name
                    Words{"simplify", "square.svg", "-o", "a.obj"},                // no such format
                    Words{"simplify", "square.svg", "-o", "square.svg"},           // its own input
                    Words{"simplify", "square.svg", "square.svg", "-o", "a.svg"},  // no folder
                    Words{"simplify", "square.svg", "square.svg", "-o", "out/"},   // same name
                    Words{"simplify", "square.svg", "-o", "a.svg", "--gap", "0"},
                    Words{"simplify", "square.svg", "-o", "a.svg", "--gap", "wide"},
                    Words{"simplify", "square.svg", "-o", "a.svg", "--smooth", "1.5"},
                    Words{"simplify", "square.svg", "-o", "a.svg", "--size", "nan"},
                    Words{"simplify", "square.svg", "-o", "a.svg", "--size", "20000"},
                    Words{"simplify", "square.svg", "-o", "a.svg", "--outside", "5"},
                    Words{"simplify", "square.svg", "-o", "a.svg", "--method", "1"},
                    Words{"simplify", "square.svg", "-o", "a.svg", "--parts", "some"},
                    Words{"simplify", "square.svg", "-o", "a.svg", "--colour", "red"}));

TEST(Program, HelpAndVersionGoToStandardOutput) {
  for (Words const& words : {Words{"--help"}, Words{"simplify", "--help"}, Words{"--version"},
                             Words{"simplify", "--version"}}) {
    auto const run = run_inkflate("/", words);
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.out, "");
    EXPECT_EQ(run.err, "");
  }
}

TEST(Program, UsageErrorsAreJsonTooWhenAskedFor) {
  auto const run = run_inkflate("/", {"simplify", "--json", "--parts", "some"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(nlohmann::json::parse(run.out).at("error").at("code"), "bad_option");
}

}  // namespace
}  // namespace inkflate
