// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace inkflate {

/// What every reader of sketches holds to; see docs/LIMITS.md.
inline constexpr std::int64_t kMaxFileBytes = std::int64_t{64} << 20U;
inline constexpr double kCoordinateLimit = 1e6;  // px on the canvas, to every side
inline constexpr int kSampleLimit = 5'000'000;   // of all strokes together

}  // namespace inkflate
