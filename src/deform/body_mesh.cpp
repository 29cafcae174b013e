// SPDX-License-Identifier: Apache-2.0
#include "deform/body_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "deform/cut_sheets.h"
#include "mesh/mesh_region.h"
#include "mesh/rim_spacing.h"

namespace inkflate {
namespace {

constexpr double kEdgesAlongRims = 400;
// 6 px of 1000 px.
constexpr double kEdgesAcross = 160;
// What is small in its drawing may have so much longer edges: still 100 around.
constexpr double kMostCoarser = 4;
// Points between two vertices of the rim before it is thinned.
constexpr double kFinePoints = 2;
// Where a shape is thin, so many edges are as long as it is wide; edges become no shorter than this share of the longest.
constexpr double kShareOfWidth = 0.5;
constexpr double kShortestShare = 0.25;
// Inside, in edges of the rim. In wide shapes longer: so that there are about so many vertices inside; each stands for this share of
// the square of an edge.
constexpr double kLongestInside = 2;
constexpr double kVerticesInside = 1000;
constexpr double kAreaOfVertex = 0.87;
// A mesh with a triangle smaller than this share of an edge's square is too thin for a solver.
constexpr double kLeastArea = 1e-9;
// No area is smaller: at 1e6 px doubles hold its triangles well.
constexpr double kLeastSizePx = 0.01;
// Where chords cross although the curves do not, half as far apart is tried, so many times.
constexpr int kRefinements = 2;

Rect box_of(std::span<Outline const> outlines) {
  Rect box;
  for (auto const& outline : outlines) {
    for (auto const& piece : outline.pieces) box.include(piece.curve.start());
  }
  return box;
}

double length_of(std::span<Outline const> outlines) {
  double sum = 0;
  for (auto const& outline : outlines) {
    for (auto const& piece : outline.pieces) {
      // Between the chord and the control polygon; good enough to choose a spacing.
      sum += (length(piece.curve.control) + distance(piece.curve.start(), piece.curve.end())) / 2;
    }
  }
  return sum;
}

std::vector<std::vector<double>> spacing_of(std::span<LineSamples const> fine, double edge_px) {
  std::vector<Contour> contours;
  for (auto const& samples : fine) contours.push_back(samples.points);
  RimSpacingOptions options;
  options.longest_px = edge_px;
  options.shortest_px = kShortestShare * edge_px;
  options.share_of_width = kShareOfWidth;
  return rim_spacing(contours, options);
}

/// The indices of outlines that can be rims: those that enclose something.
std::vector<int> areas_among(std::span<LineSamples const> rims) {
  std::vector<int> result;
  for (int i = 0; i < std::ssize(rims); ++i) {
    if (rims[i].points.size() >= 3) result.push_back(i);
  }
  return result;
}

std::vector<double> stiffness_of(RegionMesh const& region, double body) {
  int rim_count = 0;
  for (auto const& contour : region.contours) rim_count += static_cast<int>(std::ssize(contour));
  std::vector<double> stiffness;
  for (auto const& t : region.mesh.triangles)
    stiffness.push_back(std::min({t[0], t[1], t[2]}) < rim_count ? 1 : body);
  return stiffness;
}

bool is_too_thin(FlatMesh const& mesh, double edge_px) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](Triangle const& t) {
    Vec2 const a = mesh.points[t[0]];
    return !(cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a) > kLeastArea * edge_px * edge_px);
  });
}

ShapeMesh shape_mesh(RegionMesh region, std::span<LineSamples const> rims,
                     std::span<int const> areas, double edge_px, double body) {
  ShapeMesh result;
  result.is_filled = true;
  result.mesh.stiffness = stiffness_of(region, body);
  result.mesh.edge_px = edge_px;
  for (std::size_t k = 0; k < areas.size(); ++k) {
    result.mesh.lines.push_back({std::move(region.contours[k]), true});
    result.origins.push_back({areas[k], rims[areas[k]].parameters});
  }
  result.mesh.rest = std::move(region.mesh);
  return result;
}

MeshRegionOptions inside_options(Contour const& rim, double edge_px) {
  MeshRegionOptions options;
  double const area = std::abs(signed_area(rim));
  options.longest_px =
      std::max(kLongestInside * edge_px, std::sqrt(area / (kVerticesInside * kAreaOfVertex)));
  return options;
}

