// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "deform/body_solver.h"
#include "deform/wire_solver.h"
#include "deform/wire_strip.h"
#include "fixed_point.h"
#include "local_global.h"
#include "support/bend_meshes.h"

namespace inkflate {
namespace {

constexpr int kFrames = 20;
constexpr Vec2 kDrag = {-60, -143};  // 155 px: up, and towards the head
// The tip of an arm is dragged; a foot and a hip are pinned; the other arm is what a pin is put on and taken off.
constexpr Vec2 kHand = {920, 230};
constexpr std::array<Vec2, 2> kPins = {{{325, 905}, {650, 560}}};
constexpr Vec2 kOtherPin = {80, 230};

/// Of this thread alone.
double cpu_ms() {
  timespec now = {};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  auto const middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// One way to bend one mesh.
struct Method {
  BendMesh const& mesh;
  int frame_steps = 1;  // for each move of the hand
  std::function<void(BendPose&, BendHold const&, int steps)> step;
  std::function<BendPose(BendPose, BendHold const&)> minimum;
};

BendHandle at_rest(BendMesh const& mesh, Vec2 place) {
  int const v = support::nearest_vertex(mesh.rest, place);
  return {support::anchor_of(mesh.rest, v), mesh.rest.points[v]};
}

std::vector<BendHandle> held(BendMesh const& mesh, double share) {
  std::vector<BendHandle> handles;
  for (auto const place : kPins) handles.push_back(at_rest(mesh, place));
  handles.push_back(at_rest(mesh, kHand));
  handles.back().target += kDrag * share;
  return handles;
}

struct Drag {
  BendPose pose;
  std::vector<double> frames_ms;
};

Drag dragged(Method const& method) {
  Drag drag = {method.mesh.rest.points, {}};
  for (int frame = 1; frame <= kFrames; ++frame) {
    auto const handles = held(method.mesh, static_cast<double>(frame) / kFrames);
    double const start = cpu_ms();
    method.step(drag.pose, {handles, {}}, method.frame_steps);
    drag.frames_ms.push_back(cpu_ms() - start);
  }
  return drag;
}

/// What a step takes longer when a pin has come or gone.
double pin_change_ms(Method const& method, BendPose const& pose) {
  auto const without = held(method.mesh, 1.1);
  auto with = without;
  with.insert(with.begin(), at_rest(method.mesh, kOtherPin));
  std::vector<double> changed;
  std::vector<double> same;
  for (int i = 0; i < 40; ++i) {
    bool const is_change = i % 2 == 0;
    auto const& handles = i % 4 < 2 ? with : without;
    auto next = pose;
    double const start = cpu_ms();
    method.step(next, {handles, {}}, 1);
    (is_change ? changed : same).push_back(cpu_ms() - start);
  }
  return std::max(0.0, median(changed) - median(same));
}

double largest_on_lines(BendMesh const& mesh, BendPose const& a, BendPose const& b) {
  double largest = 0;
  for (auto const& line : mesh.lines)
    for (int const v : line.vertices) largest = std::max(largest, distance(a[v], b[v]));
  return largest;
}

/// Which part of the figure a place belongs to.
int part_of(Vec2 rest) {
  if (rest.y < 270) return rest.x < 350 ? 0 : (rest.x > 650 ? 1 : 2);
  if (rest.y < 420) return rest.x < 350 ? 0 : (rest.x > 650 ? 1 : 3);
  if (rest.y < 620) return 3;
  return rest.x < 500 ? 4 : 5;
}

/// How far the points of each part are from the rigid motion of the part that fits best, on the average, px.
double shape_error(Contour const& rest, Contour const& now) {
  double sum = 0;
  for (int part = 0; part < 6; ++part) {
    Vec2 from;
    Vec2 to;
    double count = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (part_of(rest[i]) != part) continue;
      from += rest[i];
      to += now[i];
      ++count;
    }
    from = from / count;
    to = to / count;
    Vec2 turn;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (part_of(rest[i]) != part) continue;
      turn += {dot(rest[i] - from, now[i] - to), cross(rest[i] - from, now[i] - to)};
    }
    turn = normalized(turn);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (part_of(rest[i]) != part) continue;
      Vec2 const p = rest[i] - from;
      sum += distance(Vec2{turn.x * p.x - turn.y * p.y, turn.x * p.y + turn.y * p.x}, now[i] - to);
    }
  }
  return sum / static_cast<double>(rest.size());
}

Contour line_places(BendMesh const& mesh, BendPose const& pose) {
  Contour result;
  for (int const v : mesh.lines[0].vertices) result.push_back(pose[v]);
  return result;
}

void measure(benchmark::State& state, Method const& method) {
  std::vector<double> frames_ms;
  Drag drag;
  for ([[maybe_unused]] auto const iteration : state) {
    drag = dragged(method);
    frames_ms.insert(frames_ms.end(), drag.frames_ms.begin(), drag.frames_ms.end());
  }
  auto const handles = held(method.mesh, 1);
  auto const minimum = method.minimum(drag.pose, {handles, {}});
  auto const& rest = method.mesh.rest.points;
  state.counters["vertices"] = static_cast<double>(rest.size());
  state.counters["frame_ms"] = median(frames_ms);
  state.counters["pin_ms"] = pin_change_ms(method, drag.pose);
  state.counters["off_px"] = largest_on_lines(method.mesh, drag.pose, minimum);
  state.counters["shape_px"] =
      shape_error(line_places(method.mesh, rest), line_places(method.mesh, drag.pose));
}

