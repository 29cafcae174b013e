// SPDX-License-Identifier: Apache-2.0
#include "mesh/hilbert.h"

#include <array>
#include <cstdint>

namespace inkflate {
namespace {

constexpr unsigned kLevels = 15;  // 2^15 > kLatticeSize

struct Keyed {
  std::uint32_t key;
  int index;
};

/// How a level of the curve turns the next one: state machine of the four orientations of Hilbert's pattern.
struct Step {
  std::uint8_t quarter;  // 0 .. 3 along the curve
  std::uint8_t next_state;
};
// [state][2 * (x bit) + (y bit)]
constexpr std::array<std::array<Step, 4>, 4> kSteps = {{
    {{{0, 1}, {1, 0}, {3, 3}, {2, 0}}},
    {{{0, 0}, {3, 2}, {1, 1}, {2, 1}}},
    {{{2, 2}, {3, 1}, {1, 2}, {0, 3}}},
    {{{2, 3}, {1, 3}, {3, 0}, {0, 2}}},
}};

std::uint32_t hilbert_key(LatticePoint p) {
  std::uint32_t key = 0;
  unsigned state = 0;
  for (unsigned level = kLevels; level-- > 0;) {
    unsigned const x = (static_cast<unsigned>(p.x) >> level) & 1U;
    unsigned const y = (static_cast<unsigned>(p.y) >> level) & 1U;
    auto const step = kSteps[state][2 * x + y];
    key = key << 2U | step.quarter;
    state = step.next_state;
  }
  return key;
}

/// One pass of a stable radix sort by 10 bits of the key.
void radix_pass(std::vector<Keyed> const& from, std::vector<Keyed>& to, unsigned shift) {
  std::array<int, 1025> starts = {};
  for (auto const& item : from) ++starts[((item.key >> shift) & 1023U) + 1];
  for (int i = 0; i < 1024; ++i) starts[i + 1] += starts[i];
  for (auto const& item : from) to[starts[(item.key >> shift) & 1023U]++] = item;
}

}  // namespace

std::vector<int> hilbert_order(std::span<LatticePoint const> points) {
  std::vector<Keyed> items(points.size());
  std::vector<Keyed> other(points.size());
  for (int i = 0; i < std::ssize(points); ++i) items[i] = {hilbert_key(points[i]), i};
  for (unsigned const shift : {0U, 10U, 20U}) {
    radix_pass(items, other, shift);
    items.swap(other);
  }
  std::vector<int> order(points.size());
  for (int i = 0; i < std::ssize(points); ++i) order[i] = items[i].index;
  return order;
}

}  // namespace inkflate