/// Gives a mesh the triangles of one of its pieces, whose corners it has already. False: it cannot be filled.
bool add_piece(std::span<int const> piece, MeshRegionOptions const& options, FlatMesh& mesh) {
  Region region;
  region.contours.emplace_back();
  for (int const v : piece) region.contours[0].push_back(mesh.points[v]);
  auto const meshed = mesh_region(region, options);
  if (!meshed) return false;
  std::vector<int> names(meshed->mesh.points.size(), -1);
  for (std::size_t k = 0; k < piece.size(); ++k) names[meshed->contours[0][k]] = piece[k];
  for (std::size_t v = 0; v < names.size(); ++v) {
    if (names[v] >= 0) continue;
    names[v] = static_cast<int>(std::ssize(mesh.points));
    mesh.points.push_back(meshed->mesh.points[v]);
  }
  for (auto const& [a, b, c] : meshed->mesh.triangles)
    mesh.triangles.push_back({names[a], names[b], names[c]});
  return true;
}

/// Fills the rims; may_drop: holes that are in the way are left out.
std::optional<ShapeMesh> fill(std::span<LineSamples const> rims, double edge_px, double body,
                              bool may_drop) {
  auto areas = areas_among(rims);
  if (areas.empty() || areas.front() != 0) return {};
  auto const options = inside_options(rims.front().points, edge_px);
  for (;;) {
    Region region;
    for (int const i : areas) region.contours.push_back(rims[i].points);
    auto meshed = mesh_region(region, options);
    if (meshed) {
      if (meshed->mesh.triangles.empty() || is_too_thin(meshed->mesh, edge_px)) return {};
      return shape_mesh(std::move(*meshed), rims, areas, edge_px, body);
    }
    auto const culprit = meshed.error().index;
    if (!may_drop || culprit <= 0 || culprit >= std::ssize(areas)) return {};
    areas.erase(areas.begin() + culprit);
  }
}

/// A rim that lies over itself, filled sheet by sheet.
std::optional<ShapeMesh> fill_sheets(std::span<LineSamples const> rims, double edge_px,
                                     double body) {
  auto const areas = areas_among(rims);
  // It is not known in which sheet a hole is.
  if (areas != std::vector{0}) return {};
  auto const& rim = rims.front().points;
  auto sheets = cut_into_sheets(rim, edge_px);
  if (!sheets) return {};
  RegionMesh whole;
  whole.contours.emplace_back();
  for (int v = 0; v < std::ssize(rim); ++v) whole.contours[0].push_back(v);
  whole.mesh.points = sheets->points;
  std::vector<int> sheet_of;
  for (auto const& piece : sheets->pieces) {
    int const sheet = sheet_of.empty() ? 0 : sheet_of.back() + 1;
    if (!add_piece(piece, inside_options(rim, edge_px), whole.mesh)) return {};
    sheet_of.resize(whole.mesh.triangles.size(), sheet);
  }
  if (is_too_thin(whole.mesh, edge_px)) return {};
  auto shape = shape_mesh(std::move(whole), rims, areas, edge_px, body);
  shape.sheets = std::move(sheet_of);
  return shape;
}

std::vector<LineSamples> thinned_rims(std::span<Outline const> outlines,
                                      std::span<LineSamples const> fine,
                                      std::span<std::vector<double> const> spacing) {
  std::vector<LineSamples> rims;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (fine[i].points.size() < 3) {
      rims.push_back(fine[i]);
      continue;
    }
    rims.push_back(thinned(fine[i], spacing[i]));
    put_onto(outlines[i], rims.back());
  }
  return rims;
}

std::vector<LineSamples> fine_rims(std::span<Outline const> outlines, double edge_px) {
  std::vector<LineSamples> fine;
  for (auto const& outline : outlines)
    fine.push_back(sample_outline(outline, edge_px / kFinePoints));
  return fine;
}

}  // namespace

double rim_edge_px(std::span<Outline const> outlines) {
  double const edge = std::max(box_of(outlines).longer_side() / kEdgesAcross,
                               length_of(outlines) / kEdgesAlongRims);
  return edge > 0 ? edge : 1;
}

std::vector<LineSamples> sample_rims(std::span<Outline const> outlines, double edge_px) {
  auto const fine = fine_rims(outlines, edge_px);
  return thinned_rims(outlines, fine, spacing_of(fine, edge_px));
}

std::optional<ShapeMesh> body_mesh(std::span<Outline const> outlines, double body,
                                   double least_edge_px) {
  if (box_of(outlines).longer_side() < kLeastSizePx) return {};
  double const own_px = rim_edge_px(outlines);
  double const edge_px = std::clamp(least_edge_px, own_px, kMostCoarser * own_px);
  auto const fine = fine_rims(outlines, edge_px);
  auto spacing = spacing_of(fine, edge_px);
  for (int i = 0; i <= kRefinements; ++i) {
    auto const rims = thinned_rims(outlines, fine, spacing);
    auto filled = fill(rims, edge_px, body, i == kRefinements);
    if (filled) return filled;
    for (auto& lengths : spacing) {
      for (auto& each : lengths) each /= 2;
    }
  }
  return fill_sheets(thinned_rims(outlines, fine, spacing_of(fine, edge_px)), edge_px, body);
}

}  // namespace inkflate