BendMesh figure(int points) { return support::figure_mesh(points); }

BendMesh strip(int points) {
  auto const filled = figure(points);
  auto const contour = line_places(filled, filled.rest.points);
  return wire_strip(std::span(&contour, 1), 0);
}

void deform_body(benchmark::State& state) {
  auto const mesh = figure(static_cast<int>(state.range(0)));
  BodySolver solver(mesh);
  auto const step = [&](BendPose& pose, BendHold const& hold, int steps) {
    solver.step(pose, hold, steps);
  };
  measure(state, {mesh, 2, step, [&](BendPose pose, BendHold const& hold) {
                    step(pose, hold, 300);
                    return pose;
                  }});
}

void deform_wire(benchmark::State& state) {
  auto const mesh = strip(static_cast<int>(state.range(0)));
  WireSolver solver(mesh);
  auto const step = [&](BendPose& pose, BendHold const& hold, int steps) {
    solver.step(pose, hold, steps);
  };
  measure(state, {mesh, 10, step, [&](BendPose const& pose, BendHold const& hold) {
                    return fixed_point(
                        pose, [&](BendPose& p) { step(p, hold, 1); },
                        [&](std::span<Vec2 const> p) { return solver.energy(p); }, 3000);
                  }});
}

void measure_local_global(benchmark::State& state, BendMesh const& mesh) {
  LocalGlobal solver(mesh.rest);
  auto const step = [&](BendPose& pose, BendHold const& hold, int steps) {
    std::vector<int> vertices;
    std::vector<Vec2> targets;
    for (auto const& [anchor, target, turn] : hold.handles) {
      for (int k = 0; k < 3; ++k)
        if (anchor.weights[k] == 1) vertices.push_back(mesh.rest.triangles[anchor.triangle][k]);
      targets.push_back(target);
    }
    solver.hold(vertices);
    solver.iterate(pose, targets, steps);
  };
  measure(state, {mesh, 10, step, [&](BendPose const& pose, BendHold const& hold) {
                    return fixed_point(
                        pose, [&](BendPose& p) { step(p, hold, 1); },
                        [&](std::span<Vec2 const> p) { return solver.energy(p); }, 3000);
                  }});
}

void deform_local_global_strip(benchmark::State& state) {
  measure_local_global(state, strip(static_cast<int>(state.range(0))));
}

void deform_local_global_filled(benchmark::State& state) {
  measure_local_global(state, figure(static_cast<int>(state.range(0))));
}

/// Schaefer, McPhail, Warren 2006, "Image Deformation Using Moving Least Squares", rigid, with 1 / distance^2.
Vec2 moved_by_least_squares(Vec2 place, std::span<Vec2 const> from, std::span<Vec2 const> to) {
  Vec2 from_sum;
  Vec2 to_sum;
  double weights = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] == place) return to[i];
    double const weight = 1 / squared_norm(place - from[i]);
    from_sum += from[i] * weight;
    to_sum += to[i] * weight;
    weights += weight;
  }
  Vec2 const from_mean = from_sum / weights;
  Vec2 const to_mean = to_sum / weights;
  Vec2 turn;
  for (std::size_t i = 0; i < from.size(); ++i) {
    Vec2 const p = (from[i] - from_mean) / squared_norm(place - from[i]);
    turn += {dot(p, to[i] - to_mean), cross(p, to[i] - to_mean)};
  }
  turn = normalized(turn);
  Vec2 const p = place - from_mean;
  return to_mean + Vec2{turn.x * p.x - turn.y * p.y, turn.x * p.y + turn.y * p.x};
}

void deform_least_squares(benchmark::State& state) {
  auto const mesh = figure(static_cast<int>(state.range(0)));
  auto const rest = line_places(mesh, mesh.rest.points);
  std::vector<Vec2> from;
  std::vector<Vec2> to;
  for (auto const& handle : held(mesh, 0)) from.push_back(handle.target);
  for (auto const& handle : held(mesh, 1)) to.push_back(handle.target);
  Contour now;
  std::vector<double> frames_ms;
  for ([[maybe_unused]] auto const iteration : state) {
    double const start = cpu_ms();
    now.clear();
    for (auto const place : rest) now.push_back(moved_by_least_squares(place, from, to));
    frames_ms.push_back(cpu_ms() - start);
  }
  state.counters["frame_ms"] = median(frames_ms);
  state.counters["shape_px"] = shape_error(rest, now);
}

/// Points along the contour.
void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(100)->Arg(200)->Arg(400)->Arg(1000)->Iterations(3)->Unit(benchmark::kMillisecond);
}
BENCHMARK(deform_body)->Apply(sizes);
BENCHMARK(deform_wire)->Apply(sizes);
BENCHMARK(deform_local_global_filled)->Apply(sizes);
BENCHMARK(deform_local_global_strip)->Apply(sizes);
BENCHMARK(deform_least_squares)->Apply(sizes);

}  // namespace
}  // namespace inkflate
