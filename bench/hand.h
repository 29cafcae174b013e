// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <benchmark/benchmark.h>

#include <span>
#include <string>
#include <vector>

#include "editor/engine.h"
#include "model/stroke.h"

namespace inkflate {

/// Processor time of this thread alone, ms: a percentile of wall time would tell what other programs did.
double cpu_ms();

/// All that malloc has given and not got back.
std::size_t used_bytes();

/// Times of one kind of step.
class Times {
 public:
  void add(double ms) { ms_.push_back(ms); }

  /// Counters NAME_p50_ms, NAME_p95_ms and NAME_most_ms; none where nothing was measured.
  void report(benchmark::State& state, std::string const& name);

 private:
  std::vector<double> ms_;
};

/// Somebody at an engine, with a pen that reports a hundred times a second.
class Hand {
 public:
  explicit Hand(Engine& engine) : engine_(engine) {}

  /// place: px of the screen
  Changes send(PointerAction action, Vec2 place);
  /// So much later that no two presses are a double click.
  void wait() { time_s_ += 1; }
  void draw(Stroke const& stroke, Vec2 moved = {});

 private:
  Engine& engine_;
  double time_s_ = 0;
};

void finish_work(Engine& engine);

}  // namespace inkflate
