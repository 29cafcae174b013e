// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "pipeline/run_inflate.h"
#include "pipeline/stage_clock.h"
#include "support/characters.h"

namespace inkflate {
namespace {

/// Milliseconds per stage from contours to the ordered, inflated model, and its size.
void inflate_stages(benchmark::State& state, double density) {
  auto const drawing = character(static_cast<int>(state.range(0)));
  RunInflateOptions options;
  options.assemble.density = density;
  StageClock clock;
  Progress const none;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  for ([[maybe_unused]] auto const iteration : state) {
    auto const model = run_inflate(drawing, options, clock.timed(none));
    clock.stop();
    CHECK(model.has_value(), "the characters of the benchmark inflate");
    vertices = model->mesh.points.size();
    triangles = model->mesh.triangles.size();
  }
  using benchmark::Counter;
  double total_ms = 0;
  for (auto const& time : clock.times()) {
    state.counters[time.stage + "_ms"] = Counter(time.ms, Counter::kAvgIterations);
    total_ms += time.ms;
  }
  state.counters["total_ms"] = Counter(total_ms, Counter::kAvgIterations);
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK_CAPTURE(inflate_stages, layers, 1.0)
    ->Arg(1)
    ->Arg(3)
    ->Arg(5)
    ->Arg(21)
    ->Unit(benchmark::kMillisecond);

/// How the time grows with the number of vertices: one character, meshed ever finer.
void inflate_growth(benchmark::State& state) {
  inflate_stages(state, static_cast<double>(state.range(1)) / 4);
  state.SetComplexityN(static_cast<int>(state.counters["vertices"].value));
}
BENCHMARK(inflate_growth)
    ->ArgsProduct({{5}, {1, 2, 4, 8, 16, 32}})
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
}  // namespace inkflate
