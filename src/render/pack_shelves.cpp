// SPDX-License-Identifier: Apache-2.0
#include "render/pack_shelves.h"

#include <algorithm>
#include <numeric>

namespace inkflate {
namespace {

/// Widths to try, from the widest box to all of them side by side.
constexpr int kTries = 24;

std::vector<int> tallest_first(std::span<PixelSize const> sizes) {
  std::vector<int> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return sizes[static_cast<std::size_t>(a)].height > sizes[static_cast<std::size_t>(b)].height;
  });
  return order;
}

Shelves fill(std::span<PixelSize const> sizes, std::vector<int> const& order, long long width) {
  Shelves result;
  result.boxes.resize(sizes.size());
  int left = 0;
  int top = 0;
  for (int const index : order) {
    auto const size = sizes[static_cast<std::size_t>(index)];
    if (left > 0 && left + size.width > width) {
      left = 0;
      top = result.height;
    }
    result.boxes[static_cast<std::size_t>(index)] = {left, top, size.width, size.height};
    left += size.width;
    result.width = std::max(result.width, left);
    result.height = std::max(result.height, top + size.height);
  }
  return result;
}

bool is_better(Shelves const& a, Shelves const& b) {
  int const longer_a = std::max(a.width, a.height);
  int const longer_b = std::max(b.width, b.height);
  if (longer_a != longer_b) return longer_a < longer_b;
  return static_cast<long long>(a.width) * a.height < static_cast<long long>(b.width) * b.height;
}

}  // namespace

Shelves pack_shelves(std::span<PixelSize const> sizes) {
  long long widest = 0;
  long long sum = 0;
  for (auto const size : sizes) {
    widest = std::max<long long>(widest, size.width);
    sum += size.width;
  }
  auto const order = tallest_first(sizes);
  auto best = fill(sizes, order, widest);
  for (int i = 1; i <= kTries; ++i) {
    auto next = fill(sizes, order, widest + (sum - widest) * i / kTries);
    if (is_better(next, best)) best = std::move(next);
  }
  return best;
}

}  // namespace inkflate
