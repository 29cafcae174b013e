// SPDX-License-Identifier: Apache-2.0
#include "render/rasterise.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "image/to_byte.h"
#include "render/dash.h"
#include "render/fill_coverage.h"
#include "render/stroke_coverage.h"

namespace inkflate {
namespace {

constexpr int kLargestSidePx = 16384;
/// Fills go through bands of rows, so that the coverage of a large picture needs little memory.
constexpr int kBandRows = 64;

/// Source over destination with straight alpha; share in [0, 1].
void blend(Colour& below, Colour colour, double share) {
  double const alpha = share * colour.a / 255;
  double const below_alpha = below.a * (1 - alpha) / 255;
  double const sum = alpha + below_alpha;
  if (sum <= 0) return;
  auto const mix = [&](std::uint8_t over, std::uint8_t under) {
    return to_byte((over * alpha + under * below_alpha) / sum);
  };
  below = {mix(colour.r, below.r), mix(colour.g, below.g), mix(colour.b, below.b),
           to_byte(255 * sum)};
}

class Rasteriser {
 public:
  Rasteriser(int width, int height, Colour background)
      : picture_(width, height, background), stroke_(width, height) {}

  void operator()(FilledPath const& path) {
    Rect box;
    for (auto const& contour : path.contours) {
      for (auto const point : contour) box.include(point);
    }
    if (box.is_empty()) return;
    int const left = clamped(box.min.x, picture_.width);
    int const columns = clamped(box.max.x + 1, picture_.width) - left;
    int const end = clamped(box.max.y + 1, picture_.height);
    for (int row = clamped(box.min.y, picture_.height); row < end; row += kBandRows) {
      fill_band(path, left, columns, row, std::min(kBandRows, end - row));
    }
  }

  void operator()(StrokedPolyline const& line) {
    CHECK(line.widths_px.size() == 1 || line.widths_px.size() == line.points.size(),
          "a line has one width or one for each point");
    for (auto const& piece : dashes(line)) add_line(piece);
    flush(line.colour);
  }

  void operator()(Dots const& dots) {
    for (auto const centre : dots.centres) {
      stroke_.add_segment(centre, dots.diameter_px, centre, dots.diameter_px);
    }
    flush(dots.colour);
  }

  Picture picture() && { return std::move(picture_); }

 private:
  static int clamped(double value, int count) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(count)));
  }

  void fill_band(FilledPath const& path, int left, int columns, int top, int rows) {
    Grid2<double> shares(columns, rows);
    cover_fill(path.contours, left, top, shares);
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        double const share = shares.at(x, y);
        // Sums of many pieces leave rounding of 1e-15 where the truth is 0.
        if (share > 1e-9) blend(picture_.at(left + x, top + y), path.colour, share);
      }
    }
  }

  void add_line(StrokedPolyline const& line) {
    auto const width = [&](std::size_t i) {
      return line.widths_px[std::min(i, line.widths_px.size() - 1)];
    };
    if (line.points.size() == 1) {
      stroke_.add_segment(line.points[0], width(0), line.points[0], width(0));
    }
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      stroke_.add_segment(line.points[i - 1], width(i - 1), line.points[i], width(i));
    }
  }

  void flush(Colour colour) {
    stroke_.flush([&](int x, int y, double share) { blend(picture_.at(x, y), colour, share); });
  }

  Picture picture_;
  StrokeCoverage stroke_;
};

}  // namespace

Picture rasterise(DrawList const& list, int width, int height, Colour background) {
  CHECK(width >= 0 && height >= 0 && width <= kLargestSidePx && height <= kLargestSidePx,
        "picture side out of range");
  Rasteriser rasteriser(width, height, background);
  for (auto const& item : list) std::visit(rasteriser, item);
  return std::move(rasteriser).picture();
}

}  // namespace inkflate
