// SPDX-License-Identifier: Apache-2.0
#include "ink/find_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "image/filter.h"

namespace inkflate {
namespace {

/// Edges are looked for on cells of this share of the longer side: wood and paper are even at this size.
constexpr int kCellsAlongSide = 200;
/// Both sides of an edge are compared over this many cells: wider than lines and the blur of a lens.
constexpr int kStripCells = 4;
/// A table is darker than its sheet by this share in some channel. Shadows that dark are softer than the strips.
constexpr double kTableDarker = 0.25;
/// In dark pictures shares are noise: also by this much of 255.
constexpr double kTableDarkerLevels = 25;
/// A white ground is lighter than a sheet by so much of 255, and the sheet is not darker than this share of it.
constexpr double kGroundLighterLevels = 7;
constexpr double kDarkestSheet = 0.6;
/// Of the cells between an edge and the picture's border at most this share looks like the sheet.
constexpr double kMostSheetOutside = 0.2;
/// Sheets lie in the picture turned by less than about 12 degrees: an edge rises by this share of its length.
constexpr double kSteepest = 0.21;
/// An edge is not farther from its side of the picture than this share of the way to the other.
constexpr double kDeepest = 0.45;
/// Real edges bend: they are followed for so many cells to both sides of a line.
constexpr int kBendCells = 2;
/// Edges are seen along this share of a side at least, and along this share of what lies between the other edges.
/// Nothing drawn is so long, so straight, and filled up to the border.
constexpr double kShortestEdge = 0.35;
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

enum class Surround { Darker, Lighter };

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

using Rgb = std::array<double, 3>;

Rgb rgb(Colour colour) {
  return {static_cast<double>(colour.r), static_cast<double>(colour.g),
          static_cast<double>(colour.b)};
}
double brightness(Rgb const& colour) { return (colour[0] + colour[1] + colour[2]) / 3; }

Rgb mean_down(Picture const& view, int along, int first, int end) {
  Rgb sum{};
  for (int depth = first; depth < end; ++depth) {
    auto const cell = rgb(view.at(along, depth));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += cell[c] / (end - first);
  }
  return sum;
}

/// Whether cells are equally bright, as paper is.
bool is_even_down(Picture const& view, int along, int first, int end) {
  double least = 255;
  double most = 0;
  for (int depth = first; depth < end; ++depth) {
    double const here = brightness(rgb(view.at(along, depth)));
    least = std::min(least, here);
    most = std::max(most, here);
  }
  return most - least < kGroundLighterLevels;
}

/// How many levels darker a colour is than the sheet, in the channel that differs most; 0: not as much as a table.
double table_contrast(Rgb const& outside, Rgb const& sheet) {
  double most = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double const loss = sheet[c] - outside[c];
    if (loss >= kTableDarkerLevels && loss >= kTableDarker * sheet[c]) most = std::max(most, loss);
  }
  return most;
}

double ground_contrast(double outside, double sheet) {
  double const gain = outside - sheet;
  return gain >= kGroundLighterLevels && sheet >= kDarkestSheet * outside ? gain : 0;
}

/// Whether a cell is nearer to the sheet than to what lies outside, in the channels that tell them apart.
bool is_like_sheet(Rgb const& cell, Rgb const& outside, Rgb const& sheet) {
  double share = 0;
  double weight = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double const span = sheet[c] - outside[c];
    share += (cell[c] - outside[c]) * span;
    weight += span * span;
  }
  return share > 0.6 * weight;
}

/// How clearly an edge runs between the cell at a depth and the one before it; 0: none that could be the sheet's.
double edge_contrast(Picture const& view, int along, int depth, Surround surround) {
  auto const outside = mean_down(view, along, std::max(0, depth - kStripCells), depth);
  auto const sheet = mean_down(view, along, depth, depth + kStripCells);
  double const contrast = surround == Surround::Darker
                              ? table_contrast(outside, sheet)
                              : ground_contrast(brightness(outside), brightness(sheet));
  if (contrast <= 0) return 0;
  // A light line on a dark ground is no sheet: that goes on behind its edge.
  for (int i = depth; i < depth + kStripCells; ++i) {
    if (!is_like_sheet(rgb(view.at(along, i)), outside, sheet)) return 0;
  }
  // A line on white paper is no grey sheet, and a grey area with a line around it was drawn.
  if (surround == Surround::Lighter && !is_even_down(view, along, depth, depth + kStripCells)) {
    return 0;
  }
  int like_sheet = 0;
  for (int i = 0; i < depth; ++i) {
    auto const cell = rgb(view.at(along, i));
    // Something is drawn there: the light part is paper too.
    if (surround == Surround::Lighter &&
        brightness(cell) < brightness(sheet) - kGroundLighterLevels)
      return 0;
    if (is_like_sheet(cell, outside, sheet)) ++like_sheet;
  }
  return like_sheet <= std::max(1.0, kMostSheetOutside * depth) ? contrast : 0;
}

