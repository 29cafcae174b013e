// SPDX-License-Identifier: Apache-2.0
#include "support/regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/rng.h"
#include "geometry/crossings.h"
#include "geometry/predicates.h"
#include "geometry/trig.h"
#include "mesh/rim_spacing.h"

namespace inkflate {

Contour ring_contour(Vec2 centre, double radius, int count) {
  Contour ring;
  for (int i = 0; i < count; ++i) {
    auto const turn = sin_cos(2 * kPi * i / count);
    ring.push_back(centre + Vec2{turn.cos, turn.sin} * radius);
  }
  return ring;
}

Contour subdivided(Contour const& corners, double spacing_px) {
  Contour contour;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    auto const a = corners[i];
    auto const b = corners[(i + 1) % corners.size()];
    int const count = std::max(1, static_cast<int>(std::ceil(distance(a, b) / spacing_px)));
    for (int k = 0; k < count; ++k) contour.push_back(lerp(a, b, static_cast<double>(k) / count));
  }
  return contour;
}

namespace {

int count_on_ring(double radius, double spacing_px) {
  return std::max(3, static_cast<int>(2 * kPi * radius / spacing_px));
}

Contour hole(Contour contour) {
  std::reverse(contour.begin(), contour.end());
  return contour;
}

}  // namespace

Region disc_region(double radius, double spacing_px) {
  return {{ring_contour({radius, radius}, radius, count_on_ring(radius, spacing_px))}, {}};
}

Region annulus_region(double outer, double inner, double spacing_px) {
  auto region = disc_region(outer, spacing_px);
  region.contours.push_back(
      hole(ring_contour({outer, outer}, inner, count_on_ring(inner, spacing_px))));
  return region;
}

Region l_region(double size, double spacing_px) {
  double const third = size / 3;
  Contour const corners = {{0, 0},       {third, 0}, {third, 2 * third}, {size, 2 * third},
                           {size, size}, {0, size}};
  return {{subdivided(corners, spacing_px)}, {}};
}

Region comb_region(int teeth, double width_px, double spacing_px) {
  Contour corners = {{0, 0}};
  for (int i = 0; i < teeth; ++i) {
    double const x = 30.0 * i;
    corners.push_back({x + 30 - width_px, 0});
    corners.push_back({x + 30 - width_px, -100});
    corners.push_back({x + 30, -100});
    corners.push_back({x + 30, 0});
  }
  corners.push_back({30.0 * teeth + 20, 0});
  corners.push_back({30.0 * teeth + 20, 40});
  corners.push_back({0, 40});
  return {{subdivided(corners, spacing_px)}, {}};
}

