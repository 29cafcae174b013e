// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "io/journal.h"

namespace inkflate {
namespace {

constexpr char const* kFigure =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200" fill="none" stroke="black">
<g id="body"><path d="M50 50H150V150H50Z"/></g></svg>
)";

class HashVerb : public testing::Test {
 protected:
  HashVerb() { folder_.write("figure.svg", kFigure); }

  ProgramRun run(std::vector<std::string> const& arguments, std::string const& input = "") const {
    return run_inkflate(folder_.path(), arguments, input);
  }

  /// The digits before the name.
  std::string hash(std::string const& name) const {
    auto const told = run({"hash", name});
    EXPECT_EQ(told.status, 0) << told.err;
    return told.out.substr(0, told.out.find("  " + name + "\n"));
  }

  ScratchFolder folder_;
};

TEST_F(HashVerb, PrintsALineForEachFile) {
  auto const told = run({"hash", "figure.svg", "-"}, kFigure);
  EXPECT_EQ(told.status, 0) << told.err;
  auto const digits = told.out.substr(0, 16);
  EXPECT_EQ(digits.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(told.out, digits + "  figure.svg\n" + digits + "  -\n");
}

TEST_F(HashVerb, FormatsThatHoldTheSameHaveTheSame) {
  EXPECT_EQ(run({"simplify", "figure.svg", "-o", "a.inkflate"}).status, 0);
  for (auto const* const name : {"b.svg", "c.zip"}) {
    EXPECT_EQ(run({"convert", "a.inkflate", "-o", name}).status, 0);
    EXPECT_EQ(hash(name), hash("a.inkflate"));
  }
  EXPECT_NE(hash("figure.svg"), hash("a.inkflate"));
}

TEST_F(HashVerb, AJournalHasThatOfItsLastDocument) {
  auto const stroke = AddStroke{Stroke{{{{10, 10}}, {{90, 10}}}, StrokeKind::Ink, 2, {}}};
  auto const journal = journal_start() + journal_line(JournalDo{{stroke}, 0});
  folder_.write("a.journal", journal);
  folder_.write("b.journal", journal + journal_line(JournalDo{{SetCanvas{500, 400}}, 0}) +
                                 journal_line(JournalUndo{}));
  EXPECT_EQ(hash("a.journal"), hash("b.journal"));
  EXPECT_EQ(run({"convert", "b.journal", "-o", "c.inkflate"}).status, 0);
  EXPECT_EQ(hash("c.inkflate"), hash("a.journal"));
  folder_.write("damaged.journal", journal + "lost\n" + journal);
  auto const told = run({"hash", "damaged.journal"});
  EXPECT_EQ(told.status, 0);
  EXPECT_NE(told.err.find("damaged line"), std::string::npos) << told.err;
}

TEST_F(HashVerb, AScanHasThatOfItsPixels) {
  EXPECT_EQ(run({"convert", "figure.svg", "-o", "a.png"}).status, 0);
  EXPECT_EQ(hash("a.png").size(), 16U);
  EXPECT_NE(hash("a.png"), hash("figure.svg"));
}

TEST_F(HashVerb, TellsInJson) {
  auto const told = run({"hash", "figure.svg", "none.svg", "--json"});
  EXPECT_EQ(told.status, 4);
  auto const files = nlohmann::json::parse(told.out).at("files");
  EXPECT_EQ(files.at(0).at("hash"), hash("figure.svg"));
  EXPECT_TRUE(files.at(1).contains("error"));
}

TEST_F(HashVerb, WritesNoFile) { EXPECT_EQ(run({"hash", "figure.svg", "-o", "a"}).status, 2); }

}  // namespace
}  // namespace inkflate
