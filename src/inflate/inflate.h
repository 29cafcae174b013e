// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "model/flat_model.h"
#include "model/rest_model.h"

namespace inkflate {

/// Gives a flat model its depth: every layer becomes round, layers that overlap lie one before the other, joints are smooth.
///
/// in      model: as assemble makes it
/// out     the model's vertices in their order
/// errors  Cancelled
/// cost    see bench/inflate_bench
/// source  docs/algorithms/inflate.md
Result<RestModel> inflate(FlatModel const& model, Progress const& progress = {});

}  // namespace inkflate
