// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "geometry/crossings.h"
#include "mesh/mesh_region.h"
#include "pipeline/place_sketch.h"
#include "simplify/simplify.h"
#include "support/regions.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

RC_GTEST_PROP(MeshRegion, EveryLawHoldsOrTheRegionCrossesItself, (std::uint64_t seed)) {
  auto const region = random_region(seed);
  auto const mesh = mesh_region(region);
  if (mesh) RC_ASSERT(what_is_wrong(region, *mesh) == std::string());
  bool const is_crossed = !find_crossings(region.contours, 1).empty();
  if (is_crossed) RC_ASSERT(!mesh.has_value());
  if (mesh || is_crossed || !region.seams.empty()) return;
  RC_ASSERT(region.contours.size() == 2U);
  RC_ASSERT(!contains(region.contours[0], region.contours[1][0]));
}

RC_GTEST_PROP(MeshRegion, WhatSimplifyMakesIsMeshed, (std::uint64_t seed)) {
  auto const sketch = place_sketch(random_sketch(seed), {1000.0, PlaceMode::FitStrokes});
  RC_PRE(sketch.has_value());
  auto const drawing = simplify(*sketch);
  RC_PRE(drawing.has_value());
  for (auto const& layer : drawing->layers) {
    auto const region = region_of(layer);
    RC_PRE(find_crossings(region.contours, 1).empty());
    auto const mesh = mesh_region(region);
    RC_ASSERT(mesh.has_value());
    RC_ASSERT(what_is_wrong(region, *mesh) == std::string());
  }
}

}  // namespace
}  // namespace inkflate
