// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/picture_in.h"
#include "cli/program.h"
#include "support/golden.h"

namespace inkflate {
namespace {

struct Recorded {
  char const* name;
  std::vector<char const*> bendings = {};  // each leaves a picture
};

/// The walk-throughs of the thesis' chapter 6, by tests/tools/make_replays.py. Each leaves a picture of the drawing and one of the model,
/// and one of each bending.
class Replay : public testing::TestWithParam<Recorded> {};

TEST_P(Replay, LooksAsItWasApproved) {
  ScratchFolder const folder;
  std::string const name = GetParam().name;
  auto const path = std::string(INKFLATE_SOURCE_DIR) + "/tests/data/replay/" + name + ".jsonl";
  auto const run = run_inkflate(folder.path(), {"replay", path, "--quiet", "--files", "."});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  EXPECT_TRUE(matches_golden(picture_in(folder, "drawing.png"), "replay/" + name));
  EXPECT_TRUE(matches_golden(picture_in(folder, "model.png"), "replay/" + name + "_model"));
  for (std::string const bending : GetParam().bendings) {
    EXPECT_TRUE(
        matches_golden(picture_in(folder, bending + ".png"), "replay/" + name + "_" + bending));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Thesis, Replay,
    testing::Values(Recorded{"mouse", {"bent"}}, Recorded{"alligator", {"bent"}},
                    Recorded{"dove", {"bent"}}, Recorded{"seahorse", {"bent"}},
                    Recorded{"crab", {"bent"}}, Recorded{"butterfly"},
                    Recorded{"octopus", {"bent"}}, Recorded{"half_torus"}, Recorded{"torus"},
                    Recorded{"giraffe", {"one_place_whole", "one_place", "drinks", "steps"}},
                    Recorded{"monster", {"one_place", "tail_and_hands", "arms"}},
                    Recorded{"letter_s", {"bent", "wide"}},
                    Recorded{"person", {"fat", "legs", "limbs"}}),
    [](auto const& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace inkflate
