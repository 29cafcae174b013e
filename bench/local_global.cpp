// SPDX-License-Identifier: Apache-2.0
#include "local_global.h"

// As in src/solvers, so that both are compiled alike.
#define EIGEN_DONT_VECTORIZE  // NOLINT(cppcoreguidelines-macro-usage): Eigen asks for it
#include <Eigen/LU>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <array>

#include "base/check.h"

namespace inkflate {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Rotation = Eigen::Matrix2d;

/// Half the cotangent of the angle opposite to each edge, from corner k + 1 to corner k + 2.
using Weights = std::array<double, 3>;

Eigen::Vector2d vector(Vec2 a) { return {a.x, a.y}; }

Eigen::Vector2d edge(std::span<Vec2 const> points, Triangle const& corners, int k) {
  return vector(points[corners[(k + 2) % 3]] - points[corners[(k + 1) % 3]]);
}

/// The rotation nearest to a matrix.
Rotation nearest_rotation(Eigen::Matrix2d const& matrix) {
  Eigen::JacobiSVD<Eigen::Matrix2d> const svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix2d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(1) = -u.col(1);
  return u * svd.matrixV().transpose();
}

}  // namespace

struct LocalGlobal::Inside {
  FlatMesh const& mesh;
  std::vector<Weights> weights;
  std::vector<int> held;
  std::vector<int> unknowns;  // per vertex; -1: held
  Eigen::SimplicialLDLT<Matrix> factor;
  Matrix coupling;  // of the unknowns with what is held

  explicit Inside(FlatMesh const& of) : mesh(of) {}

  void find_weights();
  void factor_anew();
  std::vector<Rotation> rotations(std::span<Vec2 const> pose) const;
};

void LocalGlobal::Inside::find_weights() {
  weights.clear();
  for (auto const& corners : mesh.triangles) {
    Weights own = {};
    for (int k = 0; k < 3; ++k) {
      Vec2 const u = mesh.points[corners[(k + 1) % 3]] - mesh.points[corners[k]];
      Vec2 const v = mesh.points[corners[(k + 2) % 3]] - mesh.points[corners[k]];
      own[static_cast<std::size_t>(k)] = dot(u, v) / cross(u, v) / 2;
    }
    weights.push_back(own);
  }
}

void LocalGlobal::Inside::factor_anew() {
  find_weights();
  unknowns.assign(mesh.points.size(), 0);
  for (int const v : held) unknowns[v] = -1;
  int count = 0;
  for (auto& unknown : unknowns)
    if (unknown >= 0) unknown = count++;
  std::vector<int> columns(mesh.points.size(), -1);
  for (int i = 0; i < std::ssize(held); ++i) columns[held[i]] = i;
  std::vector<Eigen::Triplet<double>> inner;
  std::vector<Eigen::Triplet<double>> outer;
  for (std::size_t t = 0; t < weights.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      int const ends[2] = {mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]};
      double const weight = weights[t][static_cast<std::size_t>(k)];
      for (int side = 0; side < 2; ++side) {
        int const row = unknowns[ends[side]];
        int const other = ends[1 - side];
        if (row < 0) continue;
        inner.emplace_back(row, row, weight);
        if (unknowns[other] >= 0) inner.emplace_back(row, unknowns[other], -weight);
        if (unknowns[other] < 0) outer.emplace_back(row, columns[other], -weight);
      }
    }
  }
  Matrix matrix(count, count);
  matrix.setFromTriplets(inner.begin(), inner.end());
  coupling.resize(count, std::ssize(held));
  coupling.setFromTriplets(outer.begin(), outer.end());
  factor.compute(matrix);
  CHECK(factor.info() == Eigen::Success, "a vertex of each part is held");
}

std::vector<Rotation> LocalGlobal::Inside::rotations(std::span<Vec2 const> pose) const {
  std::vector<Rotation> result;
  result.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    auto const& corners = mesh.triangles[t];
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (int k = 0; k < 3; ++k)
      sum += weights[t][static_cast<std::size_t>(k)] * edge(pose, corners, k) *
             edge(mesh.points, corners, k).transpose();
    result.push_back(nearest_rotation(sum));
  }
  return result;
}

LocalGlobal::LocalGlobal(FlatMesh const& mesh) : inside_(std::make_unique<Inside>(mesh)) {}
LocalGlobal::~LocalGlobal() = default;

void LocalGlobal::hold(std::vector<int> vertices) {
  if (vertices == inside_->held) return;
  inside_->held = std::move(vertices);
  inside_->factor_anew();
}

void LocalGlobal::iterate(std::vector<Vec2>& pose, std::span<Vec2 const> targets,
                          int iterations) const {
  auto const& [mesh, weights, held, unknowns, factor, coupling] = *inside_;
  Eigen::MatrixX2d held_places(std::ssize(held), 2);
  for (int i = 0; i < std::ssize(held); ++i) {
    pose[held[i]] = targets[i];
    held_places.row(i) = vector(targets[i]);
  }
  Eigen::MatrixX2d const from_held = coupling * held_places;
  for (int i = 0; i < iterations; ++i) {
    auto const turns = inside_->rotations(pose);
    Eigen::MatrixX2d right = -from_held;
    for (std::size_t t = 0; t < weights.size(); ++t) {
      auto const& corners = mesh.triangles[t];
      for (int k = 0; k < 3; ++k) {
        Eigen::Vector2d const pull =
            weights[t][static_cast<std::size_t>(k)] * (turns[t] * edge(mesh.points, corners, k));
        int const from = unknowns[corners[(k + 1) % 3]];
        int const to = unknowns[corners[(k + 2) % 3]];
        if (from >= 0) right.row(from) -= pull;
        if (to >= 0) right.row(to) += pull;
      }
    }
    Eigen::MatrixX2d const places = factor.solve(right);
    for (std::size_t v = 0; v < pose.size(); ++v)
      if (unknowns[v] >= 0) pose[v] = {places(unknowns[v], 0), places(unknowns[v], 1)};
  }
}

double LocalGlobal::energy(std::span<Vec2 const> pose) const {
  auto const& mesh = inside_->mesh;
  auto const turns = inside_->rotations(pose);
  double sum = 0;
  for (std::size_t t = 0; t < turns.size(); ++t)
    for (int k = 0; k < 3; ++k)
      sum += inside_->weights[t][static_cast<std::size_t>(k)] *
             (edge(pose, mesh.triangles[t], k) - turns[t] * edge(mesh.points, mesh.triangles[t], k))
                 .squaredNorm();
  return sum;
}

}  // namespace inkflate
