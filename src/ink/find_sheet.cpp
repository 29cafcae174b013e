// SPDX-License-Identifier: Apache-2.0
#include "ink/find_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "image/filter.h"
#include "ink/sheet_edge.h"

namespace inkflate {
namespace {

/// Edges are looked for on cells of this share of the longer side: wood and paper are even at this size.
constexpr int kCellsAlongSide = 200;
/// Pictures of fewer cells across show no table.
constexpr int kFewestCells = 16;
/// Edges are seen along this share of what lies between the other edges. Nothing drawn is so long, so straight, and
/// filled up to the border.
constexpr double kLeastSeen = 0.75;
/// Wider than any pen, in cells. One such edge given, others may be nearer to the border.
constexpr double kNarrowestTable = 3;
/// A sheet's edge is sharp: so much of its contrast lies within this share of the longer side. A shadow's is not.
constexpr double kSharpSide = 0.002;
constexpr double kLeastSharp = 0.5;
/// No shadow leaves less than this share of the light: what is darker may be blurred.
constexpr double kDarkestShadow = 0.45;
/// What is left of the picture is no sheet if it is less than this share.
constexpr double kSmallestSheet = 0.1;
/// The shadow at a sheet's edge and the fibres there reach this share of the longer side into it.
constexpr double kEdgeShadow = 0.015;

/// A side of the picture, from which one looks across it.
struct Side {
  bool is_upright = false;  // left or right
  bool is_far = false;      // right or bottom
};
constexpr std::array<Side, 4> kSides = {
    Side{false, false}, {false, true}, {true, false}, {true, true}};

int along_count(Side side, int width, int height) { return side.is_upright ? height : width; }
int depth_count(Side side, int width, int height) { return side.is_upright ? width : height; }

/// The cells as seen from a side: x along it, y away from it.
Picture seen_from(Side side, Picture const& cells) {
  Picture view(along_count(side, cells.width, cells.height),
               depth_count(side, cells.width, cells.height));
  for (int depth = 0; depth < view.height; ++depth) {
    int const at = side.is_far ? view.height - 1 - depth : depth;
    for (int along = 0; along < view.width; ++along) {
      view.at(along, depth) = side.is_upright ? cells.at(at, along) : cells.at(along, at);
    }
  }
  return view;
}

double brightness(Colour colour) { return (colour.r + colour.g + colour.b) / 3.0; }

/// Brightness of the picture's pixels at a depth from a side, in the mean over some columns.
double row_brightness(Side side, Picture const& picture, int first, int end, int depth) {
  int const at = side.is_far ? depth_count(side, picture.width, picture.height) - 1 - depth : depth;
  double sum = 0;
  for (int along = first; along < end; ++along) {
    sum += brightness(side.is_upright ? picture.at(at, along) : picture.at(along, at));
  }
  return sum / (end - first);
}

/// The largest step of brightness within a few pixels, as a share of that from one end of the profile to the other;
/// 1 where no shadow could be.
double sharpness(std::vector<double> const& profile, std::size_t strip_px, std::size_t step_px) {
  double before = 0;
  double after = 0;
  for (std::size_t i = 0; i < strip_px; ++i) {
    before += profile[i] / static_cast<double>(strip_px);
    after += profile[profile.size() - 1 - i] / static_cast<double>(strip_px);
  }
  if (before < kDarkestShadow * after) return 1;
  double const sign = after > before ? 1 : -1;
  double most = 0;
  for (std::size_t i = step_px; i < profile.size(); ++i) {
    most = std::max(most, sign * (profile[i] - profile[i - step_px]));
  }
  return most / std::max(1.0, std::abs(after - before));
}

/// Whether the edge is sharp nearly everywhere: in soft edges, noise makes every other place look so.
bool is_sharp(Side side, SheetEdge const& edge, Picture const& picture, double cell_px) {
  auto const step_px = static_cast<int>(kSharpSide * std::max(picture.width, picture.height)) + 1;
  auto const strip_px = std::max(1, static_cast<int>(cell_px));
  int const reach_px = 2 * strip_px + step_px;
  int const deep = depth_count(side, picture.width, picture.height);
  int seen = 0;
  int sharp = 0;
  for (std::size_t i = 0; i < edge.depths.size(); ++i) {
    if (edge.is_seen[i] == 0) continue;
    int const column = static_cast<int>(static_cast<double>(i) * cell_px);
    int const middle = static_cast<int>(edge.depths[i] * cell_px);
    std::vector<double> profile;
    for (int depth = std::max(0, middle - reach_px); depth < std::min(deep, middle + reach_px);
         ++depth) {
      profile.push_back(row_brightness(side, picture, column, column + strip_px, depth));
    }
    ++seen;
    if (sharpness(profile, static_cast<std::size_t>(strip_px), static_cast<std::size_t>(step_px)) >=
        kLeastSharp) {
      ++sharp;
    }
  }
  return sharp >= kLeastSeen * seen;
}

using Edges = std::array<std::optional<SheetEdge>, 4>;

/// Whether a cell lies beyond one of the edges.
bool is_outside(Edges const& edges, double x, double y, Picture const& cells) {
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    if (!edges[i]) continue;
    auto const side = kSides[i];
    double depth = side.is_upright ? x : y;
    if (side.is_far) depth = depth_count(side, cells.width, cells.height) - 1 - depth;
    double const along = side.is_upright ? y : x;
    if (depth < edges[i]->line.depth(along, along_count(side, cells.width, cells.height)))
      return true;
  }
  return false;
}

/// Of the cells along an edge that lie in the picture and between the other edges, the share that shows it.
double seen_share(Edges const& edges, std::size_t index, Picture const& cells) {
  auto const side = kSides[index];
  auto const& edge = *edges[index];
  auto others = edges;
  others[index].reset();
  int const count = along_count(side, cells.width, cells.height);
  int seen = 0;
  int all = 0;
  for (int along = 0; along < count; ++along) {
    double const near = edge.line.depth(along, count);
    if (near < 1) continue;
    double const depth =
        side.is_far ? depth_count(side, cells.width, cells.height) - 1 - near : near;
    if (side.is_upright ? is_outside(others, depth, along, cells)
                        : is_outside(others, along, depth, cells)) {
      continue;
    }
    ++all;
    seen += edge.is_seen[static_cast<std::size_t>(along)];
  }
  return all > 0 ? static_cast<double>(seen) / all : 0;
}

/// Drops what only looks like an edge, the least seen first: each may have hidden what the others lack.
void drop_doubtful(Edges& edges, Picture const& cells) {
  while (true) {
    double least = kLeastSeen;
    std::size_t worst = edges.size();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (!edges[i]) continue;
      double const share = seen_share(edges, i, cells);
      if (share >= least) continue;
      least = share;
      worst = i;
    }
    if (worst == edges.size()) break;
    edges[worst].reset();
  }
  bool is_wide = false;
  for (auto const& edge : edges) {
    if (edge) is_wide = is_wide || std::max(edge->line.first, edge->line.last) >= kNarrowestTable;
  }
  if (!is_wide) edges = {};
}

