// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace inkflate::support {

/// std::max and std::min pass over what is no number: a measure of something that has failed would look small. Of these nothing comes but NaN
/// once one of both is none, and then no test of the measure holds.

inline double larger(double a, double b) {
  if (a >= b) return a;
  return b > a ? b : std::numeric_limits<double>::quiet_NaN();
}

inline double smaller(double a, double b) { return -larger(-a, -b); }

}  // namespace inkflate::support
