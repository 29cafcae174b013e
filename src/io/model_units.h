// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace inkflate {

/// GLB and OBJ: 100 px of the canvas are one unit (a metre, where a format says so), as in Monster Mash.
constexpr double kFileUnitsPerPx = 0.01;

}  // namespace inkflate
