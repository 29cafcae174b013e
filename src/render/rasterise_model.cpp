// SPDX-License-Identifier: Apache-2.0
#include "render/rasterise_model.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "image/filter.h"
#include "image/to_byte.h"
#include "render/ground_shadow.h"
#include "render/model_edges.h"
#include "render/model_light.h"
#include "render/palette.h"
#include "render/sample_band.h"
#include "render/sample_texture.h"
#include "render/surface_normal.h"

namespace inkflate {
namespace {

constexpr int kLargestSidePx = 16384;
constexpr int kBandRowsPx = 16;
constexpr int kSamples = kSamplesAcross * kSamplesAcross;
/// Half the width of an inked edge and the least step in depth that is one, as shares of the picture's longer side.
constexpr double kEdgeShare = 0.0019;
constexpr double kJumpShare = 0.008;
constexpr double kThinnestEdgePx = 0.6;

Rgb rgb_of(Colour colour) {
  return {static_cast<double>(colour.r), static_cast<double>(colour.g),
          static_cast<double>(colour.b)};
}

/// What the samples of a pixel add up to.
struct PixelSum {
  Rgb colour;
  int samples = 0;

  void add(Rgb sample, int count = 1) {
    colour = colour + count * sample;
    samples += count;
  }
};

Colour over_background(PixelSum const& sum, Colour background) {
  double const alpha = static_cast<double>(sum.samples) / kSamples;
  double const below = (1 - alpha) * background.a / 255;
  double const whole = alpha + below;
  if (whole <= 0) return background;
  auto const channel = [&](double upper, std::uint8_t lower) {
    return to_byte(std::clamp((upper / kSamples + lower * below) / whole, 0.0, 255.0));
  };
  return {channel(sum.colour.r, background.r), channel(sum.colour.g, background.g),
          channel(sum.colour.b, background.b), to_byte(255 * whole)};
}

/// How many texels lie between neighbouring samples, on average over the surface.
double texels_per_sample(DrawTriangles const& list) {
  double texels = 0;
  double surface = 0;
  for (std::size_t t = 0; t < list.corners.size(); ++t) {
    auto const& [a, b, c] = list.corners[t];
    texels += std::abs(cross(b - a, c - a));
    auto const point = [&](std::size_t k) {
      return list.positions[static_cast<std::size_t>(list.triangles[t][k])];
    };
    surface += norm(cross(point(1) - point(0), point(2) - point(0)));
  }
  texels *= static_cast<double>(list.texture->width) * list.texture->height;
  return surface > 0 ? std::sqrt(texels / surface) / kSamplesAcross : 1;
}

class ModelRasteriser {
 public:
  ModelRasteriser(DrawTriangles const& list, int width, int height)
      : list_(list),
        grid_(list, width, height),
        edges_(edge_options(width, height)),
        halo_(list.shading == Shading::Lines ? edge_reach(edges_) : 0),
        band_(grid_.width(), kBandRowsPx * kSamplesAcross + 2 * halo_) {
    texture_ = list.corners.size() == list.triangles.size() ? list.texture : nullptr;
    if (texture_ && (texture_->width == 0 || texture_->height == 0)) texture_ = nullptr;
    if (texture_) shrink_texture();
    sort_into_bands(height);
  }

  void draw(Picture& picture) {
    for (int top = 0, i = 0; top < picture.height; top += kBandRowsPx, ++i) {
      band_.start(top * kSamplesAcross - halo_);
      for (int const triangle : bands_[static_cast<std::size_t>(i)]) band_.add(grid_, triangle);
      if (list_.shading == Shading::Lines) ink_ = ink_edges(list_, grid_, band_, edges_);
      int const end = std::min(top + kBandRowsPx, picture.height);
      for (int y = top; y < end; ++y) {
        for (int x = 0; x < picture.width; ++x) {
          auto& pixel = picture.at(x, y);
          int const row = (y - top) * kSamplesAcross + halo_;
          auto const sum = list_.shading == Shading::Lines ? inked(x, row) : lit(x, row);
          if (sum.samples > 0) pixel = over_background(sum, pixel);
        }
      }
    }
  }

 private:
  static EdgeOptions edge_options(int width, int height) {
    double const longer_px = std::max(width, height);
    return {std::max(kThinnestEdgePx, kEdgeShare * longer_px) * kSamplesAcross,
            kJumpShare * longer_px};
  }

  /// Samples that skip texels would flicker.
  void shrink_texture() {
    double const texels = texels_per_sample(list_);
    int halvings = 0;
    while (halvings < 14 && texels > static_cast<double>(2 << halvings)) ++halvings;
    int const width = texture_->width >> halvings;
    int const height = texture_->height >> halvings;
    if (halvings == 0 || width == 0 || height == 0) return;
    small_texture_ = shrink(*texture_, width, height);
    texture_ = &small_texture_;
  }

