// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace inkflate {

/// A point or a direction on the canvas: px, x to the right, y down.
struct Vec2 {
  double x = 0;
  double y = 0;

  friend bool operator==(Vec2 const&, Vec2 const&) = default;

  Vec2& operator+=(Vec2 b) { return *this = {x + b.x, y + b.y}; }
  Vec2& operator-=(Vec2 b) { return *this = {x - b.x, y - b.y}; }
  Vec2& operator*=(double s) { return *this = {x * s, y * s}; }
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
inline Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
inline Vec2 operator*(double s, Vec2 a) { return a * s; }
inline Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }

inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// The z part of the cross product: positive when b lies clockwise of a on the screen (y down).
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// A quarter turn that takes +x to +y.
inline Vec2 perpendicular(Vec2 a) { return {-a.y, a.x}; }
inline Vec2 lerp(Vec2 a, Vec2 b, double t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}
inline double squared_norm(Vec2 a) { return dot(a, a); }
/// By sqrt, not hypot: hypot's last bits differ between machines.
inline double norm(Vec2 a) { return std::sqrt(squared_norm(a)); }
inline double distance(Vec2 a, Vec2 b) { return norm(b - a); }
/// The direction of a with length 1; the zero vector stays zero.
inline Vec2 normalized(Vec2 a) {
  double const length = norm(a);
  return length > 0 ? a / length : Vec2{};
}
inline bool is_finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

}  // namespace inkflate
