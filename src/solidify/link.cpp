// SPDX-License-Identifier: Apache-2.0
#include "solidify/link.h"

namespace inkflate {
namespace {

struct Rings {
  std::array<std::array<int, 6>, kDirections> around{};
  std::array<int, kDirections> sizes{};
  std::array<unsigned, kDirections> masks{};
};

constexpr int squared_gap(int a, int b) {
  auto const gap = kSteps[a] - kSteps[b];
  return gap.i * gap.i + gap.j * gap.j + gap.k * gap.k;
}

/// Two neighbours of a node are neighbours of each other along a diagonal, or along an axis if both lie on diagonals.
constexpr bool are_linked(int a, int b) {
  int const gap = squared_gap(a, b);
  return gap == 3 || (gap == 4 && a >= kLongDirections && b >= kLongDirections);
}

constexpr Rings make_rings() {
  Rings rings;
  for (int d = 0; d < kDirections; ++d) {
    for (int other = 0; other < kDirections; ++other) {
      if (are_linked(d, other)) rings.masks[d] |= 1U << static_cast<unsigned>(other);
    }
    // From each member on to a linked one that is not there yet.
    int& size = rings.sizes[d];
    for (int next = 0; next < kDirections;) {
      bool const fits =
          are_linked(d, next) && (size == 0 || are_linked(rings.around[d][size - 1], next));
      bool is_new = true;
      for (int r = 0; r < size; ++r) is_new = is_new && rings.around[d][r] != next;
      if (fits && is_new) {
        rings.around[d][size++] = next;
        next = 0;
      } else {
        ++next;
      }
    }
  }
  return rings;
}

constexpr Rings kRings = make_rings();
static_assert(kRings.sizes[0] == 4 && kRings.sizes[6] == 6);

bool is_connected(unsigned nodes) {
  unsigned seen = nodes & (~nodes + 1);
  for (unsigned before = 0; seen != before;) {
    before = seen;
    for (int d = 0; d < kDirections; ++d) {
      if ((seen >> static_cast<unsigned>(d) & 1U) != 0) seen |= kRings.masks[d] & nodes;
    }
  }
  return seen == nodes;
}

/// Whether the surface passes a neighbour that lies on it at most once, and leaves no tetrahedron flat.
bool is_passed_once(LinkSides const& link, int d) {
  int changes = 0;
  auto const ring = ring_around(d);
  NodeSide last = NodeSide::On;
  for (std::size_t r = 0; r < 2 * ring.size(); ++r) {
    NodeSide const side = link[ring[r % ring.size()]];
    NodeSide const next = link[ring[(r + 1) % ring.size()]];
    if (side == NodeSide::On && next == NodeSide::On) return false;
    if (side == NodeSide::On) continue;
    // The first round finds the side before the first member.
    if (r >= ring.size() && side != last) ++changes;
    last = side;
  }
  return changes <= 2;
}

}  // namespace

std::span<int const> ring_around(int d) {
  return {kRings.around[d].data(), static_cast<std::size_t>(kRings.sizes[d])};
}

bool is_disc(LinkSides const& link) {
  unsigned inside = 0;
  unsigned outside = 0;
  for (int d = 0; d < kDirections; ++d) {
    if (link[d] == NodeSide::Inside) inside |= 1U << static_cast<unsigned>(d);
    if (link[d] == NodeSide::Outside) outside |= 1U << static_cast<unsigned>(d);
  }
  if (inside == 0 || outside == 0 || !is_connected(inside) || !is_connected(outside)) return false;
  for (int d = 0; d < kDirections; ++d) {
    if (link[d] == NodeSide::On && !is_passed_once(link, d)) return false;
  }
  return true;
}

}  // namespace inkflate
