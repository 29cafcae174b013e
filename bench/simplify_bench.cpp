// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <chrono>
#include <numeric>

#include "pipeline/stage_clock.h"
#include "rough_character.h"
#include "simplify/simplify.h"
#include "simplify/stroke_samples.h"

namespace inkflate {
namespace {

// What simplify resamples strokes to, work px; here only to tell how large a drawing is.
constexpr double kSpacingPx = 2.5;

double sample_count(Sketch const& sketch) {
  std::vector<int> all(sketch.strokes.size());
  std::iota(all.begin(), all.end(), 0);
  Rect box;
  for (auto const& stroke : sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  return static_cast<double>(
      sample_strokes(sketch, all, WorkSpace::around(box), kSpacingPx).points.size());
}

/// Simplifies once; the time of each stage is added to the clock.
void simplify_timed(Sketch const& sketch, SimplifyMethod method, StageClock& clock) {
  Progress const none;
  auto const drawing = simplify(sketch, {.method = method}, clock.timed(none));
  clock.stop();
  CHECK(drawing.has_value(), "the drawings of the benchmark close");
  benchmark::DoNotOptimize(drawing->layers.data());
}

double total_ms(StageClock const& clock) {
  double sum = 0;
  for (auto const& time : clock.times()) sum += time.ms;
  return sum;
}

double time_of(StageClock const& clock, std::string_view stage) {
  for (auto const& time : clock.times()) {
    if (time.stage == stage) return time.ms;
  }
  return 0;
}

/// Milliseconds per stage, and how many samples there are.
void simplify_stages(benchmark::State& state) {
  Sketch const sketch = rough_character(static_cast<int>(state.range(0)));
  StageClock clock;
  for ([[maybe_unused]] auto const iteration : state)
    simplify_timed(sketch, SimplifyMethod::Cut, clock);
  using benchmark::Counter;
  for (auto const& time : clock.times())
    state.counters[time.stage + "_ms"] = Counter(time.ms, Counter::kAvgIterations);
  state.counters["total_ms"] = Counter(total_ms(clock), Counter::kAvgIterations);
  state.counters["samples"] = sample_count(sketch);
}
BENCHMARK(simplify_stages)->Arg(50)->Arg(250)->Arg(1000)->Unit(benchmark::kMillisecond);

/// Both methods on the same drawing in turn, so that whatever else the machine does meets both.
void simplify_cut_against_grid(benchmark::State& state) {
  constexpr int stroke_count = 250;
  Sketch const sketch = rough_character(stroke_count, static_cast<double>(state.range(0)));
  StageClock cut;
  StageClock grid;
  for ([[maybe_unused]] auto const iteration : state) {
    simplify_timed(sketch, SimplifyMethod::Cut, cut);
    simplify_timed(sketch, SimplifyMethod::Grid, grid);
  }
  using benchmark::Counter;
  state.counters["cut_ms"] = Counter(total_ms(cut), Counter::kAvgIterations);
  state.counters["grid_ms"] = Counter(total_ms(grid), Counter::kAvgIterations);
  state.counters["grid_min_cut_ms"] = Counter(time_of(grid, "cut pixels"), Counter::kAvgIterations);
  state.counters["grid_over_cut"] = total_ms(grid) / total_ms(cut);
  state.counters["min_cut_over_cut"] = time_of(grid, "cut pixels") / total_ms(cut);
}
BENCHMARK(simplify_cut_against_grid)->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);

/// How the time grows with the number of samples.
void simplify_growth(benchmark::State& state) {
  Sketch const sketch = rough_character(static_cast<int>(state.range(0)));
  StageClock clock;
  for ([[maybe_unused]] auto const iteration : state)
    simplify_timed(sketch, SimplifyMethod::Cut, clock);
  double const samples = sample_count(sketch);
  state.counters["samples"] = samples;
  state.SetComplexityN(static_cast<benchmark::IterationCount>(samples));
}
BENCHMARK(simplify_growth)
    ->Arg(50)
    ->Arg(100)
    ->RangeMultiplier(2)
    ->Range(250, 4000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);

}  // namespace
}  // namespace inkflate
