// SPDX-License-Identifier: Apache-2.0
#include "editor/smooth_stroke.h"

#include <algorithm>
#include <iterator>

namespace inkflate {
namespace {

// Cosines of the turn between the two halves of a window, up to which it stays whole and from which it vanishes. The halves of a
// window around a right angle turn by 53 degrees (0.6), around a corner of 30 degrees by 18 (0.95), those on a circle whose radius is
// the half window by 23 (0.92).
constexpr double kStraightCosine = 0.95;
constexpr double kCornerCosine = 0.75;

/// The line from a sample on, towards one of its ends.
enum class Way { Back = -1, Forth = 1 };

/// A weighted sum of places.
struct Sum {
  Vec2 place;
  double weight = 0;

  Vec2 mean() const { return place / weight; }
};

Sum operator+(Sum const& a, Sum const& b) { return {a.place + b.place, a.weight + b.weight}; }

/// Length of the line from a sample to an end, or limit where that is less.
double room(std::vector<Sample> const& raw, int sample, Way way, double limit) {
  int const count = static_cast<int>(std::ssize(raw));
  int const step = static_cast<int>(way);
  double sum = 0;
  for (int i = sample + step; i >= 0 && i < count && sum < limit; i += step) {
    sum += distance(raw[i - step].position, raw[i].position);
  }
  return std::min(sum, limit);
}

/// The integral of the line over the length d from a sample, 0 .. reach, weighted by 1 - (d / reach)^2. In closed form for each
/// segment, so that straight lines stay what they are however their samples are spaced.
Sum integral(std::vector<Sample> const& raw, int sample, Way way, double reach) {
  int const count = static_cast<int>(std::ssize(raw));
  int const step = static_cast<int>(way);
  double const square = reach * reach;
  Sum sum;
  double from = 0;
  for (int i = sample + step; i >= 0 && i < count && from < reach; i += step) {
    auto const near = raw[i - step].position;
    auto const along = raw[i].position - near;
    double const size = norm(along);
    if (size <= 0) continue;
    double const to = std::min(from + size, reach);
    auto const zeroth = [&](double d) { return d - d * d * d / (3 * square); };
    auto const first = [&](double d) { return d * d / 2 - d * d * d * d / (4 * square); };
    double const weight = zeroth(to) - zeroth(from);
    double const moment = first(to) - first(from) - from * weight;
    sum = sum + Sum{near * weight + along * (moment / size), weight};
    from += size;
  }
  return sum;
}

Sum integral(std::vector<Sample> const& raw, int sample, double reach) {
  return integral(raw, sample, Way::Back, reach) + integral(raw, sample, Way::Forth, reach);
}

/// How much of a window a turn leaves: 1 where the line is straight, 0 at corners. Means decide, not samples, since a tremble turns
/// from one sample to the next more sharply than any corner.
double straightness(std::vector<Sample> const& raw, int sample, double reach) {
  auto const middle = integral(raw, sample, reach / 2).mean();
  auto const before = middle - integral(raw, sample, Way::Back, reach).mean();
  auto const after = integral(raw, sample, Way::Forth, reach).mean() - middle;
  double const size = norm(before) * norm(after);
  double const cosine = size > 0 ? dot(before, after) / size : -1;
  return std::clamp((cosine - kCornerCosine) / (kStraightCosine - kCornerCosine), 0.0, 1.0);
}

Vec2 smoothed(std::vector<Sample> const& raw, int sample, double half_width_px) {
  auto const here = raw[sample].position;
  double const back = room(raw, sample, Way::Back, half_width_px);
  double const reach = room(raw, sample, Way::Forth, back);
  // Windows much shorter than any distance between samples would only divide rounding errors by one another.
  if (reach <= half_width_px * 1e-6) return here;
  double const window = reach * straightness(raw, sample, reach);
  if (window <= half_width_px * 1e-6) return here;
  return integral(raw, sample, window).mean();
}

}  // namespace

void smooth_end(std::vector<Sample> const& raw, double half_width_px, std::vector<Sample>& smooth) {
  int const count = static_cast<int>(std::ssize(raw));
  int first = std::min(static_cast<int>(std::ssize(smooth)), count);
  // Once more what was the last sample, and those whose window ended there.
  double length_px = 0;
  first = std::max(first - 1, 0);
  while (first > 0 && length_px < half_width_px) {
    length_px += distance(raw[first - 1].position, raw[first].position);
    --first;
  }
  smooth.resize(static_cast<std::size_t>(first));
  for (int i = first; i < count; ++i) {
    auto sample = raw[i];
    sample.position = smoothed(raw, i, half_width_px);
    smooth.push_back(sample);
  }
}

}  // namespace inkflate
