// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "document/apply.h"
#include "pipeline/shape_previewer.h"
#include "rough_character.h"

namespace inkflate {
namespace {

/// The strokes loose on a sheet.
Document sheet_of(Sketch const& sketch) {
  auto document = empty_document();
  for (auto const& stroke : sketch.strokes) {
    auto next = apply(document, AddStroke{stroke});
    CHECK(next.has_value(), "the drawings of the benchmark are legal");
    document = *std::move(next);
  }
  return document;
}

double at_share(std::vector<double> const& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void count_times(benchmark::State& state, std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  state.counters["p50_ms"] = at_share(ms, 0.5);
  state.counters["p95_ms"] = at_share(ms, 0.95);
}

template <typename Work>
double time_ms(Work work) {
  auto const start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

/// A preview of so many loose strokes that have all changed. Budget: 10 ms at p95 for 1000.
void preview_all(benchmark::State& state) {
  auto const document = sheet_of(rough_character(static_cast<int>(state.range(0))));
  std::vector<double> ms;
  for ([[maybe_unused]] auto const iteration : state)
    ms.push_back(time_ms([&] { benchmark::DoNotOptimize(preview_shape(document)); }));
  count_times(state, std::move(ms));
}
BENCHMARK(preview_all)->Arg(250)->Arg(1000)->Arg(4000)->Unit(benchmark::kMillisecond);

/// The same when only the far strokes, a fifth of all, have changed since the last preview.
void preview_far(benchmark::State& state) {
  auto sketch = rough_character(static_cast<int>(state.range(0)));
  for (std::size_t i = 0; i < sketch.strokes.size(); i += 5)
    sketch.strokes[i].depth = StrokeDepth::Far;
  auto const document = sheet_of(sketch);
  auto const added = apply(document, AddStroke{sketch.strokes.front()});
  CHECK(added.has_value(), "the drawings of the benchmark are legal");
  ShapePreviewer previewer;
  std::vector<double> ms;
  for ([[maybe_unused]] auto const iteration : state) {
    auto const& next = ms.size() % 2 == 0 ? document : *added;
    ms.push_back(time_ms([&] { benchmark::DoNotOptimize(previewer.preview(next)); }));
  }
  count_times(state, std::move(ms));
}
BENCHMARK(preview_far)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace inkflate
