// SPDX-License-Identifier: Apache-2.0
#include "image/otsu.h"

namespace inkflate {

std::array<long long, 256> histogram(Mask const& values) {
  std::array<long long, 256> counts{};
  for (auto const value : values.values) ++counts[value];
  return counts;
}

int quantile(std::array<long long, 256> const& counts, double share) {
  long long total = 0;
  for (auto const count : counts) total += count;
  long long below = 0;
  for (int value = 0; value < 256; ++value) {
    below += counts[static_cast<std::size_t>(value)];
    if (static_cast<double>(below) >= share * static_cast<double>(total)) return value;
  }
  return 255;
}

double otsu_threshold(std::array<long long, 256> const& counts) {
  double total = 0;
  double total_sum = 0;
  for (std::size_t value = 0; value < counts.size(); ++value) {
    total += static_cast<double>(counts[value]);
    total_sum += static_cast<double>(counts[value]) * static_cast<double>(value);
  }
  double best = 0;
  double first_best = 0;
  double last_best = 0;
  double low = 0;
  double low_sum = 0;
  for (std::size_t value = 0; value + 1 < counts.size(); ++value) {
    low += static_cast<double>(counts[value]);
    low_sum += static_cast<double>(counts[value]) * static_cast<double>(value);
    if (low == 0 || low == total) continue;
    double const difference = low_sum / low - (total_sum - low_sum) / (total - low);
    double const variance = low * (total - low) * difference * difference;
    if (variance > best) {
      best = variance;
      first_best = static_cast<double>(value) + 1;
    }
    if (variance >= best) last_best = static_cast<double>(value) + 1;
  }
  return (first_best + last_best) / 2;
}

}  // namespace inkflate
