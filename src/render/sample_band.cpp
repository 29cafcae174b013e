// SPDX-License-Identifier: Apache-2.0
#include "render/sample_band.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace inkflate {
namespace {

constexpr std::int64_t kUnit = 256;
/// Products of two such coordinates still fit into 64 bits.
constexpr double kFarthestPx = 1e6;
constexpr std::int64_t kFarAway = INT64_MAX;

/// Twice the area of a triangle on the screen.
std::int64_t double_area(std::array<std::int64_t, 2> a, std::array<std::int64_t, 2> b,
                         std::array<std::int64_t, 2> c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The first and the last sample whose centre lies in [low, high].
int first_sample(std::int64_t low, int from) {
  std::int64_t const rounded_up = (low - kUnit / 2 + kUnit - 1) >> 8;
  return static_cast<int>(std::max<std::int64_t>(rounded_up, from));
}
int last_sample(std::int64_t high, int end) {
  return static_cast<int>(std::min<std::int64_t>((high - kUnit / 2) >> 8, end - 1));
}

}  // namespace

SampleGrid::SampleGrid(DrawTriangles const& list, int width_px, int height_px)
    : width_(kSamplesAcross * width_px),
      height_(kSamplesAcross * height_px),
      triangles_(list.triangles),
      positions_(list.positions) {
  double const unit = static_cast<double>(kSamplesAcross * kUnit);
  places_.reserve(positions_.size());
  for (auto const p : positions_) {
    bool const is_near = std::abs(p.x) < kFarthestPx && std::abs(p.y) < kFarthestPx;
    if (!is_near) {
      places_.push_back({kFarAway, kFarAway});
      continue;
    }
    places_.push_back(
        {static_cast<std::int64_t>(std::floor((p.x + width_px * 0.5) * unit + 0.5)),
         static_cast<std::int64_t>(std::floor((height_px * 0.5 - p.y) * unit + 0.5))});
  }
}

SampleGrid::Corners SampleGrid::corners(int triangle) const {
  Corners result;
  for (std::size_t k = 0; k < 3; ++k) {
    auto const vertex = triangles_[static_cast<std::size_t>(triangle)][k];
    result.places[k] = places_[static_cast<std::size_t>(vertex)];
    if (result.places[k][0] == kFarAway) return {};
  }
  result.double_area = double_area(result.places[0], result.places[1], result.places[2]);
  return result;
}

std::array<double, 3> SampleGrid::weights(int triangle, double x, double y) const {
  auto const corner = corners(triangle);
  Place const p = {static_cast<std::int64_t>(x * kUnit), static_cast<std::int64_t>(y * kUnit)};
  auto const whole = static_cast<double>(corner.double_area);
  auto const share = [&](std::size_t a, std::size_t b) {
    return static_cast<double>(double_area(corner.places[a], corner.places[b], p)) / whole;
  };
  return {share(1, 2), share(2, 0), share(0, 1)};
}

std::array<int, 2> SampleGrid::rows(int triangle) const {
  auto const [places, area] = corners(triangle);
  if (area == 0) return {0, -1};
  auto const [low, high] = std::minmax({places[0][1], places[1][1], places[2][1]});
  return {static_cast<int>(low >> 8), static_cast<int>(high >> 8)};
}

SampleBand::SampleBand(int width, int rows) : triangles_(width, rows), depths_(width, rows) {}

void SampleBand::start(int top) {
  top_ = top;
  std::fill(triangles_.values.begin(), triangles_.values.end(), -1);
}

void SampleBand::add(SampleGrid const& grid, int triangle) {
  auto [places, area] = grid.corners(triangle);
  if (area == 0) return;
  auto const& vertices = grid.triangles_[static_cast<std::size_t>(triangle)];
  auto const z = [&](std::size_t k) {
    return grid.positions_[static_cast<std::size_t>(vertices[k])].z;
  };
  std::array<double, 3> const depths = {z(0), z(1), z(2)};
  auto const [left, right] = std::minmax({places[0][0], places[1][0], places[2][0]});
  auto const [low, high] = std::minmax({places[0][1], places[1][1], places[2][1]});
  int const first_x = first_sample(left, 0);
  int const last_x = last_sample(right, triangles_.width);
  int const first_y = first_sample(low, top_);
  int const last_y = last_sample(high, top_ + triangles_.height);
  std::int64_t const turn = area > 0 ? 1 : -1;
  // Per edge (opposite corner k): its area with the sample, positive inside, and the steps to the next sample.
  std::array<std::int64_t, 3> step_x{};
  std::array<std::int64_t, 3> step_y{};
  std::array<std::int64_t, 3> row{};
  SampleGrid::Place const start = {first_x * kUnit + kUnit / 2, first_y * kUnit + kUnit / 2};
  for (std::size_t k = 0; k < 3; ++k) {
    auto const& a = places[(k + 1) % 3];
    auto const& b = places[(k + 2) % 3];
    row[k] = turn * double_area(a, b, start);
    step_x[k] = -turn * (b[1] - a[1]) * kUnit;
    step_y[k] = turn * (b[0] - a[0]) * kUnit;
  }
  double const whole = static_cast<double>(turn * area);
  double const depth_step =
      (static_cast<double>(step_x[0]) * depths[0] + static_cast<double>(step_x[1]) * depths[1] +
       static_cast<double>(step_x[2]) * depths[2]) /
      whole;
  for (int y = first_y; y <= last_y; ++y) {
    auto edge = row;
    double depth =
        (static_cast<double>(row[0]) * depths[0] + static_cast<double>(row[1]) * depths[1] +
         static_cast<double>(row[2]) * depths[2]) /
        whole;
    for (int x = first_x; x <= last_x; ++x) {
      if ((edge[0] | edge[1] | edge[2]) >= 0) {
        auto const index =
            static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(triangles_.width) +
            static_cast<std::size_t>(x);
        auto const nearer = static_cast<float>(depth);
        if (triangles_.values[index] < 0 || nearer > depths_.values[index]) {
          triangles_.values[index] = triangle;
          depths_.values[index] = nearer;
        }
      }
      for (std::size_t k = 0; k < 3; ++k) edge[k] += step_x[k];
      depth += depth_step;
    }
    for (std::size_t k = 0; k < 3; ++k) row[k] += step_y[k];
  }
}

}  // namespace inkflate
