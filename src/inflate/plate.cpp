// SPDX-License-Identifier: Apache-2.0
#include "inflate/plate.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "geometry/polyline.h"

namespace inkflate {
namespace {

constexpr double kCellsAlong = 8;
constexpr double kSmallestCellPx = 8;

/// Keeps a node that no difference reaches from being undetermined; relative to bending.
constexpr double kLeastDiagonal = 1e-9;

/// The values, or the derivatives by t, of the three quadratic B-splines over a cell.
std::array<double, 3> spline_values(double t) {
  return {(1 - t) * (1 - t) / 2, 0.5 + t * (1 - t), t * t / 2};
}
std::array<double, 3> spline_slopes(double t) { return {t - 1, 1 - 2 * t, t}; }

struct Term {
  int node = -1;
  double weight = 0;
};

/// Adds weight * (sum of terms)^2; nothing if one of its nodes does not exist.
void add_square(std::initializer_list<Term> terms, double weight,
                std::vector<MatrixEntry>& entries) {
  for (auto const& t : terms) {
    if (t.node < 0) return;
  }
  for (auto const& a : terms) {
    for (auto const& b : terms) {
      if (a.node >= b.node) entries.push_back({a.node, b.node, weight * a.weight * b.weight});
    }
  }
}

}  // namespace

Plate::Plate(FlatMesh const& mesh, int first) : first_(first) {
  auto const box = bounds(mesh.points);
  cell_px_ = std::max(box.longer_side() / kCellsAlong, kSmallestCellPx);
  columns_ = std::max(1, static_cast<int>(std::ceil(box.width() / cell_px_)));
  rows_ = std::max(1, static_cast<int>(std::ceil(box.height() / cell_px_)));
  // Centred, so that a mirrored layer gets a mirrored lattice.
  origin_ = box.centre() - Vec2{columns_ * cell_px_, rows_ * cell_px_} / 2;
  std::vector<char> is_used(static_cast<std::size_t>(columns_ + 2) * (rows_ + 2), 0);
  auto const cell = [&](double v, double from, int count) {
    return std::clamp(static_cast<int>((v - from) / cell_px_), 0, count - 1);
  };
  for (auto const& t : mesh.triangles) {
    std::array<Vec2, 3> const corners = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    auto const around = bounds(corners);
    int const x1 = cell(around.max.x, origin_.x, columns_) + 2;
    int const y1 = cell(around.max.y, origin_.y, rows_) + 2;
    for (int y = cell(around.min.y, origin_.y, rows_); y <= y1; ++y) {
      for (int x = cell(around.min.x, origin_.x, columns_); x <= x1; ++x) {
        is_used[y * (columns_ + 2) + x] = 1;
      }
    }
  }
  nodes_.assign(is_used.size(), -1);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (is_used[i]) nodes_[i] = first + unknown_count_++;
  }
}

int Plate::node_at(int x, int y) const {
  if (x < 0 || y < 0 || x >= columns_ + 2 || y >= rows_ + 2) return -1;
  return nodes_[y * (columns_ + 2) + x];
}

std::vector<Vec2> Plate::cell_centres() const {
  std::vector<Vec2> result;
  for (int y = 0; y < rows_; ++y) {
    for (int x = 0; x < columns_; ++x) {
      bool is_used = true;
      for (int k = 0; k < 9; ++k) is_used = is_used && node_at(x + k % 3, y + k / 3) >= 0;
      if (is_used) result.push_back(origin_ + Vec2{x + 0.5, y + 0.5} * cell_px_);
    }
  }
  return result;
}

PlateRow Plate::row(Vec2 p, Vec2 direction) const {
  Vec2 const q = (p - origin_) / cell_px_;
  int const x = std::clamp(static_cast<int>(std::floor(q.x)), 0, columns_ - 1);
  int const y = std::clamp(static_cast<int>(std::floor(q.y)), 0, rows_ - 1);
  auto const along_x = spline_values(q.x - x);
  auto const along_y = spline_values(q.y - y);
  auto const slope_x = spline_slopes(q.x - x);
  auto const slope_y = spline_slopes(q.y - y);
  bool const is_slope = direction != Vec2{};
  PlateRow result;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      double const value = along_x[i] * along_y[j];
      double const slope =
          (direction.x * slope_x[i] * along_y[j] + direction.y * along_x[i] * slope_y[j]) /
          cell_px_;
      int const node = node_at(x + i, y + j);
      // A node of no use: only next to a point that is not in the mesh.
      result.nodes[3 * j + i] = std::max(node, first_);
      result.weights[3 * j + i] = node < 0 ? 0 : is_slope ? slope : value;
    }
  }
  return result;
}

void Plate::add_bending(double factor, std::vector<MatrixEntry>& entries) const {
  double const weight = factor / (cell_px_ * cell_px_);
  for (int y = 0; y < rows_ + 2; ++y) {
    for (int x = 0; x < columns_ + 2; ++x) {
      int const here = node_at(x, y);
      if (here < 0) continue;
      entries.push_back({here, here, kLeastDiagonal * weight});
      int const right = node_at(x + 1, y);
      int const below = node_at(x, y + 1);
      add_square({{node_at(x - 1, y), 1}, {here, -2}, {right, 1}}, weight, entries);
      add_square({{node_at(x, y - 1), 1}, {here, -2}, {below, 1}}, weight, entries);
      add_square({{here, 1}, {right, -1}, {below, -1}, {node_at(x + 1, y + 1), 1}}, 2 * weight,
                 entries);
    }
  }
}

void Plate::add_slopes(double weight, std::vector<MatrixEntry>& entries) const {
  for (int y = 0; y < rows_ + 2; ++y) {
    for (int x = 0; x < columns_ + 2; ++x) {
      int const here = node_at(x, y);
      add_square({{here, -1}, {node_at(x + 1, y), 1}}, weight, entries);
      add_square({{here, -1}, {node_at(x, y + 1), 1}}, weight, entries);
    }
  }
}

void Plate::add_energy(FlatMesh const& mesh, std::vector<double> const& point_areas,
                       PlateStiffness const& stiffness, std::vector<MatrixEntry>& entries) const {
  add_bending(stiffness.bending, entries);
  if (stiffness.slope > 0) add_slopes(stiffness.slope, entries);
  // The coefficients of a plane are its depths at the nodes, so pulling them pulls the plate.
  std::vector<double> areas(unknown_count_, 0);
  for (std::size_t i = 0; i < point_areas.size(); ++i) {
    auto const at = depth(mesh.points[i]);
    for (int k = 0; k < 9; ++k) areas[at.nodes[k] - first_] += point_areas[i] * at.weights[k];
  }
  for (int i = 0; i < unknown_count_; ++i) {
    entries.push_back({first_ + i, first_ + i, stiffness.pull * areas[i]});
  }
}

}  // namespace inkflate