Region spiral_region(double turns, double spacing_px) {
  Contour outer;
  Contour inner;
  for (double angle = kPi; angle < 2 * kPi * turns;) {
    auto const turn = sin_cos(angle);
    double const radius = 8 * angle;
    outer.push_back(Vec2{turn.cos, turn.sin} * (radius + 12));
    inner.push_back(Vec2{turn.cos, turn.sin} * (radius - 12));
    angle += spacing_px / radius;
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return {{outer}, {}};
}

Region seamed_region(double spacing_px) {
  Region region = {{subdivided({{0, 0}, {200, 0}, {200, 200}, {0, 200}}, spacing_px)}, {}};
  auto straight = subdivided({{40, 40}, {160, 40}}, spacing_px);
  straight.resize(straight.size() / 2 + 1);
  auto arc = ring_contour({100, 120}, 50, count_on_ring(50, spacing_px));
  arc.resize(arc.size() / 2);
  region.seams = {straight, arc, {{100, 100}, {100, 100 + spacing_px}}};
  return region;
}

Region star_region(int spikes, double inner, double outer, double spacing_px) {
  Contour corners;
  for (int i = 0; i < 2 * spikes; ++i) {
    auto const turn = sin_cos(kPi * i / spikes);
    corners.push_back(Vec2{turn.cos, turn.sin} * (i % 2 == 0 ? outer : inner));
  }
  return {{subdivided(corners, spacing_px)}, {}};
}

Region triangle_region() { return {{{{0, 0}, {10, 0}, {0, 10}}}, {}}; }

std::vector<NamedRegion> sample_regions() {
  return {{"disc", disc_region(100, 5)},
          {"fine disc", disc_region(100, 1)},
          {"annulus", annulus_region(100, 70, 4)},
          {"hole near the rim", annulus_region(100, 99.5, 1)},
          {"L", l_region(120, 5)},
          {"comb", comb_region(6, 6, 1.5)},
          {"comb of thin teeth", comb_region(6, 0.2, 1.5)},
          {"spiral", spiral_region(3, 2.5)},
          {"seams", seamed_region(5)},
          {"star", star_region(7, 40, 100, 2)},
          {"star of needles", star_region(16, 10, 100, 1.5)},
          {"coarse star", star_region(5, 40, 100, 1000)},
          {"triangle", triangle_region()}};
}

namespace {

constexpr double kCoarseStepPx = 4;

Vec2 on_coarse_lattice(Vec2 p) {
  return {std::floor(p.x / kCoarseStepPx + 0.5) * kCoarseStepPx,
          std::floor(p.y / kCoarseStepPx + 0.5) * kCoarseStepPx};
}

/// Star-shaped around the centre, with radii between least and most.
Contour random_contour(Rng& rng, Vec2 centre, double least, double most) {
  int const count = 3 + rng.below(60);
  Contour contour;
  for (int i = 0; i < count; ++i) {
    auto const turn = sin_cos(2 * kPi * (i + rng.uniform(0, 0.9)) / count);
    contour.push_back(centre + Vec2{turn.cos, turn.sin} * rng.uniform(least, most));
  }
  return contour;
}

}  // namespace

Region random_region(std::uint64_t seed) {
  Rng rng(seed);
  Region region;
  double const least = rng.uniform(1, 80);
  region.contours = {random_contour(rng, {0, 0}, least, 100)};
  if (rng.below(2) == 0)
    region.contours.push_back(hole(random_contour(rng, {0, 0}, 0.1, 0.4 * least)));
  if (rng.below(2) == 0)
    region.seams.push_back({{0.5 * least, 0}, {0.6 * least, 0}, {0.6 * least, 0.2 * least}});
  if (rng.below(3) == 0) {
    double const spacing = rng.uniform(1, 20);
    for (auto& contour : region.contours) contour = subdivided(contour, spacing);
  }
  if (rng.below(3) == 0) {
    for (auto& contour : region.contours) {
      for (auto& p : contour) p = on_coarse_lattice(p);
    }
  }
  return region;
}

namespace {

Contour resampled(Contour contour, std::vector<double> spacing) {
  contour.push_back(contour.front());
  spacing.push_back(spacing.front());
  auto line = resample(contour, spacing);
  line.pop_back();
  return line;
}

}  // namespace

Region region_of(Layer const& layer) {
  constexpr double fine_px = 2;
  std::vector<Contour> fine;
  for (auto const& outline : layer.outlines) {
    auto const contour = flatten(outline, 0.1);
    fine.push_back(resampled(contour, std::vector<double>(contour.size(), fine_px)));
  }
  auto const spacing = rim_spacing(fine);
  Region region;
  for (std::size_t i = 0; i < fine.size(); ++i)
    region.contours.push_back(resampled(fine[i], spacing[i]));
  return region;
}

namespace {

using Ends = std::pair<int, int>;

/// How often each edge is used, by its ends in the triangles' direction.
std::map<Ends, int> directed_edges(FlatMesh const& mesh) {
  std::map<Ends, int> edges;
  for (auto const& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  }
  return edges;
}

std::set<Ends> rim_edges(RegionMesh const& mesh) {
  std::set<Ends> edges;
  for (auto const& contour : mesh.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      auto const [low, high] = std::minmax(contour[i], contour[(i + 1) % contour.size()]);
      edges.insert({low, high});
    }
  }
  return edges;
}

bool are_points_kept(Region const& region, RegionMesh const& mesh) {
  std::vector<Vec2> wanted;
  std::vector<Vec2> found;
  std::vector<int> numbers;
  for (auto const* lines : {&region.contours, &region.seams}) {
    for (auto const& line : *lines) wanted.insert(wanted.end(), line.begin(), line.end());
  }
  for (auto const* lines : {&mesh.contours, &mesh.seams}) {
    for (auto const& line : *lines) numbers.insert(numbers.end(), line.begin(), line.end());
  }
  for (int i = 0; i < std::ssize(numbers); ++i) {
    if (numbers[i] != i) return false;
    found.push_back(mesh.mesh.points[i]);
  }
  return found == wanted;
}

bool have_triangles_area(FlatMesh const& mesh) {
  for (auto const& [a, b, c] : mesh.triangles) {
    if (orientation_sign(mesh.points[a], mesh.points[b], mesh.points[c]) <= 0) return false;
  }
  return true;
}

bool is_area_right(Region const& region, FlatMesh const& mesh) {
  double wanted = std::abs(signed_area(region.contours[0]));
  for (std::size_t i = 1; i < region.contours.size(); ++i)
    wanted -= std::abs(signed_area(region.contours[i]));
  double found = 0;
  for (auto const& [a, b, c] : mesh.triangles)
    found += cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]) / 2;
  return std::abs(found - wanted) <= 1e-9 * std::abs(wanted);
}

}  // namespace

