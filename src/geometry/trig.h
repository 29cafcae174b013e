// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace inkflate {

/// Trigonometry from + - * / and sqrt alone: the same bits on every machine, which libm does not promise.
/// Errors stay below 1e-12 (in practice a few units of the last place).

inline constexpr double kPi = 3.14159265358979323846;

struct SinCos {
  double sin = 0;
  double cos = 1;
};

/// Sine and cosine of an angle within +-1e6 rad; any other angle (or NaN) is taken for 0.
SinCos sin_cos(double angle_rad);

/// The angle of (x, y) in (-pi, pi]. Zero counts as +0 whatever its sign; (0, 0) has the angle 0.
double atan2_of(double y, double x);

/// The angle in [0, pi] with this cosine; cosines beyond +-1 count as +-1.
double acos_of(double cosine);

}  // namespace inkflate
