// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <malloc.h>

#include "base/check.h"
#include "base/rng.h"
#include "document/apply.h"
#include "document/history.h"

namespace inkflate {
namespace {

constexpr int kSamples = 30;

Stroke random_stroke(Rng& rng) {
  Stroke stroke;
  Vec2 position = {rng.uniform(0, 1000), rng.uniform(0, 1000)};
  for (int i = 0; i < kSamples; ++i) {
    stroke.samples.push_back({position, rng.uniform(), 0.008 * i});
    position += Vec2{rng.uniform(-3, 5), rng.uniform(-3, 5)};
  }
  return stroke;
}

/// A history in which so many strokes were drawn one by one.
History drawn(int stroke_count) {
  Rng rng(1);
  History history(empty_document());
  for (int i = 0; i < stroke_count; ++i) {
    auto const done = history.push({AddStroke{random_stroke(rng), LayerId::None}}, 0);
    CHECK(done.has_value(), "a random stroke is a stroke");
  }
  return history;
}

double heap_bytes() {
  auto const heap = mallinfo2();
  return static_cast<double>(heap.uordblks) + static_cast<double>(heap.hblkhd);
}

/// The whole drawing, with the bytes that every stroke costs beside its samples while all versions are kept.
void document_memory(benchmark::State& state) {
  int const stroke_count = static_cast<int>(state.range(0));
  double bytes = 0;
  for ([[maybe_unused]] auto const iteration : state) {
    double const before = heap_bytes();
    auto const history = drawn(stroke_count);
    benchmark::DoNotOptimize(history.size());
    bytes = heap_bytes() - before;
  }
  state.counters["bytes_per_stroke"] =
      bytes / stroke_count - kSamples * static_cast<double>(sizeof(Sample));
}
BENCHMARK(document_memory)->Arg(1000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

void document_undo_redo(benchmark::State& state) {
  auto history = drawn(10'000);
  for ([[maybe_unused]] auto const iteration : state) {
    history.undo();
    history.redo();
    benchmark::DoNotOptimize(history.document().loose.size());
  }
}
BENCHMARK(document_undo_redo);

void document_add_stroke(benchmark::State& state) {
  Rng rng(2);
  auto const history = drawn(10'000);
  Command const command = AddStroke{random_stroke(rng), LayerId::None};
  for ([[maybe_unused]] auto const iteration : state) {
    auto const next = inkflate::apply(history.document(), command);
    benchmark::DoNotOptimize(next->loose.size());
  }
}
BENCHMARK(document_add_stroke)->Unit(benchmark::kMicrosecond);

/// One step of a dragged eraser, where it meets strokes.
void document_erase_step(benchmark::State& state) {
  auto const history = drawn(static_cast<int>(state.range(0)));
  Command const command = EraseArea{{{500, 500}, {512, 507}}, 12};
  int pieces = 0;
  for ([[maybe_unused]] auto const iteration : state) {
    auto const next = inkflate::apply(history.document(), command);
    CHECK(next.has_value(), "the eraser meets strokes");
    pieces = next->loose.size() - history.document().loose.size();
  }
  state.counters["more_strokes"] = pieces;
}
BENCHMARK(document_erase_step)->Arg(1000)->Arg(10'000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace inkflate
