// SPDX-License-Identifier: Apache-2.0
#include "simplify/sort_strokes.h"

#include <algorithm>
#include <cmath>

#include "geometry/point_grid.h"

namespace inkflate {
namespace {

// A sample draws an outline that runs within this distance, work px, and within 30 degrees of its direction: cos.
constexpr double kBandPx = 9;
constexpr double kParallel = 0.866;

// A stroke draws an outline when this share of its samples does.
constexpr double kOutlineShare = 0.4;

// Outlines are looked at as points at most this far apart, work px.
constexpr double kStepPx = 4;

struct OutlinePoint {
  Vec2 direction;
  int layer;
};

/// The outlines of all layers as points with directions.
struct OutlinePoints {
  std::vector<Vec2> positions;  // work px
  std::vector<OutlinePoint> points;
};

OutlinePoints sample_outlines(std::vector<Layer> const& layers, WorkSpace const& space) {
  OutlinePoints result;
  for (int layer = 0; layer < std::ssize(layers); ++layer) {
    for (auto const& outline : layers[layer].outlines) {
      auto const contour = flatten(outline, 0.5 * space.to_canvas);
      for (int i = 0; i < std::ssize(contour); ++i) {
        auto const a = space.work_point(contour[i]);
        auto const b = space.work_point(contour[(i + 1) % std::ssize(contour)]);
        int const steps = static_cast<int>(std::ceil(distance(a, b) / kStepPx));
        for (int k = 0; k < steps; ++k) {
          result.positions.push_back(lerp(a, b, static_cast<double>(k) / steps));
          result.points.push_back({normalized(b - a), layer});
        }
      }
    }
  }
  return result;
}

/// Where a stroke's samples lie.
struct Tally {
  int samples = 0;
  std::vector<int> along;      // per layer: samples that draw its outline
  std::vector<int> near;       // per layer: samples close to its outline
  std::vector<unsigned> seen;  // per layer, of the sample at hand: bit 0 near, bit 1 along
};

void count_sample(StrokeSample const& sample, OutlinePoints const& outlines, PointGrid const& grid,
                  Tally& tally) {
  ++tally.samples;
  auto& seen = tally.seen;
  std::fill(seen.begin(), seen.end(), 0U);
  grid.near(sample.position, kBandPx, [&](int k) {
    if (squared_norm(outlines.positions[k] - sample.position) > kBandPx * kBandPx) return;
    auto const& point = outlines.points[k];
    bool const is_along = std::abs(dot(point.direction, sample.direction)) >= kParallel;
    seen[point.layer] |= is_along ? 3U : 1U;
  });
  for (std::size_t layer = 0; layer < seen.size(); ++layer) {
    tally.near[layer] += static_cast<int>(seen[layer] & 1U);
    tally.along[layer] += static_cast<int>(seen[layer] >> 1U);
  }
}

/// The last layer, that is the one in front, whose outer outline holds p; -1 if none does.
int layer_under(std::vector<Contour> const& outers, Vec2 p) {
  for (int layer = static_cast<int>(std::ssize(outers)) - 1; layer >= 0; --layer) {
    if (contains(outers[layer], p)) return layer;
  }
  return -1;
}

int largest(std::vector<int> const& counts) {
  return static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

}  // namespace

std::vector<int> sort_strokes(StrokeSamples const& samples, WorkSpace const& space,
                              std::vector<Layer>& layers) {
  std::vector<int> stray;
  auto const outlines = sample_outlines(layers, space);
  PointGrid const grid(outlines.positions, kBandPx);
  std::vector<Contour> outers;
  for (auto const& layer : layers) {
    auto contour = flatten(layer.outlines.front(), 0.5 * space.to_canvas);
    for (auto& p : contour) p = space.work_point(p);
    outers.push_back(std::move(contour));
  }
  auto const& points = samples.points;
  for (std::size_t first = 0; first < points.size();) {
    int const stroke = points[first].stroke;
    Tally tally = {0, std::vector<int>(layers.size()), std::vector<int>(layers.size()),
                   std::vector<unsigned>(layers.size())};
    auto last = first;
    for (; last < points.size() && points[last].stroke == stroke; ++last) {
      count_sample(points[last], outlines, grid, tally);
    }
    auto const middle = points[(first + last) / 2].position;
    first = last;
    if (layers.empty()) {
      stray.push_back(stroke);
      continue;
    }
    int const along = largest(tally.along);
    if (tally.along[along] >= kOutlineShare * tally.samples) {
      layers[along].strokes.push_back(stroke);
      continue;
    }
    int const near = largest(tally.near);
    int const under = layer_under(outers, middle);
    if (under >= 0) {
      layers[under].details.push_back(stroke);
    } else if (tally.near[near] > 0) {
      layers[near].details.push_back(stroke);
    } else {
      stray.push_back(stroke);
    }
  }
  return stray;
}

}  // namespace inkflate
