// SPDX-License-Identifier: Apache-2.0
#include "simplify/close_strokes.h"
#include "simplify/cut_parts.h"

namespace inkflate {

Result<std::vector<Layer>> close_by_cut(Sketch const& sketch, std::span<int const> chosen,
                                        WorkSpace const& space, SimplifyOptions const& options,
                                        Progress const& progress) {
  if (!progress.enter("sample")) return Error{ErrorCode::Cancelled, "stopped on request"};
  auto const cut = cut_parts(sketch, sample_strokes(sketch, chosen, space, kCutSpacingPx), space,
                             options, progress);
  if (!cut) return cut.error();
  return fit_parts(*cut, space, options.smooth, progress);
}

}  // namespace inkflate
