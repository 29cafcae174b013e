// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <string>

#include "base/check.h"
#include "editor/engine.h"
#include "hand.h"
#include "rough_character.h"

namespace inkflate {
namespace {

/// An engine with so many loose strokes on its canvas.
Engine drawn(Sketch const& sketch) {
  Engine engine;
  engine.handle(ResizeEvent{1024, 1024});
  Hand hand(engine);
  for (auto const& stroke : sketch.strokes) hand.draw(stroke);
  return engine;
}

/// From a pointer event to the scene that shows it, while a stroke is drawn among many.
void editor_pointer(benchmark::State& state) {
  auto const sketch = rough_character(static_cast<int>(state.range(0)));
  auto engine = drawn(sketch);
  finish_work(engine);
  Hand hand(engine);
  Times pointer;
  Times release;
  auto const timed = [&](Times& times, PointerAction action, Vec2 place) {
    double const start = cpu_ms();
    hand.send(action, place);
    benchmark::DoNotOptimize(engine.scene().chunks.data());
    times.add(cpu_ms() - start);
  };
  for ([[maybe_unused]] auto const iteration : state) {
    for (int i = 0; i < 10; ++i) {
      auto const& samples = sketch.strokes[static_cast<std::size_t>(i)].samples;
      timed(pointer, PointerAction::Press, samples.front().position);
      for (auto const& sample : samples) timed(pointer, PointerAction::Move, sample.position);
      timed(release, PointerAction::Release, samples.back().position);
    }
    state.PauseTiming();
    for (int i = 0; i < 10; ++i) engine.handle(ActionEvent{"undo"});
    state.ResumeTiming();
  }
  pointer.report(state, "pointer");
  release.report(state, "release");
}
BENCHMARK(editor_pointer)->Arg(250)->Arg(1000)->Unit(benchmark::kMillisecond);

/// The closed shape that is shown after each stroke.
void editor_preview(benchmark::State& state) {
  auto const sketch = rough_character(static_cast<int>(state.range(0)));
  auto engine = drawn(sketch);
  Hand hand(engine);
  Times times;
  std::size_t next = 0;
  for ([[maybe_unused]] auto const iteration : state) {
    hand.draw(sketch.strokes[next++ % sketch.strokes.size()]);
    double const start = cpu_ms();
    finish_work(engine);
    times.add(cpu_ms() - start);
  }
  times.report(state, "preview");
}
BENCHMARK(editor_preview)->Arg(250)->Arg(1000)->Unit(benchmark::kMillisecond);

/// Undo with the scene that shows it.
void editor_undo(benchmark::State& state) {
  auto engine = drawn(rough_character(static_cast<int>(state.range(0))));
  Times undo;
  Times redo;
  auto const timed = [&](Times& times, char const* name) {
    double const start = cpu_ms();
    engine.handle(ActionEvent{name});
    benchmark::DoNotOptimize(engine.scene().chunks.data());
    times.add(cpu_ms() - start);
  };
  for ([[maybe_unused]] auto const iteration : state) {
    for (int i = 0; i < 100; ++i) timed(undo, "undo");
    for (int i = 0; i < 100; ++i) timed(redo, "redo");
  }
  undo.report(state, "undo");
  redo.report(state, "redo");
}
BENCHMARK(editor_undo)->Arg(1000)->Unit(benchmark::kMillisecond);

/// Enter, as a person waits for it.
void editor_simplify(benchmark::State& state) {
  auto engine = drawn(rough_character(static_cast<int>(state.range(0))));
  Times times;
  for ([[maybe_unused]] auto const iteration : state) {
    double const start = cpu_ms();
    engine.handle(ActionEvent{"simplify"});
    times.add(cpu_ms() - start);
    CHECK(!engine.document().layers->empty(), "the drawings of the benchmark close");
    state.PauseTiming();
    engine.handle(ActionEvent{"undo"});
    state.ResumeTiming();
  }
  times.report(state, "simplify");
}
BENCHMARK(editor_simplify)->Arg(250)->Arg(1000)->Unit(benchmark::kMillisecond);

/// What every version of a long drawing takes, beside the samples of its strokes.
void editor_memory(benchmark::State& state) {
  auto const sketch = rough_character(1000);
  int const count = static_cast<int>(state.range(0));
  for ([[maybe_unused]] auto const iteration : state) {
    auto const before = used_bytes();
    Engine engine;
    engine.handle(ResizeEvent{1024, 1024});
    Hand hand(engine);
    for (int i = 0; i < count; ++i) {
      // Nobody draws the same twice.
      double const aside_px = 0.01 * i / 1000;
      hand.draw(sketch.strokes[static_cast<std::size_t>(i) % sketch.strokes.size()],
                {aside_px, aside_px});
    }
    CHECK(engine.history().position() == count, "each stroke is an entry of the history");
    std::size_t sample_bytes = 0;
    engine.document().loose.for_each([&](Shared<KeptStroke> const& kept) {
      sample_bytes += kept->stroke.samples.size() * sizeof(Sample);
    });
    auto const bytes = static_cast<double>(used_bytes() - before);
    state.counters["bytes_per_stroke"] = bytes / count;
    state.counters["beside_samples"] = (bytes - static_cast<double>(sample_bytes)) / count;
  }
}
BENCHMARK(editor_memory)->Arg(1000)->Arg(10'000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace inkflate
