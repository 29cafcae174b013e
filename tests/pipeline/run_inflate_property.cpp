// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mesh/check_mesh.h"
#include "pipeline/run_inflate.h"
#include "simplify/simplify.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// A random sketch whose strokes are dealt out to three groups, so that parts lie on one another in every way.
Sketch grouped_sketch(std::uint64_t seed) {
  auto sketch = random_sketch(seed);
  sketch.groups = {StrokeGroup{"a"}, StrokeGroup{"b"}, StrokeGroup{"c"}};
  int const count = static_cast<int>(std::ssize(sketch.strokes));
  for (int i = 0; i < count; ++i) sketch.strokes[i].group = i * 3 / count;
  return sketch;
}

RC_GTEST_PROP(RunInflate, WhateverSimplifyMakesBecomesASoundModel, (std::uint64_t seed)) {
  SimplifyOptions options;
  options.parts = Parts::Groups;
  auto const drawing = simplify(grouped_sketch(seed), options);
  RC_PRE(drawing.has_value());
  auto const model = run_inflate(*drawing);
  RC_ASSERT(model.has_value());
  auto const found = check_mesh(model->mesh);
  RC_ASSERT(found.is_closed());
  RC_ASSERT(found.is_manifold());
  RC_ASSERT(found.is_oriented());
  RC_ASSERT(found.is_finite());
  RC_ASSERT(found.zero_area_triangles == 0);
  RC_ASSERT(std::ssize(model->canvas) == std::ssize(model->mesh.points));
}

}  // namespace
}  // namespace inkflate
