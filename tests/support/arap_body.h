// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "deform/bend_mesh.h"
#include "deform/symmetric_dirichlet.h"
#include "solvers/sparse_cholesky.h"

namespace inkflate::support {

/// What BodySolver is measured against: the as-rigid-as-possible energy of a mesh with the same soft handles, minimised by rotations and
/// places in turn. Nothing in it forbids that triangles turn over.
///
/// source  Sorkine and Alexa 2007, section 3; Chao, Pinkall, Sanan, Schroeder 2010 (a rotation for each triangle)
class ArapBody {
 public:
  /// in      mesh: outlives this; handles: at least one
  ArapBody(BendMesh const& mesh, std::vector<BendHandle> handles);

  double energy(std::span<Vec2 const> pose) const;
  /// The places that fit best to the rotations of a pose. The energy falls all the way there.
  BendPose next(std::span<Vec2 const> pose) const;

 private:
  BendMesh const& mesh_;
  std::vector<BendHandle> handles_;
  std::vector<RestTriangle> rest_;
  SparseCholesky factor_;
};

}  // namespace inkflate::support
