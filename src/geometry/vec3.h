// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace inkflate {

/// A point or a direction of the model: px, x to the right, y up, z towards the viewer.
struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(Vec3 const&, Vec3 const&) = default;

  Vec3& operator+=(Vec3 b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  Vec3& operator-=(Vec3 b) { return *this = {x - b.x, y - b.y, z - b.z}; }
  Vec3& operator*=(double s) { return *this = {x * s, y * s, z * s}; }
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec3 operator*(double s, Vec3 a) { return a * s; }
inline Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double squared_norm(Vec3 a) { return dot(a, a); }
/// By sqrt, not hypot: hypot's last bits differ between machines.
inline double norm(Vec3 a) { return std::sqrt(squared_norm(a)); }
inline double distance(Vec3 a, Vec3 b) { return norm(b - a); }
/// The direction of a with length 1; the zero vector stays zero.
inline Vec3 normalized(Vec3 a) {
  double const length = norm(a);
  return length > 0 ? a / length : Vec3{};
}
inline bool is_finite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace inkflate
