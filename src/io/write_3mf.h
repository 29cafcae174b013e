// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/colour.h"
#include "mesh/tri_mesh.h"

namespace inkflate {

/// A colour to print in.
struct PrintColour {
  std::string name;
  Colour colour;
};

/// One thing to print, which keeps its place beside the others.
struct PrintObject {
  std::string name;
  TriMesh mesh;              // mm, as it stands on the printer (io/print_pose.h)
  std::vector<int> colours;  // per triangle an index into the colours; empty: no colour
};

/// A print as 3MF: millimetres, names, colours.
///
/// in      objects: at least one; each finite, with at least one triangle
///         name: of them all together
/// out     one build item. Coordinates are rounded to a millionth of a millimetre. Same objects, same bytes
/// cost    O(n)
/// source  3MF core specification 1.3, chapters 3 to 5
std::vector<std::byte> write_3mf(std::span<PrintObject const> objects,
                                 std::span<PrintColour const> colours,
                                 std::string const& name = "character");

}  // namespace inkflate
