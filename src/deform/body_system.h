// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "deform/bend_mesh.h"
#include "deform/grip.h"
#include "deform/soft_handles.h"
#include "deform/symmetric_dirichlet.h"
#include "solvers/block_cholesky.h"

namespace inkflate {

/// The energy of a pose and its Newton step: what resists, the triangles, and what pulls, the handles.
class BodySystem {
 public:
  /// mesh: has to outlive this
  explicit BodySystem(BendMesh const& mesh);

  /// Takes over what the hold says but for its handles and what is fixed: the shape is stiffer around handles that have a grip and where
  /// it is to be, and tethered.
  void stiffen(BendHold const& hold);

  /// Infinite where a triangle is turned over.
  double energy(std::span<Vec2 const> pose, std::span<Pull const> pulls) const;

  /// Replaces the moves by those to the minimum of the quadratic model at this pose; fixed vertices have none.
  ///
  /// in      pose: no triangle is turned over; is_fixed: one per vertex, or empty
  /// out     how much the energy falls per unit of the moves at their start, >= 0; moves of 0 where numbers fail
  double newton_moves(std::span<Vec2 const> pose, std::span<Pull const> pulls,
                      std::span<char const> is_fixed, std::vector<Vec2>& moves);

 private:
  /// Where a triangle's part of the Hessian goes: the diagonal blocks of its corners, and the blocks of corner i with the next.
  struct Slots {
    std::array<int, 3> diagonal = {};
    std::array<int, 3> beside = {};
    std::array<std::array<int, 2>, 3> corners = {};  // row and column of each block beside
  };

  /// Which Hessian: the energy's own, with which Newton's method converges quadratically, or the one without the triangles' negative
  /// curvatures, which is positive definite at every pose.
  enum class Curvature { Own, Positive };

  std::array<Vec2, 3> places(int triangle, std::span<Vec2 const> pose) const;
  [[nodiscard]] bool factor(std::span<Vec2 const> pose, std::span<Pull const> pulls,
                            std::span<char const> is_fixed, Curvature curvature, double damping);
  [[nodiscard]] bool factor_somehow(std::span<Vec2 const> pose, std::span<Pull const> pulls,
                                    std::span<char const> is_fixed);
  void add_triangle(int triangle, DirichletModel const& model);
  void add_pull(Pull const& pull, std::span<Vec2 const> pose);
  void add_tethers(std::span<Vec2 const> pose);
  void hold_fixed(std::span<char const> is_fixed);

  BendMesh const* mesh_;
  std::vector<RestTriangle> rest_;
  Grips grips_;
  std::vector<double> stiffening_;  // of the hold that was last
  std::vector<double> weights_;     // of the triangles without any of that
  std::vector<double> tethers_;     // of the hold that was last
  std::vector<Vec2> tethered_to_;
  BlockCholesky hessian_;
  std::vector<Slots> slots_;
  std::vector<int> diagonal_;  // per vertex
  std::vector<Vec2> gradient_;
  std::vector<double> solution_;
  double damping_ = 0;
};

}  // namespace inkflate
