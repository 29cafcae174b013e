// SPDX-License-Identifier: Apache-2.0
#include "geometry/trig.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

// pi/2 in three pieces; the first two have 33 bits, so their products with a quarter count below 2^20 are exact
// (reduction of Cody and Waite).
constexpr double kHalfPiHigh = 0x1.921fb544p0;
constexpr double kHalfPiMiddle = 0x1.0b4611a6p-34;
constexpr double kHalfPiLow = 0x1.3198a2e037073p-69;
constexpr double kLargestAngle = 1e6;

// Taylor series in nested form; on |r| <= pi/4 the first term left out is below 1e-18.
double sine_near_zero(double r) {
  double const square = r * r;
  double nested = 1;
  for (int n = 16; n >= 2; n -= 2) nested = 1 - square / (n * (n + 1)) * nested;
  return r * nested;
}

double cosine_near_zero(double r) {
  double const square = r * r;
  double nested = 1;
  for (int n = 17; n >= 1; n -= 2) nested = 1 - square / (n * (n + 1)) * nested;
  return nested;
}

// 0 <= t <= 1. Two halvings of the angle bring t below 0.2, where Gregory's series is short.
double arctangent(double t) {
  double const half = t / (1 + std::sqrt(1 + t * t));
  double const quarter = half / (1 + std::sqrt(1 + half * half));
  double const square = quarter * quarter;
  double sum = 0;
  for (int n = 27; n >= 1; n -= 2) sum = 1.0 / n - square * sum;
  return 4 * quarter * sum;
}

}  // namespace

SinCos sin_cos(double angle_rad) {
  if (!(std::abs(angle_rad) <= kLargestAngle)) return {};
  double const quarters = std::floor(angle_rad * (2 / kPi) + 0.5);
  double const r =
      ((angle_rad - quarters * kHalfPiHigh) - quarters * kHalfPiMiddle) - quarters * kHalfPiLow;
  double const s = sine_near_zero(r);
  double const c = cosine_near_zero(r);
  switch (static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double atan2_of(double y, double x) {
  double const width = std::abs(x);
  double const height = std::abs(y);
  if (width == 0 && height == 0) return 0;
  double angle =
      height <= width ? arctangent(height / width) : kPi / 2 - arctangent(width / height);
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}

double acos_of(double cosine) {
  double const c = std::clamp(cosine, -1.0, 1.0);
  return atan2_of(std::sqrt((1 - c) * (1 + c)), c);
}

}  // namespace inkflate
