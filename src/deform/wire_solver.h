// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "deform/bend_mesh.h"

namespace inkflate {

/// The thesis' deformation: as-rigid-as-possible with cotangent weights, by rotations and positions in turn. One factor for the mesh's
/// whole life; handles come in by the Schur complement, one back-solve for each new one. What is fixed has a factor of its own, kept
/// while it stays the same.
///
/// source  Sorkine and Alexa 2007, section 3; thesis, section 4.2, eq. 4.2 to 4.10; docs/algorithms/wire.md
class WireSolver {
 public:
  /// in      mesh: at least one triangle; it has to outlive the solver
  explicit WireSolver(BendMesh const& mesh);
  ~WireSolver();
  WireSolver(WireSolver&&) noexcept;
  WireSolver& operator=(WireSolver&&) noexcept;

  /// Goes on from a pose by at most `steps` iterations; fewer when it has settled. Handles are met exactly; of several at one place,
  /// or that cannot be met together, the last counts. A turned one holds the corners of its triangle.
  ///
  /// in      as BodySolver::step, but triangles may be turned over
  /// out     all is finite. Connected parts of the mesh with neither handles nor fixed vertices do not move
  /// cost    about 0.06 ms per iteration and 0.02 ms per new handle for 500 points along the line
  BendProgress step(BendPose& pose, BendHold const& hold, int steps);

  double energy(std::span<Vec2 const> pose) const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace inkflate
