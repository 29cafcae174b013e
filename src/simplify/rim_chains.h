// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simplify/rim.h"

namespace inkflate {

/// A stretch of a rim without corners and of one kind: from corner `first` over `size` edges.
struct RimChain {
  int first = 0;
  int size = 0;  // edges, > 0
  RunKind kind = RunKind::Ink;
  bool is_ring = false;  // the whole rim, without any break: it goes on smoothly where it ends
};

/// Cuts a rim at its corners and where its kind changes, after runs too short to mean anything have taken the kind of what is around
/// them: gaps within the pencil's width, specks of ink in the middle of a closing.
///
/// in      positions: of the rim's corners, work px
/// out     chains in rim order that cover it; the first starts at a break if there is any
std::vector<RimChain> cut_rim(Rim const& rim, Contour const& positions);

}  // namespace inkflate
