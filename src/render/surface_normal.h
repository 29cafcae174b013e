// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/sample_band.h"

namespace inkflate {

/// The normal of a triangle at a place of the sample grid inside it, interpolated between its corners; turned to
/// the viewer where the surface is seen from behind.
Vec3 surface_normal(DrawTriangles const& list, SampleGrid const& grid, int triangle, double x,
                    double y);

}  // namespace inkflate
