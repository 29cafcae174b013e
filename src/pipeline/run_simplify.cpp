// SPDX-License-Identifier: Apache-2.0
#include "pipeline/run_simplify.h"

#include <utility>

namespace inkflate {
namespace {

Result<Sketch> drawn_sketch(SketchSource const& source, ScanOptions const& options,
                            Progress const& progress) {
  if (auto const* const picture = std::get_if<Picture>(&source)) {
    return trace_scan(*picture, options, progress);
  }
  return *std::get_if<Sketch>(&source);
}

}  // namespace

Result<Drawing> run_simplify(SketchSource const& source, RunSimplifyOptions const& options,
                             Progress const& progress) {
  auto const drawn = drawn_sketch(source, options.scan, progress);
  if (!drawn) return drawn.error();
  if (!progress.enter("place")) return Error{ErrorCode::Cancelled, "stopped before simplifying"};
  auto const placed = place_sketch(*drawn, options.place);
  if (!placed) return placed.error();
  return simplify(*placed, options.simplify, progress);
}

}  // namespace inkflate
