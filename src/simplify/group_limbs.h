// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/drawing.h"
#include "simplify/work_space.h"

namespace inkflate {

/// A group of strokes and what it encloses.
struct GroupShapes {
  // All of the group, indices into Sketch::strokes; empty: it takes no part.
  std::vector<int> strokes;
  std::vector<Layer> layers;  // with their outlines, strokes and details; largest first
  std::vector<int> stray;     // those of the strokes that are in no layer
};

/// Strokes of a group that are closed together.
struct Limb {
  std::vector<int> strokes;
  int layer = -1;  // of its group; -1: the strokes have enclosed nothing
};

/// Splits a group into its limbs: the strokes and details of each layer with the stray strokes that hang together with them, and the other stray
/// strokes, sorted by what touches what.
///
/// in      is_faint: per stroke of the sketch, takes no part
/// out     one limb for each layer, in their order, then those without a layer; the strokes of each in drawing order
/// cost    O(samples)
std::vector<Limb> group_limbs(Sketch const& sketch, GroupShapes const& group,
                              std::vector<bool> const& is_faint, WorkSpace const& space);

}  // namespace inkflate
