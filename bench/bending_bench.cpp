// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/check.h"
#include "editor/pick_bend.h"
#include "hand.h"

namespace inkflate {
namespace {

constexpr int kMoves = 40;
// Less is a click.
constexpr double kTakesHoldPx = 5;
// Of two places that a hand would not take for one.
constexpr double kElsewherePx = 100;

/// A drawing of the examples, simplified where it is rough, with the Deform tool in the hand.
Engine opened(std::string const& name) {
  Engine engine;
  engine.handle(ResizeEvent{1024, 1024});
  std::ifstream stream(INKFLATE_SOURCE_DIR "/examples/" + name, std::ios::binary);
  std::vector<char> const content{std::istreambuf_iterator<char>(stream), {}};
  auto const bytes = std::as_bytes(std::span(content));
  engine.handle(FileEvent{{bytes.begin(), bytes.end()}, name});
  engine.handle(ActionEvent{"simplify"});
  engine.handle(ActionEvent{"deform"});
  CHECK(!engine.document().layers->empty(), "the drawings of the benchmark have parts");
  finish_work(engine);
  return engine;
}

/// On the line of the largest part, where no other hides it: its limbs hang on it. So far away from a place at least.
Vec2 place_to_hold(Engine const& engine, Vec2 from = {}, double least_px = 0) {
  auto const& document = engine.document();
  Layer const* host = nullptr;
  double largest = 0;
  for (auto const& layer : *document.layers) {
    Rect box;
    for (auto const& piece : layer->layer.outlines.front().pieces)
      box = united(box, bounds(piece.curve.control));
    if (box.width() * box.height() <= largest) continue;
    largest = box.width() * box.height();
    host = &layer->layer;
  }
  CHECK(host != nullptr, "a part with an area");
  for (auto const& piece : host->outlines.front().pieces) {
    auto const place = point_at(piece.curve, 0.5);
    if (distance(place, from) < least_px) continue;
    auto const hit = pick_to_bend(document, place, 1, PickDepth::Nearest);
    if (hit && hit->is_on_line && hit->what.layer == host->id) return place;
  }
  CHECK(false, "a part that can be held");
}

/// Somebody who bends, and what each kind of step takes until the scene shows it.
class Bending {
 public:
  explicit Bending(Engine& engine)
      : engine_(engine), hand_(engine), start_(place_to_hold(engine)) {}

  /// Takes the tool anew: no part is known.
  void take_tool() {
    engine_.handle(ActionEvent{"brush"});
    engine_.handle(ActionEvent{"deform"});
    wait();
  }

  /// One drag by this much, of the place where the first one began. is_first: no part is known.
  void drag(Vec2 way, bool is_first) { drag(start_, way, is_first ? press_ : press_again_); }

  /// One drag that ends with another place in the hand than the last one, whose place no pin holds.
  void drag_elsewhere(Vec2 way) {
    drag(place_to_hold(engine_, start_ + way, kElsewherePx), way, press_elsewhere_);
  }

  void undo() {
    timed(undo_, [&] { engine_.handle(ActionEvent{"undo"}); });
  }

  void report(benchmark::State& state) {
    idle_.report(state, "idle");
    press_.report(state, "press");
    press_again_.report(state, "press_again");
    press_elsewhere_.report(state, "press_elsewhere");
    move_.report(state, "move");
    settle_.report(state, "settle");
    release_.report(state, "release");
    undo_.report(state, "undo");
    state.counters["journal_bytes"] = static_cast<double>(journal_bytes_);
  }

 private:
  void wait() {
    while (engine_.has_work()) timed(idle_, [&] { engine_.work(); });
  }

  void drag(Vec2 place, Vec2 way, Times& press) {
    wait();
    auto const view = engine_.state().view;
    auto const start = canvas_to_screen(view.camera, view.size)(place);
    hand_.wait();
    timed(press, [&] {
      hand_.send(PointerAction::Press, start);
      hand_.send(PointerAction::Move, start + normalized(way) * kTakesHoldPx);
    });
    for (int i = 1; i <= kMoves; ++i) {
      timed(move_, [&] {
        hand_.send(PointerAction::Move, start + way * i / kMoves);
        engine_.work();
      });
    }
    while (engine_.has_work()) timed(settle_, [&] { engine_.work(); });
    timed(release_,
          [&] { journal_bytes_ = hand_.send(PointerAction::Release, start + way).journal.size(); });
  }

  template <typename Step>
  void timed(Times& times, Step step) {
    double const start = cpu_ms();
    step();
    benchmark::DoNotOptimize(engine_.scene().chunks.data());
    times.add(cpu_ms() - start);
  }

  Engine& engine_;
  Hand hand_;
  Vec2 start_;
  Times idle_;
  Times press_;
  Times press_again_;
  Times press_elsewhere_;
  Times move_;
  Times settle_;
  Times release_;
  Times undo_;
  std::size_t journal_bytes_ = 0;
};

/// A drag of the largest part of a drawing, with all that hangs on it.
void bending(benchmark::State& state, std::string const& name) {
  auto engine = opened(name);
  Bending person(engine);
  for ([[maybe_unused]] auto const iteration : state) {
    person.take_tool();
    person.drag({60, 80}, true);
    person.drag_elsewhere({60, 80});
    person.undo();
    person.undo();
    person.drag({-40, 70}, false);
    person.undo();
  }
  person.report(state);
}
BENCHMARK_CAPTURE(bending, dog, "characters/dog.svg")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bending, octopus, "sketches/octopus.svg")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bending, seahorse, "sketches/seahorse.svg")->Unit(benchmark::kMillisecond);

/// What each drag of a long session takes in all versions of the document together.
void bending_memory(benchmark::State& state) {
  constexpr int drags = 500;
  for ([[maybe_unused]] auto const iteration : state) {
    auto engine = opened("characters/dog.svg");
    Bending person(engine);
    auto const before = used_bytes();
    for (int i = 0; i < drags; ++i) {
      double const sign = i % 2 == 0 ? 1 : -1;
      person.drag(sign * Vec2{20.0 + i % 7, 25.0 + i % 5}, false);
    }
    state.counters["bytes_per_drag"] = static_cast<double>(used_bytes() - before) / drags;
    person.report(state);
  }
}
BENCHMARK(bending_memory)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace inkflate
