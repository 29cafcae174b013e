// SPDX-License-Identifier: Apache-2.0
#include "render/model_edges.h"

#include <algorithm>
#include <cmath>

#include "render/surface_normal.h"

namespace inkflate {
namespace {

/// A surface that falls away steeply is no edge: steps may be this many times the slope beside them.
constexpr double kSlopeFactor = 3;
/// Surfaces meet at an edge where their normals differ by more than about 70 degrees.
constexpr double kSmoothCosine = 0.35;

class EdgeFinder {
 public:
  EdgeFinder(DrawTriangles const& list, SampleGrid const& grid, SampleBand const& band,
             EdgeOptions const& options)
      : list_(list), grid_(grid), band_(band), options_(options) {}

  /// Marks the nearer one of two neighbours if there is an edge between them.
  void look(int x, int y, int step_x, int step_y, std::vector<std::array<int, 2>>& found) const {
    int const ahead_x = x + step_x;
    int const ahead_y = y + step_y;
    int const here = triangle(x, y);
    int const there = triangle(ahead_x, ahead_y);
    if (here == there) return;
    bool const is_here_nearer = there < 0 || (here >= 0 && depth(x, y) > depth(ahead_x, ahead_y));
    bool const is_edge =
        here < 0 || there < 0 || steps(x, y, step_x, step_y) || folds(x, y, ahead_x, ahead_y);
    if (!is_edge) return;
    if (is_here_nearer) {
      found.push_back({x, y});
    } else {
      found.push_back({ahead_x, ahead_y});
    }
  }

 private:
  int triangle(int x, int y) const { return band_.triangles().at(x, y); }
  double depth(int x, int y) const { return static_cast<double>(band_.depths().at(x, y)); }

  /// The change of depth between two neighbours; 0 where one of them is empty.
  double slope(int x, int y, int step_x, int step_y) const {
    auto const& seen = band_.triangles();
    int const ahead_x = x + step_x;
    int const ahead_y = y + step_y;
    if (!seen.contains(x, y) || !seen.contains(ahead_x, ahead_y)) return 0;
    if (triangle(x, y) < 0 || triangle(ahead_x, ahead_y) < 0) return 0;
    return std::abs(depth(x, y) - depth(ahead_x, ahead_y));
  }

  bool steps(int x, int y, int step_x, int step_y) const {
    double const step = slope(x, y, step_x, step_y);
    if (step <= options_.jump_px) return false;
    double const before = slope(x - step_x, y - step_y, step_x, step_y);
    double const after = slope(x + step_x, y + step_y, step_x, step_y);
    return step > options_.jump_px + kSlopeFactor * std::min(before, after);
  }

  bool folds(int x, int y, int ahead_x, int ahead_y) const {
    int const here = triangle(x, y);
    int const there = triangle(ahead_x, ahead_y);
    if (share_a_corner(here, there)) return false;
    auto const normal = [&](int t, int column, int row) {
      return surface_normal(list_, grid_, t, column + 0.5, band_.top() + row + 0.5);
    };
    return dot(normal(here, x, y), normal(there, ahead_x, ahead_y)) < kSmoothCosine;
  }

  bool share_a_corner(int a, int b) const {
    for (int const p : list_.triangles[static_cast<std::size_t>(a)]) {
      for (int const q : list_.triangles[static_cast<std::size_t>(b)]) {
        if (p == q) return true;
      }
    }
    return false;
  }

  DrawTriangles const& list_;
  SampleGrid const& grid_;
  SampleBand const& band_;
  EdgeOptions options_;
};

void stamp(Mask& mask, int x, int y, double radius) {
  int const reach = static_cast<int>(radius);
  for (int row = std::max(0, y - reach); row <= std::min(mask.height - 1, y + reach); ++row) {
    double const across = std::sqrt(std::max(radius * radius - (row - y) * (row - y), 0.0));
    int const half = static_cast<int>(across);
    int const first = std::max(0, x - half);
    int const end = std::min(mask.width - 1, x + half);
    for (int column = first; column <= end; ++column) mask.at(column, row) = 255;
  }
}

}  // namespace

int edge_reach(EdgeOptions const& options) { return static_cast<int>(options.radius) + 3; }

Mask ink_edges(DrawTriangles const& list, SampleGrid const& grid, SampleBand const& band,
               EdgeOptions const& options) {
  EdgeFinder const finder(list, grid, band, options);
  std::vector<std::array<int, 2>> found;
  auto const& seen = band.triangles();
  for (int y = 0; y < seen.height; ++y) {
    for (int x = 0; x < seen.width; ++x) {
      if (x + 1 < seen.width) finder.look(x, y, 1, 0, found);
      if (y + 1 < seen.height) finder.look(x, y, 0, 1, found);
    }
  }
  Mask mask(seen.width, seen.height);
  for (auto const [x, y] : found) stamp(mask, x, y, options.radius);
  return mask;
}

}  // namespace inkflate
