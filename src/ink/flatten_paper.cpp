// SPDX-License-Identifier: Apache-2.0
#include "ink/flatten_paper.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "image/filter.h"
#include "image/otsu.h"
#include "image/to_byte.h"

namespace inkflate {
namespace {

/// The paper is estimated on cells of this share of the longer side: several times a pen's width.
constexpr int kCellsAlongSide = 100;
/// Dark features up to twice this many cells wide are not paper; softer and larger ones are shadows.
constexpr int kClosingCells = 4;
/// A cell darker than this share of the bright ones is ink: shadows of a hand leave more.
constexpr double kDarkestPaper = 0.45;
/// A cell whose colour is this much stronger than the page's is a coloured area.
constexpr double kMostColour = 0.22;

constexpr Colour kWhite = {255, 255, 255};

using Rgb = std::array<double, 3>;

Rgb rgb(Colour colour) {
  return {static_cast<double>(colour.r), static_cast<double>(colour.g),
          static_cast<double>(colour.b)};
}
double brightness(Rgb const& colour) { return (colour[0] + colour[1] + colour[2]) / 3; }
/// 0 grey .. 1 pure.
double colourfulness(Rgb const& colour) {
  double const most = std::max({colour[0], colour[1], colour[2]});
  double const least = std::min({colour[0], colour[1], colour[2]});
  return most > 0 ? (most - least) / most : 0;
}

/// The picture in cells of the same size, the last ones cut off.
struct Cells {
  int side_px = 1;
  Grid2<Rgb> paper;
};

/// The mean of those pixels of a cell that are at least as bright as its mean: the paper between the lines.
Rgb bright_mean(Picture const& picture, int x0, int y0, int side_px) {
  int const x1 = std::min(picture.width, x0 + side_px);
  int const y1 = std::min(picture.height, y0 + side_px);
  double level = -1;
  Rgb sum{};
  for (int round = 0; round < 2; ++round) {
    sum = {};
    double count = 0;
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        auto const colour = rgb(picture.at(x, y));
        if (brightness(colour) < level) continue;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c];
        ++count;
      }
    }
    for (auto& channel : sum) channel /= count;
    // A hair lower: rounding must not shut out a cell of one colour.
    level = brightness(sum) - 1e-6;
  }
  return sum;
}

Cells cells_of(Picture const& picture) {
  Cells cells;
  cells.side_px = std::max(4, std::max(picture.width, picture.height) / kCellsAlongSide);
  int const side_px = cells.side_px;
  cells.paper =
      Grid2<Rgb>((picture.width + side_px - 1) / side_px, (picture.height + side_px - 1) / side_px);
  for (int y = 0; y < cells.paper.height; ++y) {
    for (int x = 0; x < cells.paper.width; ++x) {
      cells.paper.at(x, y) = bright_mean(picture, x * side_px, y * side_px, side_px);
    }
  }
  return cells;
}

/// The value that a share of the values does not pass.
double quantile_of(std::vector<double> values, double share) {
  auto const index = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

/// Which cells have their middle on the sheet: not a pixel of such a cell lies beyond its edge's shadow.
Mask sheet_cells(Cells const& cells, Mask const& sheet) {
  Mask result(cells.paper.width, cells.paper.height);
  int const half_px = cells.side_px / 2;
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      result.at(x, y) = sheet.at(std::min(sheet.width - 1, x * cells.side_px + half_px),
                                 std::min(sheet.height - 1, y * cells.side_px + half_px));
    }
  }
  return result;
}

/// Which cells of the sheet hold paper at all, and not a solid area.
Mask paper_cells(Grid2<Rgb> const& cells, Mask result) {
  std::vector<double> lights;
  std::vector<double> colours;
  for (std::size_t i = 0; i < cells.values.size(); ++i) {
    if (result.values[i] == 0) continue;
    lights.push_back(brightness(cells.values[i]));
    colours.push_back(colourfulness(cells.values[i]));
  }
  double const darkest = kDarkestPaper * quantile_of(lights, 0.8);
  double const most_colour = quantile_of(colours, 0.5) + kMostColour;
  for (std::size_t i = 0; i < cells.values.size(); ++i) {
    if (brightness(cells.values[i]) < darkest || colourfulness(cells.values[i]) > most_colour) {
      result.values[i] = 0;
    }
  }
  return result;
}

/// Gives every other cell the mean of its known neighbours, ring by ring. Where no cell is known at all, all stay as they are.
void fill_unknown(Grid2<Rgb>& cells, Mask known) {
  bool is_growing = true;
  while (is_growing) {
    is_growing = false;
    Mask next = known;
    for (int y = 0; y < cells.height; ++y) {
      for (int x = 0; x < cells.width; ++x) {
        if (known.at(x, y) != 0) continue;
        Rgb sum{};
        int count = 0;
        for (int v = std::max(0, y - 1); v <= std::min(cells.height - 1, y + 1); ++v) {
          for (int u = std::max(0, x - 1); u <= std::min(cells.width - 1, x + 1); ++u) {
            if (known.at(u, v) == 0) continue;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += cells.at(u, v)[c];
            ++count;
          }
        }
        if (count == 0) continue;
        is_growing = true;
        for (std::size_t c = 0; c < 3; ++c) cells.at(x, y)[c] = sum[c] / count;
        next.at(x, y) = 255;
      }
    }
    known = std::move(next);
  }
}

