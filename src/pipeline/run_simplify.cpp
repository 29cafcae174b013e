// SPDX-License-Identifier: Apache-2.0
#include "pipeline/run_simplify.h"

#include <utility>

#include "pipeline/stage_clock.h"

namespace inkflate {
namespace {

Result<Sketch> placed_sketch(SketchSource const& source, RunSimplifyOptions const& options,
                             Progress const& progress) {
  auto const* const picture = std::get_if<Picture>(&source);
  if (picture == nullptr) {
    if (!progress.enter("place")) return Error{ErrorCode::Cancelled, "stopped before placing"};
    return place_sketch(*std::get_if<Sketch>(&source), options.place);
  }
  auto const traced = trace_scan(*picture, options.scan, progress);
  if (!traced) return traced.error();
  if (!progress.enter("place")) return Error{ErrorCode::Cancelled, "stopped before placing"};
  return place_sketch(*traced, options.place);
}

}  // namespace

Result<SimplifyRun> run_simplify(SketchSource const& source, RunSimplifyOptions const& options,
                                 Progress const& progress) {
  StageClock clock;
  Progress const timed = clock.timed(progress);
  auto const sketch = placed_sketch(source, options, timed);
  if (!sketch) return sketch.error();
  auto drawing = simplify(*sketch, options.simplify, timed);
  if (!drawing) return drawing.error();
  clock.stop();
  return SimplifyRun{std::move(*drawing), clock.times()};
}

}  // namespace inkflate
