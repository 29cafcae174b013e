// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "model/drawing.h"

namespace inkflate {

enum class SimplifyMethod {
  Cut,   // minimum cut on the Delaunay triangulation of the strokes
  Grid,  // minimum cut on pixels, as the thesis describes it; for comparison
};

enum class Holes {
  Keep,  // enclosed white regions that look meant stay holes
  Fill,  // the thesis: only the silhouette
};

enum class Parts {
  One,     // the largest silhouette
  All,     // every separate piece
  Groups,  // each group of strokes by itself: a layer for each, or for each separate piece of it; see
  // is_candidate_layer. Limbs that are open towards the layer of another group are closed there (limb_mouths.h)
};

enum class MarksBeyond {
  Refuse,  // an inside mark beyond the strokes is a mistake
  PassOver,  // it means nothing; always so with Parts::Groups, where a mark is meant for one of the groups
};

struct SimplifyOptions {
  SimplifyMethod method = SimplifyMethod::Cut;
  std::optional<double> gap_px = {};  // > 0: no closing is longer; none: as the energy balances
  std::vector<Vec2> outside = {};     // these places are background
  std::vector<Vec2> inside = {};      // these places belong to the shape
  MarksBeyond marks_beyond = MarksBeyond::Refuse;  // method cut only
  std::vector<Outline> hosts =
      {};  // of parts that are there already: limbs open towards them are closed there (method cut)
  Holes holes = Holes::Keep;
  Parts parts = Parts::All;
  double smooth = 0.5;  // 0 .. 1: how far a contour may leave the pen's jitter to be smooth
};

/// Closes a rough sketch: smooth closed contours in the middle of its overdrawn strokes.
///
/// in      sketch: any number of strokes; samples finite, within 1e6 px; their box at least 1e-8 of its
///         distance from (0, 0), or a single point
/// out     the sketch with its layers; every outline is closed and simple. A layer whose outline strokes are all of one group has
///         that group's name, colour and thickness
/// errors  BadOption; BadInput (a sample not finite or out of range, a box too small); NothingThere (no stroke encloses or nearly
///         encloses an area); Cancelled
/// cost    O(n log n) in the number of samples; about 10 ms for 250 strokes
/// source  thesis section 3.2, eq. 3.4; docs/algorithms/simplify.md
Result<Drawing> simplify(Sketch const& sketch, SimplifyOptions const& options = {},
                         Progress const& progress = {});

}  // namespace inkflate
