// SPDX-License-Identifier: Apache-2.0
#include "pipeline/run_inflate.h"

#include "inflate/inflate.h"

namespace inkflate {

Result<RestModel> run_inflate(Drawing const& drawing, RunInflateOptions const& options,
                              Progress const& progress) {
  auto const flat = assemble(drawing, options.assemble, progress);
  if (!flat) return flat.error();
  return inflate(*flat, progress);
}

}  // namespace inkflate
