// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "deform/bend_mesh.h"

namespace inkflate {

/// Minimises the symmetric Dirichlet energy of a pose with soft handles, by Newton steps that cannot turn a triangle over.
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

  /// Goes on from a pose by at most `steps` Newton steps; fewer when it has settled: the last move, made as a whole, was less than
  /// 0.01 px. A pose that cannot get better stays as it is to the last bit.
  ///
  /// A piece of the mesh that nothing but a single handle holds is shifted there as it is; what nothing holds relaxes in place.
  ///
  /// in      pose: no triangle is turned over (otherwise nothing moves); steps >= 1. Handles: finite, within 1e6 px, anchors of this mesh
  /// out     the energy has not risen, no triangle is turned over, all is finite. (While a handle has still to turn by more than
  ///         0.5 rad, it is the energy with its turn in parts that has not risen.)
  /// cost    about 0.5 ms per step for 1500 vertices
  BendProgress step(BendPose& pose, BendHold const& hold, int steps);

  /// The energy of a pose, px^2, with the handles' share; infinite where a triangle is turned over. Not const: the handles' grips are taken
  /// over as in a step.
  double energy(std::span<Vec2 const> pose, BendHold const& hold);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace inkflate
