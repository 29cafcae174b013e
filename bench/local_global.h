// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// As-rigid-as-possible deformation as it is mostly done, to be measured against: rotations and positions in turn, one rotation for each
/// triangle, by singular values; handles are vertices that are eliminated, so that everything is made and factored anew for others.
/// These are the settings that libigl has for flat meshes; the thesis uses them, 10 iterations for each move of the hand.
///
/// source  Sorkine and Alexa 2007, section 3; Chao, Pinkall, Sanan, Schroeder 2010 (energy of elements)
class LocalGlobal {
 public:
  /// mesh: no triangle of zero area; it has to outlive this
  explicit LocalGlobal(FlatMesh const& mesh);
  ~LocalGlobal();

  /// Holds these vertices, at least one in each connected part, from now on. Nothing if they are those held already.
  void hold(std::vector<int> vertices);

  /// targets: one for each vertex that is held
  void iterate(std::vector<Vec2>& pose, std::span<Vec2 const> targets, int iterations) const;

  double energy(std::span<Vec2 const> pose) const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace inkflate
