// SPDX-License-Identifier: Apache-2.0
#include "image/thin.h"

namespace inkflate {
namespace {

bool bit(unsigned bits, unsigned i) { return (bits >> (i % 8) & 1U) != 0; }

int neighbour_count(unsigned bits) {
  int count = 0;
  for (unsigned i = 0; i < 8; ++i) count += bit(bits, i) ? 1 : 0;
  return count;
}

/// Groups of neighbours that hang together across corners when the middle is gone: the crossing number of
/// Hilditch. 1: the middle can go without changing the topology.
int group_count(unsigned bits) {
  int count = 0;
  for (unsigned side = 0; side < 8; side += 2) {
    if (!bit(bits, side) && (bit(bits, side + 1) || bit(bits, side + 2))) ++count;
  }
  return count;
}

/// Guo and Hall's N(P): twice the neighbours, as pairs, from the poorer of the two ways to pair them.
int pair_count(unsigned bits) {
  int first = 0;
  int second = 0;
  for (unsigned i = 0; i < 8; i += 2) {
    if (bit(bits, i + 7) || bit(bits, i)) ++first;
    if (bit(bits, i) || bit(bits, i + 1)) ++second;
  }
  return first < second ? first : second;
}

/// What happens to a pixel with the given neighbours, in each of the two half-steps and in the last clean-up.
struct Rules {
  std::array<std::array<bool, 256>, 2> is_border{};
  std::array<bool, 256> is_spare{};

  Rules() {
    for (unsigned bits = 0; bits < 256; ++bits) {
      int const pairs = pair_count(bits);
      bool const is_candidate = group_count(bits) == 1 && pairs >= 2 && pairs <= 3;
      // Half-steps peel from above and left, then from below and right.
      bool const upper = (bit(bits, 0) || bit(bits, 1) || !bit(bits, 3)) && bit(bits, 2);
      bool const lower = (bit(bits, 4) || bit(bits, 5) || !bit(bits, 7)) && bit(bits, 6);
      is_border[0][bits] = is_candidate && !upper;
      is_border[1][bits] = is_candidate && !lower;
      is_spare[bits] = group_count(bits) == 1 && neighbour_count(bits) >= 2;
    }
  }
};

struct Pixel {
  int x = 0;
  int y = 0;
};

std::vector<Pixel> pixels_of(Mask const& mask) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) != 0) pixels.push_back(Pixel{x, y});
    }
  }
  return pixels;
}

/// One half-step over the pixels that are left. True: something went.
bool peel(Mask& mask, std::vector<Pixel>& pixels, Rules const& rules, std::size_t half) {
  std::vector<Pixel> border;
  for (auto const pixel : pixels) {
    if (rules.is_border[half][neighbour_bits(mask, pixel.x, pixel.y)]) border.push_back(pixel);
  }
  bool has_changed = false;
  for (auto const pixel : border) {
    if (!rules.is_spare[neighbour_bits(mask, pixel.x, pixel.y)]) continue;
    mask.at(pixel.x, pixel.y) = 0;
    has_changed = true;
  }
  if (has_changed) {
    std::size_t kept = 0;
    for (auto const pixel : pixels) {
      if (mask.at(pixel.x, pixel.y) != 0) pixels[kept++] = pixel;
    }
    pixels.resize(kept);
  }
  return has_changed;
}

}  // namespace

unsigned neighbour_bits(Mask const& mask, int x, int y) {
  unsigned bits = 0;
  bool const is_inner = x > 0 && y > 0 && x + 1 < mask.width && y + 1 < mask.height;
  for (std::size_t i = 0; i < 8; ++i) {
    int const nx = x + kNeighbourSteps[i][0];
    int const ny = y + kNeighbourSteps[i][1];
    if ((is_inner || mask.contains(nx, ny)) && mask.at(nx, ny) != 0) bits |= 1U << i;
  }
  return bits;
}

Mask thin(Mask mask) {
  Rules const rules;
  auto pixels = pixels_of(mask);
  bool has_changed = true;
  while (has_changed) {
    has_changed = peel(mask, pixels, rules, 0);
    has_changed = peel(mask, pixels, rules, 1) || has_changed;
  }
  has_changed = true;
  while (has_changed) {
    has_changed = false;
    for (auto const pixel : pixels) {
      auto& value = mask.at(pixel.x, pixel.y);
      if (value == 0 || !rules.is_spare[neighbour_bits(mask, pixel.x, pixel.y)]) continue;
      value = 0;
      has_changed = true;
    }
  }
  return mask;
}

}  // namespace inkflate
