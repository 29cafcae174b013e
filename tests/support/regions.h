// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/mesh_region.h"
#include "model/drawing.h"

namespace inkflate {

/// Regions for tests, built in code. Lengths in px.

/// A regular polygon, clockwise on the screen.
Contour ring_contour(Vec2 centre, double radius, int count);

/// The polygon with points put on its edges, about as far apart as wanted; corners stay.
Contour subdivided(Contour const& corners, double spacing_px);

Region disc_region(double radius, double spacing_px);
Region annulus_region(double outer, double inner, double spacing_px);
Region l_region(double size, double spacing_px);
/// Thin teeth on a bar.
Region comb_region(int teeth, double width_px, double spacing_px);
Region spiral_region(double turns, double spacing_px);
/// A square with a straight seam, a bent one and one of two points.
Region seamed_region(double spacing_px);
/// A star with sharp spikes.
Region star_region(int spikes, double inner, double outer, double spacing_px);
Region triangle_region();

/// A star-shaped polygon of random radii, mostly with holes and seams; some have coordinates on a coarse lattice.
Region random_region(std::uint64_t seed);

/// A layer as it is meshed: its outlines sampled evenly, then as rim_spacing wants.
Region region_of(Layer const& layer);

struct NamedRegion {
  std::string name;
  Region region;
};
/// All of the above that are not random.
std::vector<NamedRegion> sample_regions();

/// Contours first, all points and edges there, no zero area, area, Euler's formula, no edge inside that joins two points of the rim. Says
/// what is wrong; empty: nothing.
std::string what_is_wrong(Region const& region, RegionMesh const& mesh);

/// The smallest angle of all triangles that have no corner nearer than keep_away to a place where the rim is sharper than 60 degrees.
double least_angle_rad(Region const& region, RegionMesh const& mesh, double keep_away_px);

}  // namespace inkflate
