// SPDX-License-Identifier: Apache-2.0
#include "simplify/rim_chains.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/rng.h"
#include "geometry/trig.h"
#include "support/rims.h"

namespace inkflate {
namespace {

Contour const kSquare = {{100, 100}, {500, 100}, {500, 500}, {100, 500}};

Contour circle(double radius) {
  Contour contour;
  int const count = static_cast<int>(2 * kPi * radius / 2.2);
  for (int i = 0; i < count; ++i) {
    auto const [sine, cosine] = sin_cos(2 * kPi * i / count);
    contour.push_back(Vec2{500, 500} + Vec2{cosine, sine} * radius);
  }
  return contour;
}

/// Ink, but for the points of a side within [from, to) of its start.
struct Stretch {
  double from_px;
  double to_px;
  RunKind kind;
};

std::vector<RimChain> chains_of(Contour const& contour,
                                std::vector<Stretch> const& stretches = {}) {
  std::vector<RunKind> kinds(contour.size(), RunKind::Ink);
  double along_px = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    for (auto const& stretch : stretches) {
      if (along_px >= stretch.from_px && along_px < stretch.to_px) kinds[i] = stretch.kind;
    }
    along_px += distance(contour[i], contour[(i + 1) % contour.size()]);
  }
  HandMadeRims made;
  made.add(contour, kinds);
  auto const chains = cut_rim(made.rims[0], made.contour(0));
  int covered = 0;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    auto const& next = chains[(i + 1) % chains.size()];
    EXPECT_GT(chains[i].size, 0);
    EXPECT_EQ((chains[i].first + chains[i].size) % std::ssize(contour), next.first);
    covered += chains[i].size;
  }
  EXPECT_EQ(covered, std::ssize(contour));
  return chains;
}

int count_kind(std::vector<RimChain> const& chains, RunKind kind) {
  return static_cast<int>(std::count_if(chains.begin(), chains.end(),
                                        [&](RimChain const& chain) { return chain.kind == kind; }));
}

TEST(CutRim, ASquareHasFourSides) {
  auto const contour = resampled(kSquare);
  auto const chains = chains_of(contour);
  ASSERT_EQ(chains.size(), 4U);
  for (auto const& chain : chains) {
    double nearest = 1e9;
    for (auto const corner : kSquare)
      nearest = std::min(nearest, distance(corner, contour[chain.first]));
    EXPECT_LT(nearest, 0.1);
  }
}

TEST(CutRim, ACircleIsOneRing) {
  for (double const radius : {40.0, 150.0, 480.0}) {
    auto const chains = chains_of(circle(radius));
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_TRUE(chains[0].is_ring);
  }
}

TEST(CutRim, ADropIsOneChainFromItsCorner) {
  // Three quarters of a circle, and the two tangents at its ends.
  Contour drop;
  for (int i = 0; i <= 300; ++i) {
    auto const [sine, cosine] = sin_cos(kPi / 2 + 1.5 * kPi * i / 300);
    drop.push_back(Vec2{500, 500} + Vec2{cosine, sine} * 200);
  }
  drop.push_back({700, 700});
  auto const contour = resampled(drop);
  auto const chains = chains_of(contour);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_FALSE(chains[0].is_ring);
  EXPECT_LT(distance(contour[chains[0].first], Vec2{700, 700}), 0.1);
}

TEST(CutRim, LongClosingsAndHelpLinesAreChainsOfTheirOwn) {
  auto const contour = resampled(kSquare);
  for (auto const kind : {RunKind::Closing, RunKind::HelpLine}) {
    auto const chains = chains_of(contour, {{100, 200, kind}});
    EXPECT_EQ(chains.size(), 6U);
    EXPECT_EQ(count_kind(chains, kind), 1);
    auto const ring = chains_of(circle(300), {{100, 200, kind}});
    EXPECT_EQ(ring.size(), 2U);
    EXPECT_FALSE(ring[0].is_ring);
  }
}

TEST(CutRim, RunsShorterThanALineIsWideGiveWay) {
  auto const contour = resampled(kSquare);
  EXPECT_EQ(chains_of(contour, {{100, 104, RunKind::Closing}}).size(), 4U);
  EXPECT_EQ(chains_of(contour, {{100, 104, RunKind::HelpLine}}).size(), 4U);
  auto const speck = chains_of(contour, {{100, 200, RunKind::Closing}, {150, 154, RunKind::Ink}});
  EXPECT_EQ(speck.size(), 6U);
  EXPECT_EQ(count_kind(speck, RunKind::Closing), 1);
}

TEST(CutRim, AShortGapBesideAHelpLineBecomesInk) {
  auto const chains =
      chains_of(resampled(kSquare), {{100, 104, RunKind::Closing}, {104, 200, RunKind::HelpLine}});
  EXPECT_EQ(chains.size(), 6U);
  EXPECT_EQ(count_kind(chains, RunKind::Closing), 0);
}

TEST(CutRim, CoversAnyRimInOrder) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Contour contour(static_cast<std::size_t>(3 + rng.below(60)));
    double const size_px = rng.below(2) == 0 ? 20 : 600;
    for (auto& p : contour) p = {rng.uniform(0, size_px), rng.uniform(0, size_px)};
    std::vector<Stretch> stretches;
    for (int i = 0; i < 12; ++i) {
      double const from_px = rng.uniform(0, 3000);
      stretches.push_back(
          {from_px, from_px + rng.uniform(0, 400), static_cast<RunKind>(rng.below(3))});
    }
    chains_of(contour, stretches);
  }
}

}  // namespace
}  // namespace inkflate
