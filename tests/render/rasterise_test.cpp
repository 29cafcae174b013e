// SPDX-License-Identifier: Apache-2.0
#include "render/rasterise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "base/rng.h"
#include "render/fill_coverage.h"

namespace inkflate {
namespace {

constexpr Colour kWhite = {255, 255, 255};
constexpr Colour kBlack = {0, 0, 0};

Contour regular_polygon(Vec2 centre, double radius_px, int count) {
  Contour contour;
  for (int i = 0; i < count; ++i) {
    double const angle_rad = 2 * M_PI * i / count;
    contour.push_back(centre + radius_px * Vec2{std::cos(angle_rad), std::sin(angle_rad)});
  }
  return contour;
}

double coverage_sum(std::vector<Contour> const& contours, int width, int height) {
  Grid2<double> shares(width, height);
  cover_fill(contours, 0, 0, shares);
  double sum = 0;
  for (double const share : shares.values) sum += share;
  return sum;
}

/// Ink of a black-on-white picture in pixels.
double darkness(Picture const& picture) {
  double sum = 0;
  for (auto const pixel : picture.values) sum += (255 - pixel.r) / 255.0;
  return sum;
}

TEST(Rasterise, CoverageOfAPolygonIsItsArea) {
  auto const disc = regular_polygon({50.3, 49.8}, 40, 400);
  EXPECT_NEAR(coverage_sum({disc}, 100, 100), signed_area(disc), 1e-9);
  EXPECT_NEAR(coverage_sum({disc}, 100, 100), M_PI * 1600, 0.001 * M_PI * 1600);
}

TEST(Rasterise, CoverageOfRandomTrianglesIsTheirArea) {
  Rng rng(7);
  for (int i = 0; i < 300; ++i) {
    Contour triangle;
    for (int k = 0; k < 3; ++k) triangle.push_back({rng.uniform(0, 30), rng.uniform(0, 30)});
    EXPECT_NEAR(coverage_sum({triangle}, 30, 30), std::abs(signed_area(triangle)), 1e-9);
  }
}

TEST(Rasterise, PartsOutsideThePictureAreCutOff) {
  Contour const square = {{-1e6, -1e6}, {10.5, -1e6}, {10.5, 20.25}, {-1e6, 20.25}};
  EXPECT_NEAR(coverage_sum({square}, 40, 40), 10.5 * 20.25, 1e-6);
  Contour const around = {{-50, -50}, {90, -50}, {90, 90}, {-50, 90}};
  EXPECT_NEAR(coverage_sum({around}, 40, 40), 1600, 1e-9);
}

TEST(Rasterise, HolesRunBackwardsAndStayEmpty) {
  auto const outer = regular_polygon({50, 50}, 40, 200);
  auto const inner = regular_polygon({50, 50}, 20, 200);
  double const expected = signed_area(outer) - signed_area(inner);
  EXPECT_NEAR(coverage_sum({outer, Contour(inner.rbegin(), inner.rend())}, 100, 100), expected,
              1e-9);
}

TEST(Rasterise, WhereAnAreaLiesOverItselfItStaysFull) {
  auto const disc = regular_polygon({50, 50}, 40, 200);
  auto const inner = regular_polygon({50, 50}, 20, 200);
  EXPECT_NEAR(coverage_sum({disc, inner}, 100, 100), signed_area(disc), 1e-9);
  EXPECT_NEAR(coverage_sum({Contour(disc.rbegin(), disc.rend())}, 100, 100), signed_area(disc),
              1e-9);
}

TEST(Rasterise, AFilledDiscHasItsAreaInInk) {
  auto const picture =
      rasterise({FilledPath{{regular_polygon({150, 150}, 120, 720)}, kBlack}}, 300, 300, kWhite);
  EXPECT_NEAR(darkness(picture), M_PI * 14400, 0.001 * M_PI * 14400);
}

TEST(Rasterise, AStrokeHasItsAreaInInk) {
  StrokedPolyline const line = {{{20.2, 30.7}, {170.4, 120.1}}, {8}, {}, kBlack};
  double const area = 8 * distance(line.points[0], line.points[1]) + M_PI * 16;
  EXPECT_NEAR(darkness(rasterise({line}, 200, 200, kWhite)), area, 0.01 * area);
}

TEST(Rasterise, AWidthBelowAPixelIsPaler) {
  StrokedPolyline const line = {{{10, 20.5}, {110, 20.5}}, {0.25}, {}, kBlack};
  EXPECT_NEAR(darkness(rasterise({line}, 120, 40, kWhite)), 25, 0.5);
}

TEST(Rasterise, ATranslucentLineCoversItsCrossingsOnce) {
  StrokedPolyline const line = {{{5, 5}, {35, 35}, {35, 5}, {5, 35}}, {4}, {}, {0, 0, 0, 128}};
  auto const picture = rasterise({line}, 40, 40, kWhite);
  EXPECT_EQ(picture.at(20, 20), picture.at(35, 20));
}

TEST(Rasterise, DashesCoverTheirShareOfTheLine) {
  StrokedPolyline line = {{{50, 20}, {250, 20}, {250, 220}}, {0.5}, {6, 14}, kBlack};
  double const dashed = darkness(rasterise({line}, 300, 300, kWhite));
  line.dashes_px.clear();
  double const solid = darkness(rasterise({line}, 300, 300, kWhite));
  // The round ends of 20 dashes add a little.
  EXPECT_NEAR(dashed / solid, 0.3, 0.02);
}

TEST(Rasterise, DashesOfLengthZeroAreDots) {
  StrokedPolyline const line = {{{10, 10}, {99, 10}}, {4}, {0, 10}, kBlack};
  Dots dots = {{}, 4, kBlack};
  for (int i = 0; i < 9; ++i) dots.centres.push_back({10.0 + 10 * i, 10});
  EXPECT_EQ(rasterise({line}, 120, 20, kWhite), rasterise({dots}, 120, 20, kWhite));
}

TEST(Rasterise, TransparentPaperKeepsStraightAlpha) {
  FilledPath const half = {{{{0, 0}, {1.5, 0}, {1.5, 1}, {0, 1}}}, {200, 100, 50, 255}};
  auto const picture = rasterise({half}, 3, 1, {0, 0, 0, 0});
  EXPECT_EQ(picture.at(0, 0), (Colour{200, 100, 50, 255}));
  EXPECT_EQ(picture.at(1, 0), (Colour{200, 100, 50, 128}));
  EXPECT_EQ(picture.at(2, 0), (Colour{0, 0, 0, 0}));
}

TEST(Rasterise, PlacingAListMovesItsPicture) {
  DrawList const list = {StrokedPolyline{{{5, 5}, {15, 9}}, {3}, {}, kBlack},
                         FilledPath{{{{2, 12}, {9, 12}, {9, 18}}}, {90, 20, 30, 200}}};
  auto const still = rasterise(list, 60, 60, kWhite);
  auto const moved = rasterise(place(list, Affine::translation({20, 30})), 60, 60, kWhite);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) ASSERT_EQ(still.at(x, y), moved.at(x + 20, y + 30));
  }
}

