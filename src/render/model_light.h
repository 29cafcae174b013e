// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec3.h"

namespace inkflate {

/// Red, green, blue of one point, 0 .. 255, not rounded yet.
struct Rgb {
  double r = 0;
  double g = 0;
  double b = 0;
};

inline Rgb operator+(Rgb a, Rgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
inline Rgb operator*(double s, Rgb a) { return {s * a.r, s * a.g, s * a.b}; }
inline Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
inline Rgb mix(Rgb a, Rgb b, double share) { return (1 - share) * a + share * b; }

/// What light does to a colour: multiplied, then added.
struct Light {
  Rgb factor = {1, 1, 1};
  Rgb gloss;
};

/// All take the normal of the surface as the viewer sees it: x to the right, y up, z towards the viewer; length 1.

/// Warm clay under a key light from the upper left, darker below, a pale rim.
Rgb clay_colour(Vec3 normal);

/// A soft light that leaves colours as they were drawn where they face it.
Light soft_light(Vec3 normal);

/// Paper with one pale tone in the shade.
Rgb paper_colour(Vec3 normal);

}  // namespace inkflate
