// SPDX-License-Identifier: Apache-2.0
#include "geometry/polyline.h"

#include "geometry/segment.h"

namespace inkflate {

Rect bounds(std::span<Vec2 const> points) {
  Rect box;
  for (auto const p : points) box.include(p);
  return box;
}

double length(std::span<Vec2 const> points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

double perimeter(std::span<Vec2 const> contour) {
  return contour.empty() ? 0 : length(contour) + distance(contour.back(), contour.front());
}

double signed_area(std::span<Vec2 const> contour) {
  if (contour.empty()) return 0;
  Vec2 const origin = contour.front();  // far from the origin the products would lose digits
  double twice = 0;
  for (std::size_t i = 1; i < contour.size(); ++i) {
    twice += cross(contour[i - 1] - origin, contour[i] - origin);
  }
  return twice / 2;
}

int winding_number(std::span<Vec2 const> contour, Vec2 p) {
  int number = 0;
  for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
    auto const a = contour[i];
    auto const b = contour[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) {
      number += a.y > p.y ? 1 : -1;
    }
  }
  return number;
}

int winding_number(std::span<Contour const> contours, Vec2 p) {
  int number = 0;
  for (auto const& contour : contours) number += winding_number(contour, p);
  return number;
}

bool contains(std::span<Vec2 const> contour, Vec2 p) { return winding_number(contour, p) != 0; }

bool contains(std::span<Contour const> contours, Vec2 p) {
  return winding_number(contours, p) != 0;
}

double squared_distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  return squared_norm(p - nearest_on_segment(p, a, b));
}

}  // namespace inkflate
