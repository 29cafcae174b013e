// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "image/grid2.h"
#include "render/draw_model.h"

namespace inkflate {

/// Each pixel is looked at in kSamplesAcross x kSamplesAcross places, evenly spread.
inline constexpr int kSamplesAcross = 3;

/// The triangles of a list on the grid of a picture's samples: sample (x, y) lies at (x + 0.5, y + 0.5), y down.
class SampleGrid {
 public:
  /// in      list: finite positions; triangles that reach beyond 1e6 px are left out
  SampleGrid(DrawTriangles const& list, int width_px, int height_px);

  int width() const { return width_; }    // samples
  int height() const { return height_; }  // samples

  /// The weights of the corners of a triangle that is seen, at a place on the grid; their sum is 1, and inside of it none is
  /// negative.
  std::array<double, 3> weights(int triangle, double x, double y) const;

  /// Its corners run against the clock on the screen.
  bool is_front(int triangle) const { return corners(triangle).double_area < 0; }

  /// The first and the last row of samples that a triangle may cover; the last before the first: none.
  std::array<int, 2> rows(int triangle) const;

 private:
  friend class SampleBand;

  /// 1/256 of the distance between samples, so that edges are exact.
  using Place = std::array<std::int64_t, 2>;

  struct Corners {
    std::array<Place, 3> places;
    std::int64_t double_area = 0;  // > 0 clockwise on the screen
  };

  Corners corners(int triangle) const;
  std::array<double, 3> depths(int triangle) const;

  int width_ = 0;
  int height_ = 0;
  std::vector<Triangle> const& triangles_;
  std::vector<Vec3> const& positions_;
  std::vector<Place> places_;
};

/// What is seen at the samples of some rows: the triangle nearest to the viewer. Triangles hide what is behind them
/// from both sides; of two at the same depth the first stays.
class SampleBand {
 public:
  SampleBand(int width, int rows);

  /// Forgets what was seen and goes to other rows of the grid.
  void start(int top);
  void add(SampleGrid const& grid, int triangle);

  int top() const { return top_; }
  /// By column and by row from the top of the band; -1: none.
  Grid2<int> const& triangles() const { return triangles_; }
  /// Towards the viewer, px; where there is a triangle.
  Grid2<float> const& depths() const { return depths_; }

 private:
  void see(int x, int row, int triangle, float depth);

  int top_ = 0;
  Grid2<int> triangles_;
  Grid2<float> depths_;
};

}  // namespace inkflate
