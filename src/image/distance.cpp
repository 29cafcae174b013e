// SPDX-License-Identifier: Apache-2.0
#include "image/distance.h"

#include <algorithm>
#include <limits>

namespace inkflate {
namespace {

/// Above every squared distance (2 * 16384^2), small enough that sums with squares stay exact.
constexpr double kFar = 1e12;

/// Replaces heights by min over q of (p - q)^2 + heights[q].
class Envelope {
 public:
  explicit Envelope(int size)
      : apex_(static_cast<std::size_t>(size)), start_(static_cast<std::size_t>(size) + 1) {}

  void lower(std::vector<double>& heights) {
    build(heights);
    copy_ = heights;
    std::size_t k = 0;
    for (std::size_t p = 0; p < heights.size(); ++p) {
      while (start_[k + 1] < static_cast<double>(p)) ++k;
      auto const offset = static_cast<double>(p) - static_cast<double>(apex_[k]);
      heights[p] = offset * offset + copy_[apex_[k]];
    }
  }

 private:
  void build(std::vector<double> const& heights) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::size_t top = 0;
    apex_[0] = 0;
    start_[0] = -infinity;
    start_[1] = infinity;
    for (std::size_t q = 1; q < heights.size(); ++q) {
      double crossing = meeting(heights, apex_[top], q);
      while (crossing <= start_[top]) crossing = meeting(heights, apex_[--top], q);
      apex_[++top] = q;
      start_[top] = crossing;
      start_[top + 1] = infinity;
    }
  }

  /// Where the parabolas over p < q meet.
  static double meeting(std::vector<double> const& heights, std::size_t p, std::size_t q) {
    auto const x = static_cast<double>(p);
    auto const y = static_cast<double>(q);
    return (heights[q] + y * y - heights[p] - x * x) / (2 * (y - x));
  }

  std::vector<std::size_t> apex_;
  std::vector<double> start_;
  std::vector<double> copy_;
};

}  // namespace

Grid2<double> squared_distance_to_zero(Mask const& mask) {
  Grid2<double> result(mask.width, mask.height);
  if (result.values.empty()) return result;
  // Along the columns two sweeps do: only zeros and far heights are there.
  auto const steps = [&](int x, int y, int from) {
    if (mask.at(x, y) == 0) return 0.0;
    return (from >= 0 && from < mask.height ? result.at(x, from) : kFar) + 1;
  };
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) result.at(x, y) = steps(x, y, y - 1);
  }
  for (int y = mask.height - 1; y >= 0; --y) {
    for (int x = 0; x < mask.width; ++x) {
      result.at(x, y) = std::min(result.at(x, y), steps(x, y, y + 1));
    }
  }
  for (auto& value : result.values) value = value < kFar ? value * value : kFar;
  Envelope envelope(mask.width);
  std::vector<double> row(static_cast<std::size_t>(mask.width));
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) row[static_cast<std::size_t>(x)] = result.at(x, y);
    envelope.lower(row);
    for (int x = 0; x < mask.width; ++x) result.at(x, y) = row[static_cast<std::size_t>(x)];
  }
  return result;
}

}  // namespace inkflate
