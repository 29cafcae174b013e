// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "base/check.h"
#include "deform/bender.h"
#include "deform/body_solver.h"
#include "deform/wire_solver.h"
#include "deform/wire_strip.h"
#include "figure_drag.h"
#include "fixed_point.h"
#include "local_global.h"
#include "support/bend_meshes.h"

namespace inkflate {
namespace {

constexpr int kFrames = 20;
// For each move of the hand.
constexpr int kNewtonSteps = 2;
constexpr int kIterations = 10;
// Enough to tell where the minimum is.
constexpr int kManyNewtonSteps = 200;
constexpr int kManyIterations = 1500;

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

std::vector<Vec2> line_places(BendMesh const& mesh, BendPose const& pose) {
  std::vector<Vec2> result;
  for (int const v : mesh.lines[0].vertices) result.push_back(pose[v]);
  return result;
}

/// Drags from rest; the time of each frame is added.
BendPose dragged(Method const& method, std::vector<double>& frames_ms) {
  auto pose = method.mesh.rest.points;
  for (int frame = 1; frame <= kFrames; ++frame) {
    auto const handles = figure_handles(method.mesh, static_cast<double>(frame) / kFrames);
    double const start = cpu_ms();
    method.step(pose, {handles, {}}, method.frame_steps);
    frames_ms.push_back(cpu_ms() - start);
  }
  return pose;
}

/// What a step takes longer when a pin has come or gone.
double pin_change_ms(Method const& method, BendPose const& pose) {
  auto const without = figure_handles(method.mesh, 1.1);
  auto with = without;
  with.insert(with.begin(), figure_pin(method.mesh));
  std::vector<double> changed;
  std::vector<double> same;
  for (int i = 0; i < 40; ++i) {
    auto const& handles = i % 4 < 2 ? with : without;
    auto next = pose;
    double const start = cpu_ms();
    method.step(next, {handles, {}}, 1);
    (i % 2 == 0 ? changed : same).push_back(cpu_ms() - start);
  }
  return std::max(0.0, median(changed) - median(same));
}

BendPose measure(benchmark::State& state, Method const& method) {
  std::vector<double> frames_ms;
  BendPose pose;
  for ([[maybe_unused]] auto const iteration : state) pose = dragged(method, frames_ms);
  auto const rest = line_places(method.mesh, method.mesh.rest.points);
  auto const line = line_places(method.mesh, pose);
  auto const handles = figure_handles(method.mesh, 1);
  auto const least = line_places(method.mesh, method.minimum(pose, {handles, {}}));
  double off_px = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    off_px = std::max(off_px, distance(line[i], least[i]));
  state.counters["vertices"] = static_cast<double>(pose.size());
  state.counters["frame_ms"] = median(frames_ms);
  state.counters["pin_ms"] = pin_change_ms(method, pose);
  state.counters["off_px"] = off_px;
  state.counters["shape_px"] = figure_shape_error(rest, line);
  return pose;
}

/// By so many Newton steps, or by iterations that are helped along.
template <class Solver>
Method method_of(BendMesh const& mesh, Solver& solver, BendMode mode) {
  auto const step = [&solver](BendPose& pose, BendHold const& hold, int steps) {
    solver.step(pose, hold, steps);
  };
  if (mode == BendMode::Body) {
    return {mesh, kNewtonSteps, step, [step](BendPose pose, BendHold const& hold) {
              step(pose, hold, kManyNewtonSteps);
              return pose;
            }};
  }
  auto const wire = std::make_shared<WireSolver>(mesh);  // whose energy can be asked for
  return {mesh, kIterations, step, [step, wire](BendPose const& pose, BendHold const& hold) {
            return fixed_point(
                pose, [&](BendPose& p) { step(p, hold, 1); },
                [&](std::span<Vec2 const> p) { return wire->energy(p); }, kManyIterations);
          }};
}

BendMesh filled(benchmark::State const& state) {
  return support::figure_mesh(static_cast<int>(state.range(0)));
}

BendMesh strip(benchmark::State const& state) {
  auto const contour = figure_contour(static_cast<int>(state.range(0)));
  return wire_strip(std::span(&contour, 1), 0);
}

/// As the tool does it: with a mesh of its own, and from pose to outline.
void measure_bender(benchmark::State& state, BendMode mode) {
  auto const outline = figure_outline(static_cast<int>(state.range(0)));
  double const start = cpu_ms();
  auto bender = Bender::make({{outline}, {}}, {mode});
  CHECK(bender.has_value(), "a figure that can be bent");
  state.counters["make_ms"] = cpu_ms() - start;
  auto const pose = measure(state, method_of(bender->mesh(), *bender, mode));
  std::vector<double> bent_ms;
  for (int i = 0; i < 9; ++i) {
    double const before = cpu_ms();
    benchmark::DoNotOptimize(bender->bent(pose).outlines.data());
    bent_ms.push_back(cpu_ms() - before);
  }
  state.counters["bent_ms"] = median(bent_ms);
}

void deform_bender_body(benchmark::State& state) { measure_bender(state, BendMode::Body); }
void deform_bender_wire(benchmark::State& state) { measure_bender(state, BendMode::Wire); }

void deform_body(benchmark::State& state) {
  auto const mesh = filled(state);
  BodySolver solver(mesh);
  measure(state, method_of(mesh, solver, BendMode::Body));
}

void deform_wire(benchmark::State& state) {
  auto const mesh = strip(state);
  WireSolver solver(mesh);
  measure(state, method_of(mesh, solver, BendMode::Wire));
}

/// The handles of a hold as vertices.
void iterate(LocalGlobal& solver, BendMesh const& mesh, BendPose& pose, BendHold const& hold,
             int iterations) {
  std::vector<int> vertices;
  std::vector<Vec2> targets;
  for (auto const& handle : hold.handles) {
    auto const& anchor = handle.anchor;
    auto const corner = std::max_element(anchor.weights.begin(), anchor.weights.end());
    vertices.push_back(mesh.rest.triangles[anchor.triangle][corner - anchor.weights.begin()]);
    targets.push_back(handle.target);
  }
  solver.hold(std::move(vertices));
  solver.iterate(pose, targets, iterations);
}

void measure_local_global(benchmark::State& state, BendMesh const& mesh) {
  LocalGlobal solver(mesh.rest);
  auto const step = [&](BendPose& pose, BendHold const& hold, int steps) {
    iterate(solver, mesh, pose, hold, steps);
  };
  measure(state, {mesh, kIterations, step, [&](BendPose const& pose, BendHold const& hold) {
                    return fixed_point(
                        pose, [&](BendPose& p) { step(p, hold, 1); },
                        [&](std::span<Vec2 const> p) { return solver.energy(p); }, kManyIterations);
                  }});
}

void deform_local_global_filled(benchmark::State& state) {
  measure_local_global(state, filled(state));
}

void deform_local_global_strip(benchmark::State& state) {
  measure_local_global(state, strip(state));
}

void deform_least_squares(benchmark::State& state) {
  auto const mesh = filled(state);
  auto const rest = line_places(mesh, mesh.rest.points);
  std::vector<Vec2> from;
  std::vector<Vec2> to;
  for (auto const& handle : figure_handles(mesh, 0)) from.push_back(handle.target);
  for (auto const& handle : figure_handles(mesh, 1)) to.push_back(handle.target);
  Contour now;
  std::vector<double> frames_ms;
  for ([[maybe_unused]] auto const iteration : state) {
    double const start = cpu_ms();
    now.clear();
    for (auto const place : rest) now.push_back(moved_by_least_squares(place, from, to));
    frames_ms.push_back(cpu_ms() - start);
  }
  state.counters["frame_ms"] = median(frames_ms);
  state.counters["shape_px"] = figure_shape_error(rest, now);
}

/// Points along the contour.
void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(100)->Arg(200)->Arg(400)->Arg(1000)->Iterations(3)->Unit(benchmark::kMillisecond);
}
BENCHMARK(deform_bender_body)->Apply(sizes);
BENCHMARK(deform_bender_wire)->Apply(sizes);
BENCHMARK(deform_body)->Apply(sizes);
BENCHMARK(deform_wire)->Apply(sizes);
BENCHMARK(deform_local_global_filled)->Apply(sizes);
BENCHMARK(deform_local_global_strip)->Apply(sizes);
BENCHMARK(deform_least_squares)->Apply(sizes);

}  // namespace
}  // namespace inkflate
