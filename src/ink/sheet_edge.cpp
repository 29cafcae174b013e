// SPDX-License-Identifier: Apache-2.0
#include "ink/sheet_edge.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace inkflate {
namespace {

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
/// Edges are seen along this share of a side at least.
constexpr double kShortestEdge = 0.35;

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
SheetLine best_line(Grid2<double> const& contrasts) {
  SheetLine best;
  double most = 0;
  int const count = contrasts.width;
  int const rise = static_cast<int>(kSteepest * count);
  for (int first = -rise; first < contrasts.height; ++first) {
    for (int last = first - rise; last <= first + rise; ++last) {
      SheetLine const line = {static_cast<double>(first), static_cast<double>(last)};
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
SheetEdge follow(SheetLine const& line, Grid2<double> const& contrasts) {
  SheetEdge edge = {line, {}, {}};
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

}  // namespace

std::optional<SheetEdge> find_edge(Picture const& view, Surround surround) {
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

}  // namespace inkflate
