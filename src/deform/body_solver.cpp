// SPDX-License-Identifier: Apache-2.0
#include "deform/body_solver.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "deform/body_system.h"
#include "deform/rigid_freedom.h"
#include "deform/step_bound.h"

namespace inkflate {
namespace {

// Nobody sees a hundredth of a pixel. Newton's moves shrink quadratically: what is left after one of this length is far shorter still.
constexpr double kSettledPx = 0.01;

// A step as short as this is not made: rounding would make it again and again. So a settled pose stays the same to the last bit.
constexpr double kStillPx = 1e-7;

// Of the way to where the first triangle would have no area.
constexpr double kShareOfBound = 0.9;

// Of the fall that the slope promises (Armijo; Nocedal and Wright, section 3.1).
constexpr double kLeastShareOfFall = 1e-4;

// At a minimum a Newton step gains half of what the slope promises. One that gains as much as this is far too short: the shape turns, and
// the Hessian without its negative curvatures is too stiff. So it is doubled, but not beyond so many edges.
constexpr double kShareOfFallWhenShort = 0.75;
constexpr double kLongestMoveEdges = Pull::kReachEdges;

// What rounding does to a sum of a thousand energies.
constexpr double kEnergyRounding = 1e-12;

double largest(std::span<Vec2 const> moves) {
  double result = 0;
  for (Vec2 const move : moves) result = std::max(result, squared_norm(move));
  return std::sqrt(result);
}

}  // namespace

struct BodySolver::Inside {
  explicit Inside(BendMesh const& given) : mesh(&given), system(given), freedom(given) {}

  BendProgress step_once(BendPose& pose, SoftHandles const& handles,
                         std::span<char const> is_fixed);
  bool search(BendPose& pose, std::span<Pull const> pulls, double fall, BendProgress& progress);
  double energy_at(BendPose const& pose, double share, std::span<Pull const> pulls);
  double lengthen(BendPose const& pose, std::span<Pull const> pulls, double energy,
                  double most_share, double& share);

  BendMesh const* mesh;
  BodySystem system;
  RigidFreedom freedom;
  std::vector<Vec2> moves;
  BendPose trial;
};

BodySolver::BodySolver(BendMesh const& mesh) : inside_(std::make_unique<Inside>(mesh)) {}
BodySolver::~BodySolver() = default;
BodySolver::BodySolver(BodySolver&&) noexcept = default;
BodySolver& BodySolver::operator=(BodySolver&&) noexcept = default;

double BodySolver::energy(std::span<Vec2 const> pose, BendHold const& hold) {
  inside_->system.stiffen(hold);
  return inside_->system.energy(pose, SoftHandles(*inside_->mesh, hold.handles).pulls());
}

BendProgress BodySolver::step(BendPose& pose, BendHold const& hold, int steps) {
  auto const count = inside_->mesh->rest.points.size();
  CHECK(pose.size() == count && (hold.is_fixed.empty() || hold.is_fixed.size() == count) &&
            (hold.tethers.empty() || hold.tethers.size() == count) &&
            (hold.stiffening.empty() ||
             hold.stiffening.size() == inside_->mesh->rest.triangles.size()),
        "a pose and a hold of this mesh");
  CHECK(steps >= 1, "at least one step");
  SoftHandles const handles(*inside_->mesh, hold.handles);
  inside_->system.stiffen(hold);
  inside_->freedom.set_hold(hold);
  BendProgress progress;
  for (int i = 0; i < steps && !progress.is_settled; ++i) {
    double const shift_px = inside_->freedom.shift_to_targets(pose);
    progress = inside_->step_once(pose, handles, hold.is_fixed);
    progress.largest_move_px = std::max(progress.largest_move_px, shift_px);
  }
  return progress;
}

BendProgress BodySolver::Inside::step_once(BendPose& pose, SoftHandles const& handles,
                                           std::span<char const> is_fixed) {
  auto const pulls = handles.pulls_from(pose);
  BendProgress progress;
  progress.energy = system.energy(pose, pulls);
  progress.is_settled = true;
  if (!std::isfinite(progress.energy)) return progress;
  double const fall = system.newton_moves(pose, pulls, is_fixed, moves);
  freedom.remove_from(moves, pose);
  double const move_px = largest(moves);
  bool const is_move = move_px > kStillPx && std::isfinite(move_px);
  if (!is_move || !search(pose, pulls, fall, progress)) return progress;
  progress.is_settled = move_px < kSettledPx;
  return progress;
}

/// Goes along the moves as far as no triangle turns over and the energy falls. out: whether it has gone at all
bool BodySolver::Inside::search(BendPose& pose, std::span<Pull const> pulls, double fall,
                                BendProgress& progress) {
  constexpr int most_halvings = 40;
  double const most_share = kShareOfBound * step_bound(mesh->rest.triangles, pose, moves);
  double share = std::min(1.0, most_share);
  double const begun = progress.energy;
  double const rounding = kEnergyRounding * begun;
  for (int i = 0; i < most_halvings; ++i, share /= 2) {
    double energy = energy_at(pose, share, pulls);
    if (!(energy <= begun - share * kLeastShareOfFall * fall + rounding)) continue;
    if (share == 1 && begun - energy > kShareOfFallWhenShort * fall) {
      energy = lengthen(pose, pulls, energy, most_share, share);
    }
    progress.energy = energy;
    progress.largest_move_px = share * largest(moves);
    pose.swap(trial);
    return true;
  }
  return false;
}

/// Of a pose that has gone a share of the moves, which is left in trial.
double BodySolver::Inside::energy_at(BendPose const& pose, double share,
                                     std::span<Pull const> pulls) {
  trial = pose;
  for (std::size_t v = 0; v < pose.size(); ++v) trial[v] += moves[v] * share;
  return system.energy(trial, pulls);
}

/// Doubles a share whose energy is known, for as long as the energy falls. out: the energy of the share, whose pose is in trial
double BodySolver::Inside::lengthen(BendPose const& pose, std::span<Pull const> pulls,
                                    double energy, double most_share, double& share) {
  double const most = std::min(most_share, kLongestMoveEdges * mesh->edge_px / largest(moves));
  auto best = trial;
  while (2 * share <= most) {
    double const next = energy_at(pose, 2 * share, pulls);
    if (!(next < energy)) break;
    energy = next;
    share *= 2;
    best.swap(trial);
  }
  trial.swap(best);
  return energy;
}

}  // namespace inkflate
