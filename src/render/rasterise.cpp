// SPDX-License-Identifier: Apache-2.0
#include "render/rasterise.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "image/to_byte.h"
#include "render/dash.h"
#include "render/fill_coverage.h"
#include "render/picture_sampler.h"
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

/// Dashes keep their proportions where the line gets another width.
StrokedPolyline within_limits(StrokedPolyline line) {
  double widest_px = 0;
  double widest_within_px = 0;
  for (double& width_px : line.widths_px) {
    double const within_px =
        std::max(std::min(width_px, line.limits.most_px), line.limits.least_px);
    widest_px = std::max(widest_px, width_px);
    widest_within_px = std::max(widest_within_px, within_px);
    width_px = within_px;
  }
  double const factor = widest_px > 0 ? widest_within_px / widest_px : 1;
  for (double& dash_px : line.dashes_px) dash_px *= factor;
  return line;
}

class Rasteriser {
 public:
  Rasteriser(Picture& picture, PixelBox const& box)
      : picture_(picture), box_(box), stroke_(box.width, box.height) {}

  void operator()(FilledPath const& path) {
    Rect area;
    for (auto const& contour : path.contours) {
      for (auto const point : contour) area.include(point);
    }
    if (area.is_empty()) return;
    int const left = clamped(area.min.x, box_.left, box_.width);
    int const columns = clamped(area.max.x + 1, box_.left, box_.width) - left;
    int const end = clamped(area.max.y + 1, box_.top, box_.height);
    for (int row = clamped(area.min.y, box_.top, box_.height); row < end; row += kBandRows) {
      fill_band(path, left, columns, row, std::min(kBandRows, end - row));
    }
  }

  void operator()(StrokedPolyline const& line) {
    CHECK(line.widths_px.size() == 1 || line.widths_px.size() == line.points.size(),
          "a line has one width or one for each point");
    for (auto const& piece : dashes(within_limits(line))) add_line(piece);
    flush(line.colour);
  }

  void operator()(Dots const& dots) {
    for (auto const centre : dots.centres) {
      add_segment(centre, dots.diameter_px, centre, dots.diameter_px);
    }
    flush(dots.colour);
  }

  void operator()(DrawnPicture const& drawn) {
    double const determinant = drawn.map.determinant();
    if (!drawn.picture || drawn.picture->values.empty() || !std::isnormal(determinant)) return;
    auto const& map = drawn.map;
    Affine const inverse = Affine{map.d / determinant,
                                  -map.b / determinant,
                                  -map.c / determinant,
                                  map.a / determinant,
                                  0,
                                  0} *
                           Affine::translation({-map.e, -map.f});
    double const width = drawn.picture->width;
    double const height = drawn.picture->height;
    Rect area;
    for (Vec2 const corner : {Vec2{0, 0}, Vec2{width, 0}, Vec2{0, height}, Vec2{width, height}}) {
      area.include(map(corner));
    }
    PictureSampler const sampler(*drawn.picture, inverse.mean_scale());
    int const end_x = clamped(area.max.x + 1, box_.left, box_.width);
    int const end_y = clamped(area.max.y + 1, box_.top, box_.height);
    for (int y = clamped(area.min.y, box_.top, box_.height); y < end_y; ++y) {
      for (int x = clamped(area.min.x, box_.left, box_.width); x < end_x; ++x) {
        blend(picture_.at(x, y), sampler(inverse({x + 0.5, y + 0.5})), drawn.opacity);
      }
    }
  }

 private:
  static int clamped(double value, int first, int count) {
    return static_cast<int>(std::clamp(std::floor(value), static_cast<double>(first),
                                       static_cast<double>(first) + count));
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
      add_segment(line.points[0], width(0), line.points[0], width(0));
    }
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      add_segment(line.points[i - 1], width(i - 1), line.points[i], width(i));
    }
  }

  void add_segment(Vec2 a, double width_a_px, Vec2 b, double width_b_px) {
    Vec2 const corner = {static_cast<double>(box_.left), static_cast<double>(box_.top)};
    stroke_.add_segment(a - corner, width_a_px, b - corner, width_b_px);
  }

  void flush(Colour colour) {
    stroke_.flush([&](int x, int y, double share) {
      blend(picture_.at(box_.left + x, box_.top + y), colour, share);
    });
  }

  Picture& picture_;
  PixelBox box_;
  StrokeCoverage stroke_;
};

}  // namespace

Picture rasterise(DrawList const& list, int width, int height, Colour background) {
  CHECK(width >= 0 && height >= 0 && width <= kLargestSidePx && height <= kLargestSidePx,
        "picture side out of range");
  Picture picture(width, height, background);
  rasterise_into(list, {0, 0, width, height}, picture);
  return picture;
}

void rasterise_into(DrawList const& list, PixelBox const& box, Picture& picture) {
  CHECK(box.left >= 0 && box.top >= 0 && box.width >= 0 && box.height >= 0 &&
            box.width <= picture.width - box.left && box.height <= picture.height - box.top,
        "the box lies in the picture");
  Rasteriser rasteriser(picture, box);
  for (auto const& item : list) std::visit(rasteriser, item);
}

}  // namespace inkflate
