// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace inkflate {

/// From 1 at t = 0 to 0 at t = 1 and beyond, flat at both ends; t >= 0.
inline double fade(double t) { return t >= 1 ? 0 : (1 - t) * (1 - t) * (1 + 2 * t); }

}  // namespace inkflate