TEST(Rasterise, WidthFollowsTheVertices) {
  StrokedPolyline const line = {{{20, 50}, {180, 50}}, {4, 20}, {}, kBlack};
  auto const picture = rasterise({line}, 200, 100, kWhite);
  EXPECT_EQ(picture.at(170, 57), kBlack);
  EXPECT_EQ(picture.at(30, 57), kWhite);
}

TEST(Rasterise, WidthsStayWithinTheirLimitsWhereverTheListIsPlaced) {
  StrokedPolyline const line = {{{20, 50}, {180, 50}}, {4}, {}, kBlack, {2, 8}};
  auto const ink = [&](double scale) {
    auto const map = Affine{1, 0, 0, scale, 0, 50 - 50 * scale};
    auto placed = place({line}, map);
    std::get<StrokedPolyline>(placed[0]).widths_px = {4 * scale};
    return darkness(rasterise(placed, 200, 100, kWhite)) / 160;
  };
  EXPECT_NEAR(ink(1), 4, 0.2);
  EXPECT_NEAR(ink(0.01), 2, 0.2);
  EXPECT_NEAR(ink(100), 8, 0.5);
}

TEST(Rasterise, DashesFollowAWidthThatIsLimited) {
  StrokedPolyline line = {{{10, 10}, {99, 10}}, {4}, {0, 10}, kBlack};
  auto const dots = rasterise({line}, 120, 20, kWhite);
  line.widths_px = {1};
  line.dashes_px = {0, 2.5};
  line.limits.least_px = 4;
  EXPECT_EQ(rasterise({line}, 120, 20, kWhite), dots);
}

TEST(Rasterise, APictureInItsPlaceIsThePicture) {
  auto const picture = std::make_shared<Picture const>(rasterise(
      {FilledPath{{{{2, 12}, {9, 12}, {9, 18}}}, {90, 20, 30, 200}}}, 20, 20, {0, 0, 0, 0}));
  DrawnPicture drawn = {picture, {}, 1};
  EXPECT_EQ(rasterise({drawn}, 20, 20, {0, 0, 0, 0}), *picture);
  auto const moved = rasterise(place({drawn}, Affine::translation({30, 5})), 60, 30, kWhite);
  EXPECT_EQ(moved.at(38, 18), rasterise({drawn}, 20, 20, kWhite).at(8, 13));
  drawn.opacity = 0;
  EXPECT_EQ(rasterise({drawn}, 20, 20, kWhite), Picture(20, 20, kWhite));
}

TEST(Rasterise, APictureCoversItsAreaHoweverItIsTurned) {
  auto const picture = std::make_shared<Picture const>(40, 20, kBlack);
  Affine const map = {1.2, 0.9, -0.9, 1.2, 60, 20};
  double const area = 800 * map.determinant();
  EXPECT_NEAR(darkness(rasterise({DrawnPicture{picture, map, 1}}, 150, 120, kWhite)), area,
              0.02 * area);
}

TEST(Rasterise, APictureWithoutAreaIsNotDrawn) {
  auto const picture = std::make_shared<Picture const>(4, 4, kBlack);
  double const nan = std::numeric_limits<double>::quiet_NaN();
  DrawList const list = {DrawnPicture{nullptr, {}, 1},
                         DrawnPicture{std::make_shared<Picture const>(), {}, 1},
                         DrawnPicture{picture, Affine::scaling(0, 1), 1},
                         DrawnPicture{picture, Affine::scaling(nan, 1), 1},
                         DrawnPicture{picture, Affine::translation({1e9, 0}), 1}};
  EXPECT_EQ(rasterise(list, 9, 9, kWhite), Picture(9, 9, kWhite));
}

}  // namespace
}  // namespace inkflate
