// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "image/grid2.h"

namespace inkflate {

/// How many pixels have each value.
std::array<long long, 256> histogram(Mask const& values);

/// The value that a share (0 .. 1) of all pixels does not pass; 0 when there are none.
int quantile(std::array<long long, 256> const& counts, double share);

/// The threshold that parts the values into two classes of the largest variance between them; values >= it form the
/// upper class. In the middle where several are as good; 0 when all values are equal.
/// source  Otsu 1979
double otsu_threshold(std::array<long long, 256> const& counts);

}  // namespace inkflate
