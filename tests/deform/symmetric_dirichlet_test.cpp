// SPDX-License-Identifier: Apache-2.0
#include "deform/symmetric_dirichlet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rng.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

constexpr std::array<Vec2, 3> kRest = {Vec2{3, 4}, Vec2{15, 6}, Vec2{7, 17}};
constexpr double kStiffness = 0.7;

std::array<Vec2, 3> mapped(Vec2 x_axis, Vec2 y_axis) {
  auto places = kRest;
  for (auto& p : places) p = x_axis * p.x + y_axis * p.y;
  return places;
}

double rest_area() { return cross(kRest[1] - kRest[0], kRest[2] - kRest[0]) / 2; }

/// The triangle with its corners moved at random, so that some are pressed together and some drawn out; none turned over.
std::array<Vec2, 3> random_places(Rng& rng) {
  for (;;) {
    auto places = kRest;
    for (auto& p : places) p += {rng.uniform(-9, 9), rng.uniform(-9, 9)};
    if (cross(places[1] - places[0], places[2] - places[0]) > 20) return places;
  }
}

std::array<Vec2, 3> nudged(std::array<Vec2, 3> places, int number, double by) {
  (number % 2 == 0 ? places[number / 2].x : places[number / 2].y) += by;
  return places;
}

double coordinate(Vec2 v, int number) { return number % 2 == 0 ? v.x : v.y; }

TEST(SymmetricDirichlet, IsZeroUnderTurnsAndShifts) {
  auto const rest = rest_triangle(kRest, kStiffness);
  EXPECT_EQ(dirichlet_energy(rest, kRest), 0);
  auto const turn = sin_cos(1.3);
  auto places = mapped({turn.cos, turn.sin}, {-turn.sin, turn.cos});
  for (auto& p : places) p += {500, -200};
  EXPECT_NEAR(dirichlet_energy(rest, places), 0, 1e-20);
}

TEST(SymmetricDirichlet, IsTheSumOfSquaresOfAMapAndItsInverse) {
  Vec2 const x = {1.4, 0.3};
  Vec2 const y = {-0.2, 0.6};
  double const squares = squared_norm(x) + squared_norm(y);
  double const expected =
      kStiffness * rest_area() * (squares * (1 + 1 / std::pow(cross(x, y), 2)) - 4);
  EXPECT_NEAR(dirichlet_energy(rest_triangle(kRest, kStiffness), mapped(x, y)), expected,
              1e-12 * expected);
}

TEST(SymmetricDirichlet, DoesNotKnowWhatIsAMapAndWhatItsInverse) {
  auto const rest = rest_triangle(kRest, kStiffness);
  EXPECT_NEAR(dirichlet_energy(rest, mapped({2, 0}, {0, 3})),
              dirichlet_energy(rest, mapped({0.5, 0}, {0, 1.0 / 3})), 1e-10);
}

TEST(SymmetricDirichlet, IsTheSameForADrawingOfAnySizeButForItsArea) {
  auto const places = mapped({1.2, 0.4}, {0.1, 0.8});
  double const energy = dirichlet_energy(rest_triangle(kRest, 1), places);
  auto larger_rest = kRest;
  auto larger_places = places;
  for (auto& p : larger_rest) p *= 100;
  for (auto& p : larger_places) p *= 100;
  EXPECT_NEAR(dirichlet_energy(rest_triangle(larger_rest, 1), larger_places), 1e4 * energy,
              1e-8 * energy);
}

TEST(SymmetricDirichlet, IsInfiniteForWhatHasNoAreaOrIsTurnedOver) {
  auto const rest = rest_triangle(kRest, kStiffness);
  EXPECT_TRUE(std::isinf(dirichlet_energy(rest, {kRest[1], kRest[0], kRest[2]})));
  EXPECT_TRUE(std::isinf(dirichlet_energy(rest, {kRest[0], kRest[0], kRest[0]})));
}

TEST(SymmetricDirichlet, GradientIsTheDifferenceOfEnergies) {
  Rng rng(1);
  auto const rest = rest_triangle(kRest, kStiffness);
  for (int k = 0; k < 100; ++k) {
    auto const places = random_places(rng);
    auto const model = dirichlet_model(rest, places);
    for (int i = 0; i < 6; ++i) {
      constexpr double step = 1e-5;
      double const difference = (dirichlet_energy(rest, nudged(places, i, step)) -
                                 dirichlet_energy(rest, nudged(places, i, -step))) /
                                (2 * step);
      EXPECT_NEAR(coordinate(model.gradient(i / 2), i), difference,
                  1e-6 * (1 + std::abs(difference)));
    }
  }
}

TEST(SymmetricDirichlet, HessianIsTheDifferenceOfGradients) {
  Rng rng(2);
  auto const rest = rest_triangle(kRest, kStiffness);
  for (int k = 0; k < 100; ++k) {
    auto const places = random_places(rng);
    auto const model = dirichlet_model(rest, places);
    for (int i = 0; i < 6; ++i) {
      constexpr double step = 1e-5;
      auto const above = dirichlet_model(rest, nudged(places, i, step));
      auto const below = dirichlet_model(rest, nudged(places, i, -step));
      for (int j = 0; j < 6; ++j) {
        double hessian = 0;
        for (int d = 0; d < 4; ++d) {
          hessian += model.curvatures[d] * coordinate(model.rows[d][i / 2], i) *
                     coordinate(model.rows[d][j / 2], j);
        }
        double const difference =
            coordinate(above.gradient(j / 2) - below.gradient(j / 2), j) / (2 * step);
        EXPECT_NEAR(hessian, difference, 1e-6 * (1 + std::abs(difference)));
      }
    }
  }
}

TEST(SymmetricDirichlet, OnlyTurningCanHaveANegativeCurvature) {
  Rng rng(3);
  auto const rest = rest_triangle(kRest, kStiffness);
  int negative = 0;
  for (int k = 0; k < 1000; ++k) {
    auto const model = dirichlet_model(rest, random_places(rng));
    for (int const d : {0, 1, 3}) EXPECT_GT(model.curvatures[d], 0);
    if (model.curvatures[2] < 0) ++negative;
  }
  EXPECT_GT(negative, 100);
}

TEST(SymmetricDirichlet, DirectionsAreOrthogonalMapsOfLengthOne) {
  Rng rng(4);
  auto const rest = rest_triangle(kRest, kStiffness);
  auto const model = dirichlet_model(rest, random_places(rng));
  // Moves that make the map grow by one unit matrix each: the direction's share is its component.
  for (int d = 0; d < 4; ++d) {
    for (int e = 0; e < 4; ++e) {
      double sum = 0;
      for (int unit = 0; unit < 4; ++unit) {
        auto const component = [&](int direction) {
          double share = 0;
          for (int i = 0; i < 3; ++i) {
            double const along = unit / 2 == 0 ? kRest[i].x : kRest[i].y;
            share += along * coordinate(model.rows[direction][i], unit % 2);
          }
          return share;
        };
        sum += component(d) * component(e);
      }
      EXPECT_NEAR(sum, d == e ? 1 : 0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace inkflate
