// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <time.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/check.h"
#include "editor/engine.h"
#include "rough_character.h"

namespace inkflate {
namespace {

/// Of this thread alone: a percentile of wall time would tell what other programs did.
double cpu_ms() {
  timespec now = {};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Times of one kind of step.
class Times {
 public:
  void add(double ms) { ms_.push_back(ms); }

  void report(benchmark::State& state, std::string const& name) {
    if (ms_.empty()) return;
    std::sort(ms_.begin(), ms_.end());
    state.counters[name + "_p50_ms"] = at(0.5);
    state.counters[name + "_p95_ms"] = at(0.95);
    state.counters[name + "_most_ms"] = ms_.back();
  }

 private:
  double at(double share) const {
    return ms_[static_cast<std::size_t>(share * static_cast<double>(ms_.size() - 1))];
  }

  std::vector<double> ms_;
};

/// Somebody who draws: the strokes of a rough character, with a pen that reports a hundred times a second.
class Hand {
 public:
  explicit Hand(Engine& engine) : engine_(engine) {}

  void send(PointerAction action, Vec2 place) {
    PointerEvent event;
    event.action = action;
    event.kind = PointerKind::Pen;
    if (action != PointerAction::Move) event.button = PointerButton::Primary;
    event.screen = place;
    time_s_ += 0.01;
    event.time_s = time_s_;
    engine_.handle(event);
  }

  void draw(Stroke const& stroke, Vec2 moved = {}) {
    time_s_ += 1;  // no double click
    auto const& samples = stroke.samples;
    send(PointerAction::Press, samples.front().position + moved);
    for (auto const& sample : samples) send(PointerAction::Move, sample.position + moved);
    send(PointerAction::Release, samples.back().position + moved);
  }

 private:
  Engine& engine_;
  double time_s_ = 0;
};

/// An engine with so many loose strokes on its canvas.
Engine drawn(Sketch const& sketch) {
  Engine engine;
  engine.handle(ResizeEvent{1024, 1024});
  Hand hand(engine);
  for (auto const& stroke : sketch.strokes) hand.draw(stroke);
  return engine;
}

void finish_work(Engine& engine) {
  while (engine.has_work()) engine.work();
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

std::size_t used_bytes() {
  auto const info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

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
