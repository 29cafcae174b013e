// SPDX-License-Identifier: Apache-2.0
#include "render/picture_sampler.h"

#include <algorithm>

#include "image/filter.h"
#include "image/to_byte.h"

namespace inkflate {
namespace {

/// Samples that skip pixels would flicker.
Picture shrunk(Picture const& picture, double step_px) {
  if (!(step_px > 1)) return {};
  auto const side = [&](int side_px) { return std::max(1, static_cast<int>(side_px / step_px)); };
  return shrink(picture, side(picture.width), side(picture.height));
}

/// Two neighbours and the share of the second.
struct Between {
  int low = 0;
  int high = 0;
  double share = 0;
};

Between between(double place, int count) {
  double const centred = std::clamp(place - 0.5, 0.0, count - 1.0);
  int const low = static_cast<int>(centred);
  return {low, std::min(low + 1, count - 1), centred - low};
}

/// Colours weighted by what they cover, so that clear pixels lend no colour.
struct Mixture {
  double r = 0;
  double g = 0;
  double b = 0;
  double a = 0;

  void add(Colour colour, double weight) {
    double const covered = weight * colour.a;
    r += covered * colour.r;
    g += covered * colour.g;
    b += covered * colour.b;
    a += covered;
  }
};

}  // namespace

PictureSampler::PictureSampler(Picture const& picture, double step_px)
    : small_(shrunk(picture, step_px)),
      picture_(small_.values.empty() ? picture : small_),
      scale_{static_cast<double>(picture_.width) / picture.width,
             static_cast<double>(picture_.height) / picture.height} {}

Colour PictureSampler::operator()(Vec2 place) const {
  Vec2 const p = {place.x * scale_.x, place.y * scale_.y};
  if (!(p.x >= 0 && p.y >= 0 && p.x <= picture_.width && p.y <= picture_.height)) {
    return {0, 0, 0, 0};
  }
  auto const x = between(p.x, picture_.width);
  auto const y = between(p.y, picture_.height);
  Mixture sum;
  sum.add(picture_.at(x.low, y.low), (1 - x.share) * (1 - y.share));
  sum.add(picture_.at(x.high, y.low), x.share * (1 - y.share));
  sum.add(picture_.at(x.low, y.high), (1 - x.share) * y.share);
  sum.add(picture_.at(x.high, y.high), x.share * y.share);
  if (sum.a <= 0) return {0, 0, 0, 0};
  return {to_byte(sum.r / sum.a), to_byte(sum.g / sum.a), to_byte(sum.b / sum.a), to_byte(sum.a)};
}

}  // namespace inkflate
