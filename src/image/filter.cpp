// SPDX-License-Identifier: Apache-2.0
#include "image/filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "image/to_byte.h"

namespace inkflate {
namespace {

using Channels = std::array<double, 4>;

/// Which pixels a smaller one covers along one axis, and how much of each.
struct Cover {
  int first = 0;
  std::vector<double> shares;  // sum 1
};

std::vector<Cover> covers(int from, int to) {
  std::vector<Cover> result(static_cast<std::size_t>(to));
  double const step = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    double const low = i * step;
    double const high = std::min((i + 1) * step, static_cast<double>(from));
    auto& cover = result[static_cast<std::size_t>(i)];
    cover.first = std::min(static_cast<int>(low), from - 1);
    for (int k = cover.first; k < from && k < high; ++k) {
      cover.shares.push_back((std::min(high, k + 1.0) - std::max(low, k + 0.0)) / (high - low));
    }
  }
  return result;
}

/// Row y of the picture, shrunk along x and added with a weight.
void add_row(Picture const& picture, int y, std::vector<Cover> const& columns, double weight,
             std::vector<Channels>& sums) {
  for (std::size_t x = 0; x < columns.size(); ++x) {
    Channels sum{};
    int from = columns[x].first;
    for (double const share : columns[x].shares) {
      auto const pixel = picture.at(from++, y);
      sum[0] += share * pixel.r;
      sum[1] += share * pixel.g;
      sum[2] += share * pixel.b;
      sum[3] += share * pixel.a;
    }
    for (std::size_t c = 0; c < 4; ++c) sums[x][c] += weight * sum[c];
  }
}

/// The best value of each window along rows, written transposed: two passes give the square.
template <typename Better>
Mask best_along_rows(Mask const& values, int radius, Better better) {
  Mask result(values.height, values.width);
  for (int y = 0; y < values.height; ++y) {
    for (int x = 0; x < values.width; ++x) {
      int const end = std::min(values.width - 1, x + radius);
      auto best = values.at(std::max(0, x - radius), y);
      for (int k = std::max(0, x - radius); k <= end; ++k) best = better(best, values.at(k, y));
      result.at(y, x) = best;
    }
  }
  return result;
}

Grid2<double> mean_along_rows(Grid2<double> const& values, int radius) {
  Grid2<double> result(values.height, values.width);
  for (int y = 0; y < values.height; ++y) {
    double sum = 0;
    int first = 0;
    int end = 0;
    for (int x = 0; x < values.width; ++x) {
      for (; end < std::min(values.width, x + radius + 1); ++end) sum += values.at(end, y);
      for (; first < x - radius; ++first) sum -= values.at(first, y);
      result.at(y, x) = sum / (end - first);
    }
  }
  return result;
}

}  // namespace

Picture over_white(Picture picture) {
  for (auto& pixel : picture.values) {
    if (pixel.a == 255) continue;
    int const paper = 255 * (255 - pixel.a);
    auto const mix = [&](int channel) {
      return static_cast<std::uint8_t>((channel * pixel.a + paper + 127) / 255);
    };
    pixel = {mix(pixel.r), mix(pixel.g), mix(pixel.b), 255};
  }
  return picture;
}

Picture shrink(Picture const& picture, int width, int height) {
  CHECK(width >= 1 && height >= 1 && width <= picture.width && height <= picture.height,
        "shrink makes a picture smaller");
  auto const columns = covers(picture.width, width);
  auto const rows = covers(picture.height, height);
  Picture result(width, height);
  for (int y = 0; y < height; ++y) {
    std::vector<Channels> sums(columns.size());
    auto const& row = rows[static_cast<std::size_t>(y)];
    int from = row.first;
    for (double const share : row.shares) add_row(picture, from++, columns, share, sums);
    for (int x = 0; x < width; ++x) {
      auto const& sum = sums[static_cast<std::size_t>(x)];
      result.at(x, y) = {to_byte(sum[0]), to_byte(sum[1]), to_byte(sum[2]), to_byte(sum[3])};
    }
  }
  return result;
}

Mask local_maximum(Mask const& values, int radius) {
  auto const better = [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); };
  return best_along_rows(best_along_rows(values, radius, better), radius, better);
}

Mask local_minimum(Mask const& values, int radius) {
  auto const better = [](std::uint8_t a, std::uint8_t b) { return std::min(a, b); };
  return best_along_rows(best_along_rows(values, radius, better), radius, better);
}

Grid2<double> box_mean(Grid2<double> const& values, int radius) {
  return mean_along_rows(mean_along_rows(values, radius), radius);
}

Mask soften(Mask const& values) {
  Mask result(values.width, values.height);
  for (int y = 0; y < values.height; ++y) {
    std::array<int, 3> const rows = {std::max(0, y - 1), y, std::min(values.height - 1, y + 1)};
    auto const column = [&](int x) {
      return values.at(x, rows[0]) + 2 * values.at(x, rows[1]) + values.at(x, rows[2]);
    };
    for (int x = 0; x < values.width; ++x) {
      int const sum =
          column(std::max(0, x - 1)) + 2 * column(x) + column(std::min(values.width - 1, x + 1));
      result.at(x, y) = static_cast<std::uint8_t>((sum + 8) / 16);
    }
  }
  return result;
}

}  // namespace inkflate
