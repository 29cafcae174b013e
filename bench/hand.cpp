// SPDX-License-Identifier: Apache-2.0
#include "hand.h"

#include <malloc.h>
#include <time.h>

#include <algorithm>

namespace inkflate {

double cpu_ms() {
  timespec now = {};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

std::size_t used_bytes() {
  auto const info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

void Times::report(benchmark::State& state, std::string const& name) {
  if (ms_.empty()) return;
  std::sort(ms_.begin(), ms_.end());
  auto const at = [&](double share) {
    return ms_[static_cast<std::size_t>(share * static_cast<double>(ms_.size() - 1))];
  };
  state.counters[name + "_p50_ms"] = at(0.5);
  state.counters[name + "_p95_ms"] = at(0.95);
  state.counters[name + "_most_ms"] = ms_.back();
}

Changes Hand::send(PointerAction action, Vec2 place) {
  PointerEvent event;
  event.action = action;
  event.kind = PointerKind::Pen;
  if (action != PointerAction::Move) event.button = PointerButton::Primary;
  event.screen = place;
  time_s_ += 0.01;
  event.time_s = time_s_;
  return engine_.handle(event);
}

void Hand::draw(Stroke const& stroke, Vec2 moved) {
  wait();
  auto const& samples = stroke.samples;
  send(PointerAction::Press, samples.front().position + moved);
  for (auto const& sample : samples) send(PointerAction::Move, sample.position + moved);
  send(PointerAction::Release, samples.back().position + moved);
}

void finish_work(Engine& engine) {
  while (engine.has_work()) engine.work();
}

}  // namespace inkflate
