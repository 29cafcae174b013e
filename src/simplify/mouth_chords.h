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

/// The chords along which a limb may be closed: both ends lie in one host or just short of it, and most of the way between them does.
///
/// in      ends: of a limb's strokes; hosts: the areas of other groups; own: of the limb so far, null when it encloses nothing
/// out     every such pair of ends once, shorter than longest_px; ends well within the limb's own area are none. Of too many ends those
///         of the longest strokes are taken
/// cost    O(ends * outline points), then O(pairs * outline points) for at most 66 pairs per host
std::vector<MouthChord> mouth_chords(std::vector<LooseEnd> const& ends,
                                     std::span<LayerArea const* const> hosts, LayerArea const* own,
                                     double longest_px);

}  // namespace inkflate
