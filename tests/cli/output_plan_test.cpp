// SPDX-License-Identifier: Apache-2.0
#include "cli/output_plan.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "cli/program.h"

namespace inkflate::cli {
namespace {

using Paths = std::vector<std::string>;

TEST(OutputPlan, OneInputGoesToTheNamedFile) {
  EXPECT_EQ(*plan_outputs({"a.svg"}, {"-o", "b.png", ".svg"}), Paths{"b.png"});
}

TEST(OutputPlan, FolderTakesTheNamesOfTheInputs) {
  auto const outputs = plan_outputs({"x/a.scap", "b.svg", "-"}, {"-o", "out/", ".svg"});
  EXPECT_EQ(*outputs, (Paths{"out/a.svg", "out/b.svg", "out/standard-input.svg"}));
}

TEST(OutputPlan, FolderThatExistsNeedsNoSlash) {
  ScratchFolder const folder;
  EXPECT_EQ(*plan_outputs({"a.svg"}, {"-o", folder.path(), ".png"}), Paths{folder / "a.png"});
}

TEST(OutputPlan, SeveralInputsNeedAFolder) {
  auto const outputs = plan_outputs({"a.svg", "b.svg"}, {"-o", "c.svg", ".svg"});
  ASSERT_FALSE(outputs.has_value());
  EXPECT_EQ(outputs.error().code, ErrorCode::BadOption);
}

TEST(OutputPlan, NoNameMeansNoOutput) {
  EXPECT_EQ(*plan_outputs({"a.svg"}, {"-o", "", ".svg"}), Paths{""});
}

TEST(OutputPlan, SameOutputTwiceIsACollision) {
  EXPECT_TRUE(find_collision({"x/a.svg", "y/a.scap"}, {"out/a.svg", "out/./a.svg"}));
  EXPECT_FALSE(find_collision({"x/a.svg", "y/b.svg"}, {"out/a.svg", "out/b.svg"}));
}

TEST(OutputPlan, InputIsNeverAnOutputUnderAnyName) {
  ScratchFolder const folder;
  folder.write("real.svg", "");
  std::filesystem::create_symlink("real.svg", folder / "link.svg");
  EXPECT_TRUE(find_collision({folder / "real.svg"}, {folder / "./real.svg"}));
  EXPECT_TRUE(find_collision({folder / "link.svg"}, {folder / "real.svg"}));
  EXPECT_TRUE(find_collision({folder / "link.svg"}, {folder / "link.svg"}));
}

TEST(OutputPlan, StandardStreamsNeverCollide) { EXPECT_FALSE(find_collision({"-"}, {"-"})); }

}  // namespace
}  // namespace inkflate::cli
