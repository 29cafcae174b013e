// SPDX-License-Identifier: Apache-2.0
#include "simplify/stroke_samples.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

// A cap on work and memory: 100 000 long strokes end as a coarser sketch, not as a hang. Far above any drawing by hand.
constexpr double kMostSamples = 300'000;

// The direction of a stroke is taken over this many samples to each side: enough to look past the pen's jitter.
constexpr int kDirectionReach = 2;

/// Samples of a stroke that follow one another at one place.
struct Vertex {
  Vec2 position;  // work px
  double first;   // index of the first of them
  double last;
};

std::vector<Vertex> vertices_of(Stroke const& stroke, WorkSpace const& space) {
  std::vector<Vertex> vertices;
  vertices.reserve(stroke.samples.size());
  for (int i = 0; i < std::ssize(stroke.samples); ++i) {
    auto const p = space.work_point(stroke.samples[i].position);
    if (vertices.empty() || !(vertices.back().position == p)) {
      vertices.push_back({p, static_cast<double>(i), static_cast<double>(i)});
    }
    vertices.back().last = i;
  }
  return vertices;
}

/// A corner that resampling may not cut: both steps are longer than the spacing, and they turn by more than 30 degrees.
bool is_corner(Vec2 before, Vec2 at, Vec2 after, double spacing_px) {
  auto const a = at - before;
  auto const b = after - at;
  double const aa = squared_norm(a);
  double const bb = squared_norm(b);
  double const least = spacing_px * spacing_px;
  if (aa <= least || bb <= least) return false;
  double const turn = dot(a, b);
  return turn < 0 || turn * turn < 0.75 * aa * bb;
}

/// Appends samples of the vertices first .. last at equal steps; without the first, which is there already.
void append_piece(std::vector<Vertex> const& vertices, int first, int last, double spacing_px,
                  int stroke, std::vector<StrokeSample>& points) {
  double total = 0;
  for (int i = first; i < last; ++i)
    total += distance(vertices[i].position, vertices[i + 1].position);
  int const steps = std::max(1, static_cast<int>(std::ceil(total / spacing_px)));
  double const step = total / steps;
  int segment = first;
  double passed = 0;  // length of the piece before the segment
  double size = distance(vertices[first].position, vertices[first + 1].position);
  for (int k = 1; k < steps; ++k) {
    while (passed + size < k * step && segment + 1 < last) {
      passed += size;
      ++segment;
      size = distance(vertices[segment].position, vertices[segment + 1].position);
    }
    double const t = std::min(1.0, (k * step - passed) / size);
    auto const& a = vertices[segment];
    auto const& b = vertices[segment + 1];
    points.push_back(
        {lerp(a.position, b.position, t), {}, a.last + (b.first - a.last) * t, stroke});
  }
  points.push_back({vertices[last].position, {}, vertices[last].first, stroke});
}

void set_directions(std::span<StrokeSample> points) {
  int const count = static_cast<int>(std::ssize(points));
  for (int i = 0; i < count; ++i) {
    auto const from = points[std::max(0, i - kDirectionReach)].position;
    auto const to = points[std::min(count - 1, i + kDirectionReach)].position;
    points[i].direction = normalized(to - from);
  }
}

void append_stroke(std::vector<Vertex> const& vertices, double spacing_px, int stroke,
                   std::vector<StrokeSample>& points) {
  auto const first_point = points.size();
  points.push_back({vertices[0].position, {}, vertices[0].first, stroke});
  int first = 0;
  int const last = static_cast<int>(std::ssize(vertices)) - 1;
  for (int i = 1; i <= last; ++i) {
    if (i == last || is_corner(vertices[i - 1].position, vertices[i].position,
                               vertices[i + 1].position, spacing_px)) {
      append_piece(vertices, first, i, spacing_px, stroke, points);
      first = i;
    }
  }
  set_directions(std::span(points).subspan(first_point));
}

}  // namespace

StrokeSamples sample_strokes(Sketch const& sketch, std::span<int const> chosen,
                             WorkSpace const& space, double spacing_px) {
  double total_px = 0;
  for (int const s : chosen) {
    auto const& samples = sketch.strokes[s].samples;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      total_px += distance(samples[i - 1].position, samples[i].position) * space.to_work;
    }
  }
  StrokeSamples result;
  result.spacing_px = std::max(spacing_px, total_px / kMostSamples);
  result.points.reserve(static_cast<std::size_t>(total_px / result.spacing_px) + 2 * chosen.size());
  for (int const s : chosen) {
    auto const vertices = vertices_of(sketch.strokes[s], space);
    if (!vertices.empty()) append_stroke(vertices, result.spacing_px, s, result.points);
  }
  result.lattice.reserve(result.points.size());
  for (auto const& point : result.points)
    result.lattice.push_back(WorkSpace::lattice_point(point.position));
  return result;
}

void append_chord(Chord const& chord, int stroke, StrokeSamples& samples) {
  double const size = distance(chord.from, chord.to);
  int const steps = static_cast<int>(std::ceil(size / samples.spacing_px));
  for (int k = 1; k < steps; ++k) {
    auto const p = lerp(chord.from, chord.to, static_cast<double>(k) / steps);
    samples.points.push_back(
        {p, (chord.to - chord.from) / size, static_cast<double>(k) / steps, stroke});
    samples.lattice.push_back(WorkSpace::lattice_point(p));
    ++samples.chord_count;
  }
}

}  // namespace inkflate
