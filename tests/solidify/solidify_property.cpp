// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "mesh/check_mesh.h"
#include "solidify/solidify.h"
#include "support/solid_shapes.h"

namespace inkflate {
namespace {

using namespace shapes;

constexpr double kCoarse = 5;

/// Balls, boxes, bars and rings that overlap, touch or lie apart. Made of one number, so a failure is known by its seed.
class Scene {
 public:
  explicit Scene(std::uint64_t seed) : rng_(seed), is_coarse_(rng_.below(4) == 0) {
    for (int i = rng_.below(6); i >= 0; --i) model_ = together(std::move(model_), piece());
    options_.cells = 16 + rng_.below(30);
    options_.least_mm = rng_.uniform(0, 6);
    options_.has_flat_base = rng_.below(2) == 0;
  }

  TriMesh const& model() const { return model_; }
  SolidifyOptions const& options() const { return options_; }

 private:
  /// Rounded coordinates force coincidences.
  double length(double low, double high) {
    double const x = rng_.uniform(low, high);
    return is_coarse_ ? std::ceil(x / kCoarse) * kCoarse : x;
  }
  Vec3 place() {
    double const x = length(-40, 40);
    double const y = length(-40, 40);
    return {x, y, length(-40, 40)};
  }

  TriMesh piece() {
    Vec3 const a = place();
    Vec3 const b = place();
    switch (rng_.below(4)) {
      case 0:
        return sphere(a, length(5, 30), 3);
      case 1:
        return box({std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                   {std::max(a.x, b.x) + 1, std::max(a.y, b.y) + 1, std::max(a.z, b.z) + 1});
      case 2:
        return capsule(a, b, rng_.uniform(0.2, 15), 2);
      default:
        auto ring = torus(length(15, 40), rng_.uniform(0.5, 14), 16);
        for (auto& point : ring.points) point += a;
        return ring;
    }
  }

  Rng rng_;
  bool is_coarse_;
  TriMesh model_;
  SolidifyOptions options_;
};

RC_GTEST_PROP(SolidifyProperty, WhateverOverlapsBecomesPrintable, (std::uint64_t seed)) {
  Scene const scene(seed);
  auto const mesh = solidify(scene.model(), scene.options());
  RC_ASSERT(mesh.has_value());
  auto const check = check_mesh(*mesh);
  RC_ASSERT(check.is_sound());
  RC_ASSERT(check.min.z == 0);
  RC_ASSERT(count_self_crossings(*mesh) == 0);
  RC_ASSERT(least_angle(*mesh) > 0.05);
}

RC_GTEST_PROP(SolidifyProperty, SolidStaysWithinTheModelAndTheLeastThickness,
              (std::uint64_t seed)) {
  Scene const scene(seed);
  auto const mesh = solidify(scene.model(), scene.options());
  RC_ASSERT(mesh.has_value());
  auto const check = check_mesh(*mesh);
  auto const size = check.max - check.min;
  double const room = 2 * std::max(scene.options().least_mm, 200.0 / scene.options().cells);
  RC_ASSERT(std::max({size.x, size.y, size.z}) <= scene.options().longest_mm + room);
}

/// Any finite input ends in a mesh or an error.
RC_GTEST_PROP(SolidifyProperty, TurnedTrianglesEndInAMeshOrAnError, (std::uint64_t seed)) {
  Rng rng(seed);
  auto model = Scene(seed).model();
  auto& turned = model.triangles[rng.below(static_cast<int>(model.triangles.size()))];
  std::swap(turned[0], turned[1]);
  model.points[rng.below(static_cast<int>(model.points.size()))] *= rng.uniform(-1e6, 1e6);
  auto const mesh = solidify(model, {.cells = 16});
  if (mesh) RC_ASSERT(check_mesh(*mesh).is_sound());
}

RC_GTEST_PROP(SolidifyProperty, StretchedPointsEndInAMeshOrAnError, (std::uint64_t seed)) {
  Rng rng(seed);
  auto model = Scene(seed).model();
  for (int i = 0; i < 5; ++i) {
    auto& point = model.points[rng.below(static_cast<int>(model.points.size()))];
    point = point * rng.uniform(-3, 3);
  }
  auto const mesh = solidify(model, {.cells = 24});
  if (mesh) RC_ASSERT(check_mesh(*mesh).is_sound());
  if (mesh) RC_ASSERT(count_self_crossings(*mesh) == 0);
}

}  // namespace
}  // namespace inkflate
