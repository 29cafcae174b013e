// SPDX-License-Identifier: Apache-2.0
#include "pipeline/stage_clock.h"

#include <gtest/gtest.h>

#include <string>

namespace inkflate {
namespace {

TEST(StageClock, StagesKeepTheOrderInWhichTheyFirstRan) {
  StageClock clock;
  for (auto const* stage : {"split", "cut", "split", "fit"}) clock.start(stage);
  clock.stop();
  ASSERT_EQ(clock.times().size(), 3U);
  EXPECT_EQ(clock.times()[0].stage, "split");
  EXPECT_EQ(clock.times()[1].stage, "cut");
  EXPECT_EQ(clock.times()[2].stage, "fit");
  for (auto const& time : clock.times()) EXPECT_GE(time.ms, 0);
}

TEST(StageClock, ReportsAndCancellingReachTheCaller) {
  std::vector<std::string> reported;
  Progress const progress = {[&](std::string_view stage) { reported.emplace_back(stage); },
                             [&] { return reported.size() >= 2; }};
  StageClock clock;
  Progress const timed = clock.timed(progress);
  EXPECT_TRUE(timed.enter("first"));
  EXPECT_FALSE(timed.enter("second"));
  EXPECT_EQ(reported, (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(clock.times().size(), 2U);
}

}  // namespace
}  // namespace inkflate
