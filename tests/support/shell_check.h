// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mesh/tri_mesh.h"

namespace inkflate::shapes {

/// What a printable mesh has to be, and its measures.
struct ShellCheck {
  std::string fault;  // the first one found; empty: closed, 2-manifold, oriented, no area of zero
  int shells = 0;
  long long euler = 0;
  double volume = 0;
  double least_angle = 180;  // degrees
  double least_edge = 1e300;
  Vec3 min{1e300, 1e300, 1e300};
  Vec3 max{-1e300, -1e300, -1e300};
};

ShellCheck check_shell(TriMesh const& mesh);

}  // namespace inkflate::shapes
