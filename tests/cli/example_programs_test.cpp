// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/picture_in.h"

namespace inkflate {
namespace {

std::string example(std::string const& name) {
  return std::string(INKFLATE_SOURCE_DIR) + "/examples/sketches/" + name;
}

ProgramRun run_example(std::string const& program, ScratchFolder const& folder,
                       std::vector<std::string> const& arguments) {
  return run_program(std::string(INKFLATE_EXAMPLES) + "/" + program, folder.path(), arguments);
}

double share_of(Picture const& picture, Colour colour) {
  auto const count = std::count(picture.values.begin(), picture.values.end(), colour);
  return static_cast<double>(count) / static_cast<double>(picture.values.size());
}

TEST(ExamplePrograms, SegmentSketchFillsWhatStrokesEnclose) {
  ScratchFolder const folder;
  auto const run = run_example("segment_sketch", folder, {example("vase.svg"), "mask.png"});
  ASSERT_EQ(run.status, 0) << run.err;
  auto const mask = picture_in(folder, "mask.png");
  EXPECT_EQ(mask.width, 512);
  double const inside = share_of(mask, {255, 255, 255});
  EXPECT_GT(inside, 0.2);
  EXPECT_LT(inside, 0.7);
  EXPECT_NEAR(inside + share_of(mask, {0, 0, 0}), 1, 1e-12);
}

TEST(ExamplePrograms, BendStripDrawsBeforeAndAfter) {
  ScratchFolder const folder;
  for (auto const& arguments : {std::vector<std::string>{"strip.png"},
                                std::vector<std::string>{"strip.png", example("goose.svg")}}) {
    auto const run = run_example("bend_strip", folder, arguments);
    ASSERT_EQ(run.status, 0) << run.err;
    auto const picture = picture_in(folder, "strip.png");
    EXPECT_GT(share_of(picture, {190, 190, 190}), 0.0001);
    EXPECT_GT(share_of(picture, {20, 20, 20}), 0.0001);
    EXPECT_GT(share_of(picture, {220, 40, 30}), 0.0001);
  }
}

TEST(ExamplePrograms, TellWhatIsWrong) {
  ScratchFolder const folder;
  EXPECT_EQ(run_example("bend_strip", folder, {}).status, 1);
  EXPECT_EQ(run_example("bend_strip", folder, {"a.png", "missing.svg"}).status, 1);
  EXPECT_EQ(run_example("segment_sketch", folder, {"missing.svg", "a.png"}).status, 1);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace inkflate
