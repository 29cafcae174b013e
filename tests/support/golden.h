// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "image/grid2.h"

namespace inkflate {

/// How far a picture may be from the one that was approved.
struct GoldenTolerance {
  int channel = 24;      // 0 .. 255: pixels that differ by no more in any channel are the same
  double share = 0.002;  // 0 .. 1: of all pixels may differ by more
};

/// Compares a picture with tests/golden/NAME.png. Where they differ, the picture and a map of the differences are left in build/golden, and
/// the message says so. With INKFLATE_UPDATE_GOLDEN=1 in the environment the picture becomes the approved one.
testing::AssertionResult matches_golden(Picture const& picture, std::string const& name,
                                        GoldenTolerance const& tolerance = {});

}  // namespace inkflate
