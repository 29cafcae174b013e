// SPDX-License-Identifier: Apache-2.0
#include "deform/body_system.h"

#include <algorithm>

#include "base/check.h"

namespace inkflate {
namespace {

// Of the stiffest triangle's stiffness, on the whole diagonal: where nothing keeps a piece from being moved as a whole, the Hessian is
// singular without it. The softest bend of a long thin limb still has a hundred times as much.
constexpr double kDamping = 1e-9;

// What is tried where that is too little; beyond the last numbers have failed altogether.
constexpr int kDampings = 4;
constexpr double kMoreDamping = 1000;

std::vector<std::array<int, 2>> edges_of(FlatMesh const& mesh) {
  std::vector<std::array<int, 2>> edges;
  for (auto const& [a, b, c] : mesh.triangles) {
    edges.push_back({a, b});
    edges.push_back({b, c});
    edges.push_back({c, a});
  }
  return edges;
}

}  // namespace

BodySystem::BodySystem(BendMesh const& mesh)
    : mesh_(&mesh),
      grips_(mesh),
      hessian_(static_cast<int>(mesh.rest.points.size()), edges_of(mesh.rest)),
      gradient_(mesh.rest.points.size()),
      solution_(2 * mesh.rest.points.size()) {
  CHECK(!mesh.rest.triangles.empty() && mesh.stiffness.size() == mesh.rest.triangles.size(),
        "triangles with their stiffnesses");
  for (int v = 0; v < static_cast<int>(mesh.rest.points.size()); ++v) {
    diagonal_.push_back(hessian_.start_of(v, v));
  }
  for (int t = 0; t < static_cast<int>(mesh.rest.triangles.size()); ++t) {
    auto const& corners = mesh.rest.triangles[t];
    rest_.push_back(rest_triangle(places(t, mesh.rest.points), mesh.stiffness[t]));
    weights_.push_back(rest_.back().weight);
    auto& slots = slots_.emplace_back();
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3;
      slots.diagonal[i] = diagonal_[corners[i]];
      slots.corners[i] = {i, j};
      if (!hessian_.is_kept(corners[i], corners[j])) slots.corners[i] = {j, i};
      slots.beside[i] =
          hessian_.start_of(corners[slots.corners[i][0]], corners[slots.corners[i][1]]);
    }
  }
  damping_ = kDamping * *std::max_element(mesh.stiffness.begin(), mesh.stiffness.end());
}

void BodySystem::stiffen(BendHold const& hold) {
  tethers_.assign(hold.tethers.begin(), hold.tethers.end());
  tethered_to_.assign(hold.tethered_to.begin(), hold.tethered_to.end());
  CHECK(tethers_.empty() || tethered_to_.size() == tethers_.size(), "a place for each tether");
  bool const is_gripped_anew = grips_.update(hold.handles);
  bool const is_same = std::equal(hold.stiffening.begin(), hold.stiffening.end(),
                                  stiffening_.begin(), stiffening_.end());
  if (!is_gripped_anew && is_same) return;
  stiffening_.assign(hold.stiffening.begin(), hold.stiffening.end());
  for (std::size_t t = 0; t < rest_.size(); ++t) {
    double const stiffening = stiffening_.empty() ? 1 : stiffening_[t];
    rest_[t].weight = weights_[t] * grips_.factors()[t] * stiffening;
  }
}

std::array<Vec2, 3> BodySystem::places(int triangle, std::span<Vec2 const> pose) const {
  auto const& [a, b, c] = mesh_->rest.triangles[triangle];
  return {pose[a], pose[b], pose[c]};
}

double BodySystem::energy(std::span<Vec2 const> pose, std::span<Pull const> pulls) const {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(rest_.size()); ++t) {
    sum += dirichlet_energy(rest_[t], places(t, pose));
  }
  for (auto const& pull : pulls) {
    sum += pull_energy(pull, place_of(mesh_->rest, pose, pull.anchor), mesh_->edge_px);
  }
  for (std::size_t v = 0; v < tethers_.size(); ++v) {
    sum += tethers_[v] * squared_norm(pose[v] - tethered_to_[v]);
  }
  return sum;
}

double BodySystem::newton_moves(std::span<Vec2 const> pose, std::span<Pull const> pulls,
                                std::span<char const> is_fixed, std::vector<Vec2>& moves) {
  moves.assign(pose.size(), {});
  if (!factor_somehow(pose, pulls, is_fixed)) return 0;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    solution_[2 * v] = -gradient_[v].x;
    solution_[2 * v + 1] = -gradient_[v].y;
  }
  hessian_.solve(solution_);
  double fall = 0;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    moves[v] = {solution_[2 * v], solution_[2 * v + 1]};
    fall -= dot(gradient_[v], moves[v]);
  }
  return fall;
}

