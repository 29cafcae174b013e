// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

namespace inkflate {

/// Three passes of a moving average: close to a Gaussian of standard deviation about `radius` samples. T: double or Vec2.
/// cost    O(n)
template <typename T>
void smooth_closed(std::vector<T>& values, int radius) {
  int const count = static_cast<int>(std::ssize(values));
  radius = std::min(radius, (count - 1) / 2);
  if (radius <= 0) return;
  std::vector<T> averaged(values.size());
  for (int pass = 0; pass < 3; ++pass) {
    T sum = values[0];
    for (int k = 1; k <= radius; ++k) sum = sum + values[k] + values[count - k];
    for (int i = 0; i < count; ++i) {
      averaged[i] = sum * (1.0 / (2 * radius + 1));
      sum = sum + values[(i + radius + 1) % count] - values[(i + count - radius) % count];
    }
    values.swap(averaged);
  }
}

/// The same for an open chain: it goes on past its ends by point reflection, so both ends stay where they are.
template <typename T>
void smooth_open(std::vector<T>& values, int radius) {
  int const count = static_cast<int>(std::ssize(values));
  radius = std::min(radius, (count - 1) / 2);
  if (radius <= 0) return;
  auto const at = [&](int i) {
    if (i < 0) return values[0] * 2.0 - values[-i];
    if (i >= count) return values[count - 1] * 2.0 - values[2 * (count - 1) - i];
    return values[i];
  };
  std::vector<T> averaged(values.size());
  for (int pass = 0; pass < 3; ++pass) {
    T sum = at(-radius);
    for (int k = 1 - radius; k <= radius; ++k) sum = sum + at(k);
    for (int i = 0; i < count; ++i) {
      averaged[i] = sum * (1.0 / (2 * radius + 1));
      if (i + 1 < count) sum = sum + at(i + radius + 1) - at(i - radius);
    }
    averaged[0] = values[0];
    averaged[count - 1] = values[count - 1];
    values.swap(averaged);
  }
}

}  // namespace inkflate
