// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace inkflate {

/// How far a drag reaches where nothing holds a part, as a share of the longer side of its box: a hand bends a limb or a cheek, and the
/// rest stays.
inline constexpr double kUsualBendReach = 0.3;

}  // namespace inkflate