Grid2<double> edge_contrasts(Picture const& view, Surround surround) {
  int const deepest = std::min(static_cast<int>(kDeepest * view.height), view.height - kStripCells);
  Grid2<double> result(view.width, std::max(1, deepest + 1));
  for (int depth = 1; depth <= deepest; ++depth) {
    for (int along = 0; along < view.width; ++along) {
      result.at(along, depth) = edge_contrast(view, along, depth, surround);
    }
  }
  return result;
}

/// A line across the picture as depths from a side, in cells.
struct Line {
  double first = 0;  // at the first cell of the side
  double last = 0;   // at the last

  double depth(double along, int count) const {
    return first + (last - first) * along / std::max(1, count - 1);
  }
};

/// An edge of the sheet, seen from a side.
struct Edge {
  Line line;
  std::vector<char> is_seen;  // by cell along the side
  std::vector<double> depths;
};

/// Without what is not the most within a few cells of the same column: the places of the edges alone.
Grid2<double> peaks(Grid2<double> const& contrasts) {
  auto result = contrasts;
  for (int along = 0; along < contrasts.width; ++along) {
    for (int depth = 0; depth < contrasts.height; ++depth) {
      int const end = std::min(contrasts.height, depth + kStripCells);
      double most = 0;
      for (int i = std::max(0, depth - kStripCells + 1); i < end; ++i) {
        most = std::max(most, contrasts.at(along, i));
      }
      if (contrasts.at(along, depth) < most) result.at(along, depth) = 0;
    }
  }
  return result;
}

double contrast_at(Grid2<double> const& contrasts, int along, int depth) {
  return depth >= 1 && depth < contrasts.height ? contrasts.at(along, depth) : 0;
}

/// The line with the most contrast along it.
Line best_line(Grid2<double> const& contrasts) {
  Line best;
  double most = 0;
  int const count = contrasts.width;
  int const rise = static_cast<int>(kSteepest * count);
  for (int first = -rise; first < contrasts.height; ++first) {
    for (int last = first - rise; last <= first + rise; ++last) {
      Line const line = {static_cast<double>(first), static_cast<double>(last)};
      double const step = (line.last - line.first) / std::max(1, count - 1);
      double depth = first + 0.5;
      double sum = 0;
      for (int along = 0; along < count; ++along, depth += step) {
        if (depth >= 1) sum += contrast_at(contrasts, along, static_cast<int>(depth));
      }
      if (sum <= most) continue;
      most = sum;
      best = line;
    }
  }
  return best;
}

/// The edge along a line: where it bends, its clearest depth near the line.
Edge follow(Line const& line, Grid2<double> const& contrasts) {
  Edge edge = {line, {}, {}};
  for (int along = 0; along < contrasts.width; ++along) {
    double const middle = line.depth(along, contrasts.width);
    int const near = static_cast<int>(std::floor(middle + 0.5));
    double most = 0;
    double depth = middle;
    for (int i = near - kBendCells; i <= near + kBendCells; ++i) {
      double const contrast = contrast_at(contrasts, along, i);
      if (contrast <= most) continue;
      most = contrast;
      depth = i;
    }
    edge.is_seen.push_back(most > 0 ? 1 : 0);
    edge.depths.push_back(depth);
  }
  return edge;
}

std::optional<Edge> find_edge(Picture const& view, Surround surround) {
  auto const contrasts = edge_contrasts(view, surround);
  auto const is_long = [&](int cells) { return cells >= kShortestEdge * view.width; };
  int possible = 0;
  for (int along = 0; along < view.width; ++along) {
    double most = 0;
    for (int depth = 1; depth < contrasts.height; ++depth) {
      most = std::max(most, contrasts.at(along, depth));
    }
    if (most > 0) ++possible;
  }
  if (!is_long(possible)) return std::nullopt;
  auto edge = follow(best_line(contrasts), peaks(contrasts));
  auto const seen = std::count(edge.is_seen.begin(), edge.is_seen.end(), 1);
  return is_long(static_cast<int>(seen)) ? std::optional(edge) : std::nullopt;
}

/// Brightness of the picture's pixels at a depth from a side, in the mean over some columns.
double row_brightness(Side side, Picture const& picture, int first, int end, int depth) {
  int const at = side.is_far ? depth_count(side, picture.width, picture.height) - 1 - depth : depth;
  double sum = 0;
  for (int along = first; along < end; ++along) {
    sum += brightness(rgb(side.is_upright ? picture.at(at, along) : picture.at(along, at)));
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
bool is_sharp(Side side, Edge const& edge, Picture const& picture, double cell_px) {
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

using Edges = std::array<std::optional<Edge>, 4>;

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
void clear_outside(Side side, Edge const& edge, double cell_px, Mask& sheet) {
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
  if (std::min(cells.width, cells.height) < 4 * kStripCells) return sheet;
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
