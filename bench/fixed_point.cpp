// SPDX-License-Identifier: Apache-2.0
#include "fixed_point.h"

// As in src/solvers, so that both are compiled alike.
#define EIGEN_DONT_VECTORIZE  // NOLINT(cppcoreguidelines-macro-usage): Eigen asks for it
#include <Eigen/QR>
#include <deque>

namespace inkflate {
namespace {

using Vector = Eigen::VectorXd;

constexpr std::size_t kMemory = 10;
constexpr double kSettledPx = 1e-7;

Vector vector_of(std::span<Vec2 const> pose) {
  Vector result(2 * std::ssize(pose));
  for (Eigen::Index v = 0; v < std::ssize(pose); ++v) {
    result[2 * v] = pose[v].x;
    result[2 * v + 1] = pose[v].y;
  }
  return result;
}

std::vector<Vec2> pose_of(Vector const& vector) {
  std::vector<Vec2> result;
  for (Eigen::Index v = 0; v < vector.size() / 2; ++v)
    result.push_back({vector[2 * v], vector[2 * v + 1]});
  return result;
}

/// A plain iteration: where it came to, and by how much it moved.
struct Plain {
  Vector next;
  Vector move;
};

/// The next pose from the plain iterations so far, the last one at the end.
Vector accelerated(std::deque<Plain> const& past) {
  auto const& last = past.back();
  auto const count = std::ssize(past) - 1;
  if (count == 0) return last.next;
  Eigen::MatrixXd moves(last.move.size(), count);
  Eigen::MatrixXd nexts(last.move.size(), count);
  for (int i = 0; i < count; ++i) {
    moves.col(i) = past[i + 1].move - past[i].move;
    nexts.col(i) = past[i + 1].next - past[i].next;
  }
  return last.next - nexts * moves.colPivHouseholderQr().solve(last.move);
}

}  // namespace

std::vector<Vec2> fixed_point(std::vector<Vec2> pose,
                              std::function<void(std::vector<Vec2>&)> const& step,
                              std::function<double(std::span<Vec2 const>)> const& energy,
                              int most_iterations) {
  step(pose);  // handles are met
  double least = energy(pose);
  std::deque<Plain> past;
  for (int i = 0; i < most_iterations; ++i) {
    auto next = pose;
    step(next);
    Vector const plain = vector_of(next);
    past.push_back({plain, plain - vector_of(pose)});
    if (past.back().move.lpNorm<Eigen::Infinity>() < kSettledPx) return next;
    if (past.size() > kMemory + 1) past.pop_front();
    pose = pose_of(accelerated(past));
    double const now = energy(pose);
    bool const is_lower = now <= least;
    if (!is_lower) {
      pose = std::move(next);
      past.clear();
    }
    least = is_lower ? now : energy(pose);
  }
  return pose;
}

}  // namespace inkflate
