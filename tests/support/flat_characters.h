// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/polyline.h"
#include "model/flat_model.h"

namespace inkflate::support {

/// A convex part of a made-up character: an ellipse, or a limb that is open at its root.
struct Part {
  std::string name;
  Contour rim;    // positive area; a limb's open run goes from the last point to the first
  int host = -1;  // of a limb: the part that it is joined to; -1: closed, or joined to nothing
  bool is_open = false;
  double thickness = 2;
};

/// An ellipse.
Part blob(std::string name, Vec2 centre, Vec2 radii);

/// A limb from its root to its tip, round at the tip and open at the root.
Part limb(std::string name, Vec2 root, Vec2 tip, double width, int host);

std::vector<Part> one_part();
std::vector<Part> three_parts();
std::vector<Part> five_parts();
std::vector<Part> twenty_one_parts();

/// The parts meshed and joined as assemble would: a limb lies in a slit of its host's front sheet, or of its back sheet if it is behind it.
FlatModel flat_model_of(std::vector<Part> const& parts);

}  // namespace inkflate::support
