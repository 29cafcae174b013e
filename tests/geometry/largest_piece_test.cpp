// SPDX-License-Identifier: Apache-2.0
#include "geometry/largest_piece.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace inkflate {
namespace {

TaggedContour square(double left, double top, double side) {
  return {{{left, top}, {left + side, top}, {left + side, top + side}, {left, top + side}},
          {1, 2, 3, 4}};
}

TaggedContour hole(double left, double top, double side) {
  auto contour = square(left, top, side);
  std::reverse(contour.points.begin(), contour.points.end());
  return contour;
}

std::vector<Contour> points_of(std::vector<TaggedContour> const& contours) {
  std::vector<Contour> points;
  for (auto const& contour : contours) points.push_back(contour.points);
  return points;
}

TEST(LargestPiece, OfNothingIsNothing) {
  EXPECT_TRUE(largest_piece({}).empty());
  EXPECT_TRUE(largest_piece({hole(0, 0, 8)}).empty());
}

TEST(LargestPiece, IsTheLargestOuterContourWithItsTags) {
  auto const piece = largest_piece({square(0, 0, 4), square(10, 0, 8), square(20, 0, 6)});
  ASSERT_EQ(piece.size(), 1U);
  EXPECT_EQ(piece[0].points, square(10, 0, 8).points);
  EXPECT_EQ(piece[0].tags, (std::vector<int>{1, 2, 3, 4}));
}

TEST(LargestPiece, HasItsOwnHolesAndNotThoseOfIslandsInThem) {
  auto const piece = largest_piece({square(0, 0, 8), hole(2, 2, 4), square(20, 0, 12),
                                    hole(22, 2, 8), square(24, 4, 4), hole(25, 5, 2)});
  EXPECT_EQ(points_of(piece), points_of({square(20, 0, 12), hole(22, 2, 8)}));
}

TEST(LargestPiece, HasEveryHoleOfARow) {
  std::vector<TaggedContour> contours = {square(0, 0, 100)};
  for (int i = 0; i < 9; ++i) contours.push_back(hole(5 + 10 * i, 40 + i, 6));
  std::reverse(contours.begin(), contours.end());
  EXPECT_EQ(largest_piece(contours).size(), 10U);
}

}  // namespace
}  // namespace inkflate
