// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/result.h"
#include "solidify/line_spans.h"
#include "solidify/solidify.h"

namespace inkflate {

/// The model turned, scaled and laid into a lattice. Lattice units are half a period; i runs to the right, j to the back, k up.
struct PrintSpace {
  Lattice lattice;
  LatticeMesh mesh;
  double unit_mm = 1;  // of a lattice unit
  Vec3
      zero;  // the place of the origin in mm, lattice units; its z is the base if there is one, else the model's lowest point
  double least = 0;  // thickness, lattice units; what the lattice can show, at least
};

/// errors  BadInput (points that are not finite, indices, not closed), NothingThere, BadOption, TooLarge
/// cost    O(n log n)
Result<PrintSpace> make_print_space(TriMesh const& model, SolidifyOptions const& options);

}  // namespace inkflate
