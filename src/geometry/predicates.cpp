// SPDX-License-Identifier: Apache-2.0
#include "geometry/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace inkflate {
namespace {

/// high + low is exactly the sum or the product that it stands for.
struct Exact {
  double high;
  double low;
};

Exact two_sum(double a, double b) {
  double const sum = a + b;
  double const b_part = sum - a;
  double const a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

Exact split(double a) {
  double const c = 134217729.0 * a;  // 2^27 + 1: cuts the 53 bits in two halves
  double const high = c - (c - a);
  return {high, a - high};
}

Exact two_product(double a, double b) {
  double const product = a * b;
  auto const [ah, al] = split(a);
  auto const [bh, bl] = split(b);
  return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
}

/// The sign of a sum of numbers, exactly: adds each to an expansion of parts that do not overlap (Shewchuk's Grow-Expansion), whose
/// largest part has the sign of the whole.
template <std::size_t count>
int sign_of_sum(std::array<double, count> const& terms) {
  std::array<double, count> parts = {};
  std::size_t size = 0;
  for (double const term : terms) {
    double carry = term;
    for (std::size_t i = 0; i < size; ++i) {
      auto const [high, low] = two_sum(carry, parts[i]);
      parts[i] = low;
      carry = high;
    }
    parts[size++] = carry;
  }
  for (std::size_t i = size; i-- > 0;) {
    if (parts[i] != 0) return parts[i] > 0 ? 1 : -1;
  }
  return 0;
}

int exact_orientation_sign(Vec2 a, Vec2 b, Vec2 c) {
  // ax by - ay bx + bx cy - by cx + cx ay - cy ax, each product as two exact parts.
  std::array<std::pair<double, double>, 6> const products = {
      {{a.x, b.y}, {-a.y, b.x}, {b.x, c.y}, {-b.y, c.x}, {c.x, a.y}, {-c.y, a.x}}};
  std::array<double, 12> terms = {};
  for (std::size_t i = 0; i < products.size(); ++i) {
    auto const [high, low] = two_product(products[i].first, products[i].second);
    terms[2 * i] = low;
    terms[2 * i + 1] = high;
  }
  return sign_of_sum(terms);
}

bool lies_between(Vec2 p, Vec2 a, Vec2 b) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}

}  // namespace

int orientation_sign(Vec2 a, Vec2 b, Vec2 c) {
  double const left = (b.x - a.x) * (c.y - a.y);
  double const right = (b.y - a.y) * (c.x - a.x);
  double const area = left - right;
  // 3.4e-16 is (3 + 16 u) u with u = 2^-53, rounded up: no smaller area has a sure sign.
  double const bound = 3.4e-16 * (std::abs(left) + std::abs(right));
  if (area > bound) return 1;
  if (area < -bound) return -1;
  return exact_orientation_sign(a, b, c);
}

bool segments_touch(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
    return false;
  }
  int const abc = orientation_sign(a, b, c);
  int const abd = orientation_sign(a, b, d);
  int const cda = orientation_sign(c, d, a);
  int const cdb = orientation_sign(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && lies_between(c, a, b)) || (abd == 0 && lies_between(d, a, b)) ||
         (cda == 0 && lies_between(a, c, d)) || (cdb == 0 && lies_between(b, c, d));
}

}  // namespace inkflate