std::string what_is_wrong(Region const& region, RegionMesh const& mesh) {
  auto const& flat = mesh.mesh;
  if (!are_points_kept(region, mesh)) return "points of the region are not the first ones";
  if (!have_triangles_area(flat)) return "a triangle without area";
  if (!is_area_right(region, flat)) return "the area differs";
  auto const rim = rim_edges(mesh);
  auto const edges = directed_edges(flat);
  std::vector<bool> is_rim(flat.points.size());
  for (auto const& [a, b] : rim) is_rim[a] = is_rim[b] = true;
  long long edge_count = 0;
  for (auto const& [ends, uses] : edges) {
    auto const [a, b] = ends;
    if (uses != 1) return "two triangles on one side of an edge";
    bool const is_boundary = edges.count({b, a}) == 0;
    if (is_boundary != (rim.count(std::minmax(a, b)) > 0)) return "the boundary is not the rim";
    if (!is_boundary && is_rim[a] && is_rim[b]) return "an edge inside joins two points of the rim";
    if (is_boundary || a < b) ++edge_count;
  }
  for (auto const& t : flat.triangles) {
    if (is_rim[t[0]] && is_rim[t[1]] && is_rim[t[2]])
      return "a triangle of three points of the rim";
  }
  for (auto const& seam : mesh.seams) {
    for (std::size_t i = 1; i < seam.size(); ++i) {
      if (edges.count({seam[i - 1], seam[i]}) == 0) return "an edge of a seam is missing";
    }
  }
  long long const euler = std::ssize(flat.points) - edge_count + std::ssize(flat.triangles);
  if (euler != 2 - std::ssize(region.contours)) return "Euler's formula does not hold";
  return {};
}

namespace {

double angle_rad(Vec2 at, Vec2 a, Vec2 b) {
  return acos_of(dot(normalized(a - at), normalized(b - at)));
}

/// Corners of the rim sharper than 60 degrees, on either side.
std::vector<Vec2> sharp_places(Region const& region) {
  std::vector<Vec2> places;
  for (auto const& contour : region.contours) {
    auto const count = contour.size();
    for (std::size_t i = 0; i < count; ++i) {
      double const angle =
          angle_rad(contour[i], contour[(i + 1) % count], contour[(i + count - 1) % count]);
      if (angle < kPi / 3) places.push_back(contour[i]);
    }
  }
  return places;
}

}  // namespace

double least_angle_rad(Region const& region, RegionMesh const& mesh, double keep_away_px) {
  auto const places = sharp_places(region);
  auto const& points = mesh.mesh.points;
  double least = kPi;
  for (auto const& t : mesh.mesh.triangles) {
    bool const is_away = std::all_of(places.begin(), places.end(), [&](Vec2 place) {
      return std::all_of(t.begin(), t.end(),
                         [&](int v) { return distance(points[v], place) > keep_away_px; });
    });
    for (int i = 0; i < 3 && is_away; ++i)
      least =
          std::min(least, angle_rad(points[t[i]], points[t[(i + 1) % 3]], points[t[(i + 2) % 3]]));
  }
  return least;
}

}  // namespace inkflate
