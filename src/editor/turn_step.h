// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/trig.h"

namespace inkflate {

/// By so much keys turn things and the model, and hands that hold Shift: 15 degrees, as drawing programs have it.
inline constexpr double kTurnStepRad = kPi / 12;

}  // namespace inkflate
