// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "simplify/layer_area.h"
#include "simplify/loose_ends.h"

namespace inkflate {

/// A chord between two loose ends.
struct MouthChord {
  Chord chord;
  int end_a = 0;  // index of the end from which it starts
  int end_b = 0;
};

/// The chords along which a limb may be closed. Both ends lie in one host or just short of it, and most of the way between them does; the strokes lead
/// some way to the ends beyond what the limb encloses already, and the chord lies beyond that, too.
///
/// in      samples: of the limb's strokes; ends: their loose ones; hosts: the areas of other groups; own: of the limb so far, null when it
///         encloses nothing
/// out     every such pair of ends once, shorter than longest_px; of too many ends those of the longest strokes are taken, of too many
///         chords those with the longest sides for their length
/// cost    O(ends * outline points), then O(pairs * outline points) for at most 66 pairs per host
std::vector<MouthChord> mouth_chords(StrokeSamples const& samples,
                                     std::vector<LooseEnd> const& ends,
                                     std::span<LayerArea const* const> hosts, LayerArea const* own,
                                     double longest_px);

}  // namespace inkflate
