// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assemble/assemble.h"
#include "base/progress.h"
#include "base/result.h"
#include "model/drawing.h"
#include "model/rest_model.h"

namespace inkflate {

struct RunInflateOptions {
  AssembleOptions assemble;
};

/// From closed contours to the model in its rest pose: assemble, then inflate.
///
/// errors  those of its stages
Result<RestModel> run_inflate(Drawing const& drawing, RunInflateOptions const& options = {},
                              Progress const& progress = {});

}  // namespace inkflate