bool BodySystem::factor_somehow(std::span<Vec2 const> pose, std::span<Pull const> pulls,
                                std::span<char const> is_fixed) {
  if (factor(pose, pulls, is_fixed, Curvature::Own, damping_)) return true;
  double damping = damping_;
  for (int i = 0; i < kDampings; ++i, damping *= kMoreDamping) {
    if (factor(pose, pulls, is_fixed, Curvature::Positive, damping)) return true;
  }
  return false;
}

bool BodySystem::factor(std::span<Vec2 const> pose, std::span<Pull const> pulls,
                        std::span<char const> is_fixed, Curvature curvature, double damping) {
  hessian_.clear();
  std::fill(gradient_.begin(), gradient_.end(), Vec2{});
  for (int t = 0; t < static_cast<int>(rest_.size()); ++t) {
    auto model = dirichlet_model(rest_[t], places(t, pose));
    if (curvature == Curvature::Positive) model.curvatures[2] = std::max(0.0, model.curvatures[2]);
    add_triangle(t, model);
  }
  for (auto const& pull : pulls) add_pull(pull, pose);
  add_tethers(pose);
  for (int const start : diagonal_) {
    hessian_.numbers()[start] += damping;
    hessian_.numbers()[start + 3] += damping;
  }
  hold_fixed(is_fixed);
  return hessian_.factor();
}

void BodySystem::add_triangle(int triangle, DirichletModel const& model) {
  auto const& slots = slots_[triangle];
  auto const numbers = hessian_.numbers();
  auto const add_block = [&](int start, int row, int column) {
    double xx = 0;
    double xy = 0;
    double yx = 0;
    double yy = 0;
    for (int d = 0; d < 4; ++d) {
      Vec2 const left = model.rows[d][row] * model.curvatures[d];
      Vec2 const right = model.rows[d][column];
      xx += left.x * right.x;
      xy += left.x * right.y;
      yx += left.y * right.x;
      yy += left.y * right.y;
    }
    numbers[start] += xx;
    numbers[start + 1] += xy;
    numbers[start + 2] += yx;
    numbers[start + 3] += yy;
  };
  for (int i = 0; i < 3; ++i) {
    gradient_[mesh_->rest.triangles[triangle][i]] += model.gradient(i);
    add_block(slots.diagonal[i], i, i);
    add_block(slots.beside[i], slots.corners[i][0], slots.corners[i][1]);
  }
}

void BodySystem::add_pull(Pull const& pull, std::span<Vec2 const> pose) {
  auto const& slots = slots_[pull.anchor.triangle];
  auto const numbers = hessian_.numbers();
  auto const& weights = pull.anchor.weights;
  Vec2 const slope = pull_gradient(pull, place_of(mesh_->rest, pose, pull.anchor), mesh_->edge_px);
  auto const add_block = [&](int start, double value) {
    numbers[start] += value;
    numbers[start + 3] += value;
  };
  for (int i = 0; i < 3; ++i) {
    gradient_[mesh_->rest.triangles[pull.anchor.triangle][i]] += slope * weights[i];
    add_block(slots.diagonal[i], 2 * pull.strength * weights[i] * weights[i]);
    add_block(slots.beside[i], 2 * pull.strength * weights[i] * weights[(i + 1) % 3]);
  }
}

void BodySystem::add_tethers(std::span<Vec2 const> pose) {
  auto const numbers = hessian_.numbers();
  for (std::size_t v = 0; v < tethers_.size(); ++v) {
    gradient_[v] += (pose[v] - tethered_to_[v]) * (2 * tethers_[v]);
    numbers[diagonal_[v]] += 2 * tethers_[v];
    numbers[diagonal_[v] + 3] += 2 * tethers_[v];
  }
}

/// The equations of a fixed vertex become "its move is 0", without a trace in those of the others.
void BodySystem::hold_fixed(std::span<char const> is_fixed) {
  if (is_fixed.empty()) return;
  auto const numbers = hessian_.numbers();
  for (int t = 0; t < static_cast<int>(slots_.size()); ++t) {
    auto const& corners = mesh_->rest.triangles[t];
    for (int i = 0; i < 3; ++i) {
      if (!is_fixed[corners[i]] && !is_fixed[corners[(i + 1) % 3]]) continue;
      for (int k = 0; k < 4; ++k) numbers[slots_[t].beside[i] + k] = 0;
    }
  }
  for (std::size_t v = 0; v < is_fixed.size(); ++v) {
    if (!is_fixed[v]) continue;
    gradient_[v] = {};
    numbers[diagonal_[v]] = 1;
    numbers[diagonal_[v] + 2] = 0;
    numbers[diagonal_[v] + 3] = 1;
  }
}

}  // namespace inkflate