  void sort_into_bands(int height) {
    int const count = (height + kBandRowsPx - 1) / kBandRowsPx;
    bands_.resize(static_cast<std::size_t>(count));
    for (std::size_t t = 0; t < list_.triangles.size(); ++t) {
      auto const [first, last] = grid_.rows(static_cast<int>(t));
      int const band_rows = kBandRowsPx * kSamplesAcross;
      if (last < -halo_ || first >= grid_.height() + halo_) continue;
      int const from = std::max(0, first - halo_) / band_rows;
      int const to = std::min(grid_.height() - 1, last + halo_) / band_rows;
      for (int i = from; i <= to; ++i) {
        bands_[static_cast<std::size_t>(i)].push_back(static_cast<int>(t));
      }
    }
  }

  /// One light for all samples of a triangle in the pixel, the texture for each of them.
  PixelSum lit(int pixel_x, int row) const {
    PixelSum sum;
    unsigned done = 0;
    for (int i = 0; i < kSamples; ++i) {
      if (done >> i & 1U) continue;
      int const triangle = seen(pixel_x, row, i);
      if (triangle < 0) continue;
      unsigned same = 0;
      for (int k = i; k < kSamples; ++k) {
        if (seen(pixel_x, row, k) == triangle) same |= 1U << k;
      }
      done |= same;
      add_triangle(sum, triangle, pixel_x, row, same);
    }
    return sum;
  }

  int seen(int pixel_x, int row, int sample) const {
    return band_.triangles().at(pixel_x * kSamplesAcross + sample % kSamplesAcross,
                                row + sample / kSamplesAcross);
  }

  void add_triangle(PixelSum& sum, int triangle, int pixel_x, int row, unsigned samples) const {
    Vec2 const corner = {pixel_x * kSamplesAcross + 0.5, band_.top() + row + 0.5};
    Vec2 middle;
    int count = 0;
    for (int i = 0; i < kSamples; ++i) {
      if (!(samples >> i & 1U)) continue;
      middle += corner + offset(i);
      ++count;
    }
    middle = middle / count;
    auto const normal = surface_normal(list_, grid_, triangle, middle.x, middle.y);
    if (!texture_) return sum.add(clay_colour(normal), count);
    auto const light = soft_light(normal);
    // Places on the texture run evenly across a triangle: three give all.
    Vec2 const origin = texture_place(triangle, corner);
    Vec2 const across = texture_place(triangle, corner + Vec2{1, 0}) - origin;
    Vec2 const down = texture_place(triangle, corner + Vec2{0, 1}) - origin;
    for (int i = 0; i < kSamples; ++i) {
      if (!(samples >> i & 1U)) continue;
      Vec2 const place = origin + offset(i).x * across + offset(i).y * down;
      sum.add(clamped(light.factor * sample_texture(*texture_, place) + light.gloss));
    }
  }

  Vec2 texture_place(int triangle, Vec2 sample) const {
    auto const weights = grid_.weights(triangle, sample.x, sample.y);
    auto const& [a, b, c] = list_.corners[static_cast<std::size_t>(triangle)];
    return weights[0] * a + weights[1] * b + weights[2] * c;
  }

  static Rgb clamped(Rgb c) {
    return {std::min(c.r, 255.0), std::min(c.g, 255.0), std::min(c.b, 255.0)};
  }

  static Vec2 offset(int sample) {
    int const row = sample / kSamplesAcross;
    return {static_cast<double>(sample % kSamplesAcross), static_cast<double>(row)};
  }

  PixelSum inked(int pixel_x, int row) const {
    PixelSum sum;
    for (int i = 0; i < kSamples; ++i) {
      int const x = pixel_x * kSamplesAcross + i % kSamplesAcross;
      int const y = row + i / kSamplesAcross;
      int const triangle = band_.triangles().at(x, y);
      if (ink_.at(x, y) != 0) {
        sum.add(rgb_of(palette::kInk));
      } else if (triangle >= 0) {
        sum.add(
            paper_colour(surface_normal(list_, grid_, triangle, x + 0.5, band_.top() + y + 0.5)));
      }
    }
    return sum;
  }

  DrawTriangles const& list_;
  SampleGrid grid_;
  EdgeOptions edges_;
  int halo_ = 0;  // rows of samples beyond the band that its edges depend on
  SampleBand band_;
  Mask ink_;
  Picture const* texture_ = nullptr;
  Picture small_texture_;
  std::vector<std::vector<int>> bands_;  // triangles
};

}  // namespace

Picture rasterise_model(DrawTriangles const& list, int width, int height,
                        ModelPictureOptions const& options) {
  CHECK(width >= 0 && height >= 0 && width <= kLargestSidePx && height <= kLargestSidePx,
        "picture side out of range");
  Picture picture(width, height, options.background);
  if (options.shadow == GroundShadow::On) draw_ground_shadow(list, picture);
  ModelRasteriser(list, width, height).draw(picture);
  return picture;
}

}  // namespace inkflate
