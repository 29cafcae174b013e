// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "deform/bend_mesh.h"

namespace inkflate {

/// Minimises the symmetric Dirichlet energy of a pose with soft handles, by projected Newton steps that cannot turn a triangle over.
///
/// The pattern of the Hessian is analysed once per mesh; handles and fixed vertices change numbers only, so that a handle costs
/// nothing to add or to remove.
///
/// source  Smith, de Goes, Kim 2019, "Analytic Eigensystems for Isotropic Distortion Energies"; Smith and Schaefer 2015, "Bijective
///         Parameterization with Free Boundaries" (the step bound); docs/algorithms/deform.md
class BodySolver {
 public:
  /// in      mesh: at least one triangle; it has to outlive the solver
  explicit BodySolver(BendMesh const& mesh);
  ~BodySolver();
  BodySolver(BodySolver&&) noexcept;
  BodySolver& operator=(BodySolver&&) noexcept;

  /// Goes on from a pose by at most `steps` Newton steps; fewer when it has settled.
  ///
  /// in      pose: no triangle is turned over; steps >= 1. Handles: finite, within 1e6 px, anchors of this mesh
  /// out     the energy has not risen, no triangle is turned over, all is finite. With neither handles nor fixed vertices the pose
  ///         relaxes in place
  /// cost    about 1.5 ms per step for 1200 vertices
  BendProgress step(BendPose& pose, BendHold const& hold, int steps);

  /// The energy of a pose, with the handles' share; infinite where a triangle is turned over.
  double energy(std::span<Vec2 const> pose, BendHold const& hold);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace inkflate
