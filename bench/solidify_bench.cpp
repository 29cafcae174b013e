// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "pipeline/run_inflate.h"
#include "pipeline/stage_clock.h"
#include "solidify/solidify.h"
#include "support/characters.h"

namespace inkflate {
namespace {

/// Milliseconds per stage for a character of five layers, and the triangles of the print.
void solidify_stages(benchmark::State& state) {
  constexpr int layer_count = 5;
  auto const model = run_inflate(character(layer_count));
  CHECK(model.has_value(), "the character of the benchmark inflates");
  SolidifyOptions const options{.cells = static_cast<int>(state.range(0))};
  StageClock clock;
  Progress const none;
  std::size_t triangles = 0;
  for ([[maybe_unused]] auto const iteration : state) {
    auto const solid = solidify(model->mesh, options, clock.timed(none));
    clock.stop();
    CHECK(solid.has_value(), "the character of the benchmark prints");
    triangles = solid->triangles.size();
  }
  using benchmark::Counter;
  double total_ms = 0;
  for (auto const& time : clock.times()) {
    state.counters[time.stage + "_ms"] = Counter(time.ms, Counter::kAvgIterations);
    total_ms += time.ms;
  }
  state.counters["total_ms"] = Counter(total_ms, Counter::kAvgIterations);
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(solidify_stages)->Arg(100)->Arg(160)->Arg(256)->Arg(400)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace inkflate
