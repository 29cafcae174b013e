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

using Areas = std::array<std::int64_t, 3>;

void step(Areas& areas, Areas const& by) {
  for (std::size_t k = 0; k < 3; ++k) areas[k] += by[k];
}

/// Per corner the area between a sample and the edge opposite of it, not negative inside, and how it changes from one
/// sample to the next.
struct EdgeAreas {
  Areas here{};
  Areas step_x{};
  Areas step_y{};
  double whole = 0;

  EdgeAreas(std::array<std::array<std::int64_t, 2>, 3> const& places, std::int64_t area,
            std::array<std::int64_t, 2> const& sample) {
    std::int64_t const turn = area > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
      auto const& a = places[(k + 1) % 3];
      auto const& b = places[(k + 2) % 3];
      here[k] = turn * double_area(a, b, sample);
      step_x[k] = -turn * (b[1] - a[1]) * kUnit;
      step_y[k] = turn * (b[0] - a[0]) * kUnit;
    }
    whole = static_cast<double>(turn * area);
  }

  /// The corners' values, weighted by the areas.
  double mean(Areas const& areas, std::array<double, 3> const& values) const {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += static_cast<double>(areas[k]) * values[k];
    return sum / whole;
  }
};

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

std::array<double, 3> SampleGrid::depths(int triangle) const {
  auto const& corner = triangles_[static_cast<std::size_t>(triangle)];
  auto const z = [&](int vertex) { return positions_[static_cast<std::size_t>(vertex)].z; };
  return {z(corner[0]), z(corner[1]), z(corner[2])};
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
  auto const corner = grid.corners(triangle);
  if (corner.double_area == 0) return;
  auto const& places = corner.places;
  auto const [left, right] = std::minmax({places[0][0], places[1][0], places[2][0]});
  auto const [low, high] = std::minmax({places[0][1], places[1][1], places[2][1]});
  int const first_x = first_sample(left, 0);
  int const end_x = last_sample(right, triangles_.width) + 1;
  int const first_y = first_sample(low, top_);
  int const end_y = last_sample(high, top_ + triangles_.height) + 1;
  EdgeAreas row(places, corner.double_area,
                {first_x * kUnit + kUnit / 2, first_y * kUnit + kUnit / 2});
  auto const depths = grid.depths(triangle);
  double const depth_step = row.mean(row.step_x, depths);
  for (int y = first_y; y < end_y; ++y) {
    auto areas = row.here;
    double depth = row.mean(areas, depths);
    for (int x = first_x; x < end_x; ++x) {
      bool const is_inside = (areas[0] | areas[1] | areas[2]) >= 0;  // no sign bit is set
      if (is_inside) see(x, y - top_, triangle, static_cast<float>(depth));
      step(areas, row.step_x);
      depth += depth_step;
    }
    step(row.here, row.step_y);
  }
}

void SampleBand::see(int x, int row, int triangle, float depth) {
  auto& seen = triangles_.at(x, row);
  auto& nearest = depths_.at(x, row);
  if (seen >= 0 && depth <= nearest) return;
  seen = triangle;
  nearest = depth;
}

}  // namespace inkflate
