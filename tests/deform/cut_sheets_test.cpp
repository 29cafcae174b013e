// SPDX-License-Identifier: Apache-2.0
#include "deform/cut_sheets.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "geometry/crossings.h"
#include "support/bend_shapes.h"

namespace inkflate {
namespace {

Contour sampled(Contour const& corners, int per_side) {
  Contour contour;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (int k = 0; k < per_side; ++k) {
      contour.push_back(
          lerp(corners[i], corners[(i + 1) % corners.size()], static_cast<double>(k) / per_side));
    }
  }
  return contour;
}

double area_of(RimSheets const& sheets, std::vector<int> const& piece) {
  Contour contour;
  for (int const v : piece) contour.push_back(sheets.points[v]);
  EXPECT_TRUE(is_simple(contour));
  return signed_area(contour);
}

TEST(CutSheets, PiecesOfALimbOverItsBodyAreSimpleAndMakeUpItsArea) {
  auto const rim = sampled(support::folded_limb_corners(), 12);
  ASSERT_FALSE(is_simple(rim));
  auto const sheets = cut_into_sheets(rim, 8);
  ASSERT_TRUE(sheets.has_value());
  ASSERT_GE(sheets->pieces.size(), 2U);
  double sum = 0;
  double before = 0;
  for (auto const& piece : sheets->pieces) {
    double const area = area_of(*sheets, piece);
    EXPECT_GT(area, before);
    before = area;
    sum += area;
  }
  EXPECT_NEAR(sum, signed_area(rim), 1e-6);
}

TEST(CutSheets, EveryEdgeOfTheRimIsInOnePieceAndEveryOtherInTwo) {
  auto const rim = sampled(support::folded_limb_corners(), 12);
  auto const sheets = cut_into_sheets(rim, 8);
  ASSERT_TRUE(sheets.has_value());
  std::set<std::pair<int, int>> edges;
  for (auto const& piece : sheets->pieces) {
    for (std::size_t k = 0; k < piece.size(); ++k)
      EXPECT_TRUE(edges.insert({piece[k], piece[(k + 1) % piece.size()]}).second);
  }
  int const count = static_cast<int>(std::ssize(rim));
  for (auto const& [from, to] : edges) {
    bool const is_rim = from < count && to == (from + 1) % count;
    EXPECT_EQ(edges.count({to, from}), is_rim ? 0U : 1U) << from << " " << to;
  }
  for (int v = 0; v < count; ++v) EXPECT_EQ(edges.count({v, (v + 1) % count}), 1U);
}

TEST(CutSheets, ASharplyBentArmpitMayGoRoundMoreThanOnce) {
  // A limb that is bent about its own inner side: that turns over to a loop in the shape.
  auto const rim = sampled(
      {{0, 0}, {200, 0}, {200, 100}, {90, 100}, {90, 70}, {110, 70}, {110, 200}, {0, 200}}, 8);
  ASSERT_FALSE(is_simple(rim));
  auto const sheets = cut_into_sheets(rim, 8);
  ASSERT_TRUE(sheets.has_value());
  double sum = 0;
  for (auto const& piece : sheets->pieces) sum += area_of(*sheets, piece);
  EXPECT_NEAR(sum, signed_area(rim), 1e-6);
}

TEST(CutSheets, ASimpleRimIsOnePieceAsItIs) {
  Contour const rim = sampled({{0, 0}, {50, 0}, {50, 30}}, 5);
  auto const sheets = cut_into_sheets(rim, 8);
  ASSERT_TRUE(sheets.has_value());
  EXPECT_EQ(sheets->points, rim);
  EXPECT_EQ(sheets->pieces.size(), 1U);
}

TEST(CutSheets, RefusesWhatIsNoRimOfADisk) {
  EXPECT_FALSE(cut_into_sheets(sampled({{0, 0}, {100, 100}, {100, 0}, {0, 100}}, 8), 8));
  EXPECT_FALSE(cut_into_sheets(sampled({{0, 0}, {0, 50}, {50, 50}}, 8), 8));
  EXPECT_FALSE(cut_into_sheets({{0, 0}, {1, 1}}, 8));
  EXPECT_FALSE(cut_into_sheets({{0, 0}, {0, 0}, {0, 0}, {0, 0}}, 8));
  EXPECT_FALSE(cut_into_sheets({}, 8));
}

}  // namespace
}  // namespace inkflate