/// Maximum, then minimum: dark features go, slopes of light stay; then smooth between cells.
void close_and_smooth(Grid2<Rgb>& cells) {
  for (std::size_t c = 0; c < 3; ++c) {
    Mask channel(cells.width, cells.height);
    for (std::size_t i = 0; i < cells.values.size(); ++i) {
      channel.values[i] = to_byte(cells.values[i][c]);
    }
    auto const closed = local_minimum(local_maximum(channel, kClosingCells), kClosingCells);
    Grid2<double> smooth(cells.width, cells.height);
    for (std::size_t i = 0; i < closed.values.size(); ++i) smooth.values[i] = closed.values[i];
    smooth = box_mean(smooth, 1);
    for (std::size_t i = 0; i < cells.values.size(); ++i) cells.values[i][c] = smooth.values[i];
  }
}

/// Where a pixel lies between the centres of two neighbouring cells.
struct Between {
  int first = 0;
  int second = 0;
  double share = 0;  // of the second
};
Between between(int pixel, int side_px, int count) {
  double const place = std::clamp((pixel + 0.5) / side_px - 0.5, 0.0, count - 1.0);
  int const first = static_cast<int>(place);
  return {first, std::min(first + 1, count - 1), place - first};
}

Rgb paper_at(Grid2<Rgb> const& cells, Between const& across, Between const& down) {
  Rgb result;
  auto const& a = cells.at(across.first, down.first);
  auto const& b = cells.at(across.second, down.first);
  auto const& c = cells.at(across.first, down.second);
  auto const& d = cells.at(across.second, down.second);
  for (std::size_t i = 0; i < 3; ++i) {
    double const top = a[i] + (b[i] - a[i]) * across.share;
    double const bottom = c[i] + (d[i] - c[i]) * across.share;
    result[i] = std::max(1.0, top + (bottom - top) * down.share);
  }
  return result;
}

}  // namespace

FlatScan flatten_paper(Picture const& picture, Mask const& sheet) {
  auto cells = cells_of(picture);
  fill_unknown(cells.paper, paper_cells(cells.paper, sheet_cells(cells, sheet)));
  close_and_smooth(cells.paper);
  FlatScan flat{Picture(picture.width, picture.height, kWhite),
                Mask(picture.width, picture.height)};
  std::vector<Between> columns;
  columns.reserve(static_cast<std::size_t>(picture.width));
  for (int x = 0; x < picture.width; ++x) {
    columns.push_back(between(x, cells.side_px, cells.paper.width));
  }
  for (int y = 0; y < picture.height; ++y) {
    auto const down = between(y, cells.side_px, cells.paper.height);
    for (int x = 0; x < picture.width; ++x) {
      if (sheet.at(x, y) == 0) continue;
      auto const paper = paper_at(cells.paper, columns[static_cast<std::size_t>(x)], down);
      auto const pixel = picture.at(x, y);
      auto const relative = [](std::uint8_t value, double white) {
        return to_byte(std::min(255.0, 255 * value / white));
      };
      Colour const colour = {relative(pixel.r, paper[0]), relative(pixel.g, paper[1]),
                             relative(pixel.b, paper[2])};
      flat.colour.at(x, y) = colour;
      flat.strength.at(x, y) =
          static_cast<std::uint8_t>(255 - std::min({colour.r, colour.g, colour.b}));
    }
  }
  flat.strength = soften(flat.strength);
  return flat;
}

bool is_drawn_on_dark(Picture const& picture, Mask const& sheet) {
  std::array<long long, 256> counts{};
  for (std::size_t i = 0; i < picture.values.size(); ++i) {
    if (sheet.values[i] == 0) continue;
    ++counts[static_cast<std::size_t>(brightness(rgb(picture.values[i])))];
  }
  int const middle = quantile(counts, 0.5);
  // A dim photograph of paper is dark as well, but its lines are darker still.
  return middle < 128 && quantile(counts, 0.99) - middle > middle - quantile(counts, 0.01);
}

Picture with_lightness_turned(Picture picture) {
  for (auto& pixel : picture.values) {
    int const shift =
        255 - std::max({pixel.r, pixel.g, pixel.b}) - std::min({pixel.r, pixel.g, pixel.b});
    pixel = {static_cast<std::uint8_t>(pixel.r + shift), static_cast<std::uint8_t>(pixel.g + shift),
             static_cast<std::uint8_t>(pixel.b + shift), pixel.a};
  }
  return picture;
}

}  // namespace inkflate
