// SPDX-License-Identifier: Apache-2.0
#include "geometry/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/rng.h"

namespace inkflate {
namespace {

// Whole numbers in which products of coordinates are exact.
__extension__ typedef __int128
    Wide;  // NOLINT(modernize-use-using): only a typedef can be an extension

int sign(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

int plain_sign(Vec2 a, Vec2 b, Vec2 c) { return sign(cross(b - a, c - a)); }

struct WholePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

int whole_sign(WholePoint a, WholePoint b, WholePoint c) {
  Wide const area = Wide{b.x - a.x} * (c.y - a.y) - Wide{b.y - a.y} * (c.x - a.x);
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

Vec2 scaled(WholePoint p, double scale) {
  return Vec2{static_cast<double>(p.x), static_cast<double>(p.y)} * scale;
}

TEST(Orientation, IsPositiveWhenTheAreaIs) {
  EXPECT_EQ(orientation_sign({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orientation_sign({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orientation_sign({0, 0}, {1, 1}, {3, 3}), 0);
  EXPECT_EQ(orientation_sign({7, 7}, {7, 7}, {1, 2}), 0);
}

TEST(Orientation, IsExactBesideADiagonal) {
  // Kettner et al. 2008, "Classroom examples of robustness problems": all points 0.5 + 2^-53 (i, j) beside the
  // line y = x, where the sign is that of j - i.
  int wrong_in_plain_numbers = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      Vec2 const p = {0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
      // Below 1, doubles are 2^-53 apart: p is exact.
      EXPECT_EQ(orientation_sign(p, {12, 12}, {24, 24}), sign(j - i)) << i << " " << j;
      wrong_in_plain_numbers += plain_sign(p, {12, 12}, {24, 24}) != sign(j - i) ? 1 : 0;
    }
  }
  EXPECT_GT(wrong_in_plain_numbers, 500);
}

TEST(Orientation, IsExactForNearlyCollinearPointsAndAntisymmetric) {
  Rng rng(3);
  std::int64_t const range = std::int64_t{1} << 50;
  auto const coordinate = [&] { return static_cast<std::int64_t>(rng.uniform(-1, 1) * range); };
  int wrong_in_plain_numbers = 0;
  for (int i = 0; i < 2000; ++i) {
    WholePoint const a = {coordinate(), coordinate()};
    WholePoint const b = {coordinate(), coordinate()};
    double const t = rng.uniform(-0.5, 1.5);
    WholePoint const c = {
        std::clamp(a.x + static_cast<std::int64_t>(t * static_cast<double>(b.x - a.x)), -range,
                   range) +
            rng.below(3) - 1,
        std::clamp(a.y + static_cast<std::int64_t>(t * static_cast<double>(b.y - a.y)), -range,
                   range) +
            rng.below(3) - 1};
    int const expected = whole_sign(a, b, c);
    double const scale = i % 2 == 0 ? 0x1p-40 : 0x1p300;
    Vec2 const p = scaled(a, scale);
    Vec2 const q = scaled(b, scale);
    Vec2 const r = scaled(c, scale);
    EXPECT_EQ(orientation_sign(p, q, r), expected);
    EXPECT_EQ(orientation_sign(q, r, p), expected);
    EXPECT_EQ(orientation_sign(q, p, r), -expected);
    wrong_in_plain_numbers += plain_sign(p, q, r) != expected ? 1 : 0;
  }
  EXPECT_GT(wrong_in_plain_numbers, 20);
}

TEST(Orientation, SeesASingleUnitOfTheLastPlace) {
  Vec2 const a = {0.1, 0.1};
  Vec2 const b = {0.3, 0.3};
  EXPECT_EQ(orientation_sign(a, b, {0.7, 0.7}), 0);
  EXPECT_EQ(orientation_sign(a, b, {0.7, std::nextafter(0.7, 1)}), 1);
  EXPECT_EQ(orientation_sign(a, b, {0.7, std::nextafter(0.7, 0)}), -1);
  // Of very unlike size.
  EXPECT_EQ(orientation_sign({1e-100, 1e-100}, {1e100, 1e100}, {1, 1}), 0);
  EXPECT_EQ(orientation_sign({1e-100, 0}, {1e100, 1e100}, {1, 1}), 1);
}

/// By the parameters of the meeting point, as fractions of whole numbers.
bool touch_by_fractions(WholePoint p, WholePoint p_end, WholePoint q, WholePoint q_end) {
  WholePoint const r = {p_end.x - p.x, p_end.y - p.y};
  WholePoint const s = {q_end.x - q.x, q_end.y - q.y};
  WholePoint const off = {q.x - p.x, q.y - p.y};
  auto const cross_of = [](WholePoint a, WholePoint b) { return a.x * b.y - a.y * b.x; };
  std::int64_t const denominator = cross_of(r, s);
  if (denominator != 0) {
    std::int64_t const flip = denominator < 0 ? -1 : 1;
    std::int64_t const t = flip * cross_of(off, s);
    std::int64_t const u = flip * cross_of(off, r);
    return t >= 0 && t <= flip * denominator && u >= 0 && u <= flip * denominator;
  }
  // Parallel: they must be on one line, and so must be their shadows on both axes.
  bool const on_one_line = cross_of(off, r) == 0 && cross_of(off, s) == 0 &&
                           cross_of(WholePoint{q_end.x - p.x, q_end.y - p.y}, r) == 0;
  auto const overlap = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return std::max(std::min(a, b), std::min(c, d)) <= std::min(std::max(a, b), std::max(c, d));
  };
  return on_one_line && overlap(p.x, p_end.x, q.x, q_end.x) && overlap(p.y, p_end.y, q.y, q_end.y);
}

TEST(SegmentsTouch, EqualsTheFractionsOnAllSegmentsOfASmallLattice) {
  auto const place = [](int i) { return WholePoint{i % 4, i / 4}; };
  for (int i = 0; i < 16 * 16 * 16 * 16; i += 3) {  // three and sixteen have no common factor
    auto const a = place(i % 16);
    auto const b = place(i / 16 % 16);
    auto const c = place(i / 256 % 16);
    auto const d = place(i / 4096);
    ASSERT_EQ(
        segments_touch(scaled(a, 0.125), scaled(b, 0.125), scaled(c, 0.125), scaled(d, 0.125)),
        touch_by_fractions(a, b, c, d))
        << i;
  }
}

TEST(SegmentsTouch, DoesNotDependOnOrder) {
  Rng rng(5);
  auto const point = [&] { return Vec2{rng.below(20) * 0.1, rng.below(20) * 0.1}; };
  for (int i = 0; i < 500; ++i) {
    auto const a = point();
    auto const b = point();
    auto const c = point();
    auto const d = point();
    bool const touch = segments_touch(a, b, c, d);
    EXPECT_EQ(segments_touch(b, a, c, d), touch);
    EXPECT_EQ(segments_touch(a, b, d, c), touch);
    EXPECT_EQ(segments_touch(c, d, a, b), touch);
  }
}

}  // namespace
}  // namespace inkflate