/// Clears the mask between a side and the edge seen from it.
void clear_outside(Side side, SheetEdge const& edge, double cell_px, Mask& sheet) {
  double const margin_px = kEdgeShadow * std::max(sheet.width, sheet.height);
  int const count = along_count(side, sheet.width, sheet.height);
  int const deep = depth_count(side, sheet.width, sheet.height);
  auto const last = static_cast<double>(edge.depths.size() - 1);
  for (int along = 0; along < count; ++along) {
    double const place = std::clamp((along + 0.5) / cell_px - 0.5, 0.0, last);
    auto const cell = static_cast<std::size_t>(place);
    auto const next = std::min(cell + 1, edge.depths.size() - 1);
    double const line_px = cell_px * std::max(edge.depths[cell], edge.depths[next]);
    if (line_px <= 0) continue;
    int const end = std::min(deep, static_cast<int>(line_px + margin_px));
    for (int depth = 0; depth < end; ++depth) {
      int const at = side.is_far ? deep - 1 - depth : depth;
      (side.is_upright ? sheet.at(at, along) : sheet.at(along, at)) = 0;
    }
  }
}

}  // namespace

Mask find_sheet(Picture const& picture) {
  Mask sheet(picture.width, picture.height, 255);
  double const cell_px =
      std::max(1.0, static_cast<double>(std::max(picture.width, picture.height)) / kCellsAlongSide);
  auto const cells = shrink(picture, std::max(1, static_cast<int>(picture.width / cell_px)),
                            std::max(1, static_cast<int>(picture.height / cell_px)));
  if (std::min(cells.width, cells.height) < kFewestCells) return sheet;
  for (auto const surround : {Surround::Darker, Surround::Lighter}) {
    Edges edges;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      edges[i] = find_edge(seen_from(kSides[i], cells), surround);
      if (edges[i] && !is_sharp(kSides[i], *edges[i], picture, cell_px)) edges[i].reset();
    }
    drop_doubtful(edges, cells);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (edges[i]) clear_outside(kSides[i], *edges[i], cell_px, sheet);
    }
  }
  auto const left = std::count(sheet.values.begin(), sheet.values.end(), 255);
  if (static_cast<double>(left) < kSmallestSheet * static_cast<double>(sheet.values.size())) {
    return {picture.width, picture.height, 255};
  }
  return sheet;
}

}  // namespace inkflate
