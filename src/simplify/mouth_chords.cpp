// SPDX-License-Identifier: Apache-2.0
#include "simplify/mouth_chords.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

// A limb that ends no farther than this from another part's outline is meant to join it, work px.
constexpr double kShortOfPx = 12;

// Of the way along a chord lies over the host.
constexpr double kOverShare = 0.8;

// No narrower than a line, work px.
constexpr double kLeastChordPx = 7;

// Bounds the number of cuts that are tried: 66 pairs. A limb has two or three loose ends at its mouth.
constexpr int kMostEnds = 12;

// A chord is looked at every so many work px.
constexpr double kStepPx = 5;

bool is_over(Chord const& chord, LayerArea const& host) {
  int const steps =
      std::max(2, 2 * static_cast<int>(distance(chord.from, chord.to) / (2 * kStepPx)));
  int over = 0;
  for (int k = 1; k < steps; ++k) {
    bool const is_covered =
        host.covers(lerp(chord.from, chord.to, static_cast<double>(k) / steps), kShortOfPx);
    if (!is_covered && 2 * k == steps) return false;
    over += is_covered ? 1 : 0;
  }
  return over >= kOverShare * (steps - 1);
}

/// The ends that may belong to a mouth into this host, in their order.
std::vector<int> ends_at(LayerArea const& host, std::vector<LooseEnd> const& ends,
                         LayerArea const* own) {
  std::vector<int> found;
  for (int i = 0; i < std::ssize(ends); ++i) {
    auto const p = ends[i].position;
    if (!host.covers(p, kShortOfPx)) continue;
    if (own != nullptr && own->holds(p) && !own->is_at_rim(p, kShortOfPx)) continue;
    found.push_back(i);
  }
  if (std::ssize(found) <= kMostEnds) return found;
  std::stable_sort(found.begin(), found.end(),
                   [&](int a, int b) { return ends[a].length_px > ends[b].length_px; });
  found.resize(kMostEnds);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::vector<MouthChord> mouth_chords(std::vector<LooseEnd> const& ends,
                                     std::span<LayerArea const* const> hosts, LayerArea const* own,
                                     double longest_px) {
  std::vector<MouthChord> chords;
  for (auto const* host : hosts) {
    auto const at_host = ends_at(*host, ends, own);
    for (std::size_t i = 0; i < at_host.size(); ++i) {
      for (std::size_t j = i + 1; j < at_host.size(); ++j) {
        int const a = at_host[i];
        int const b = at_host[j];
        bool const is_there = std::any_of(chords.begin(), chords.end(), [&](auto const& known) {
          return known.end_a == a && known.end_b == b;
        });
        Chord const chord = {ends[a].position, ends[b].position};
        double const size = distance(chord.from, chord.to);
        if (is_there || size < kLeastChordPx || size > longest_px) continue;
        if (is_over(chord, *host)) chords.push_back({chord, a, b});
      }
    }
  }
  return chords;
}

}  // namespace inkflate
