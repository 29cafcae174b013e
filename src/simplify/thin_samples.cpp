// SPDX-License-Identifier: Apache-2.0
#include "simplify/thin_samples.h"

#include "image/grid2.h"

namespace inkflate {
namespace {

/// Squares as large as the distance, each with the samples that were kept in it.
class KeptSquares {
 public:
  KeptSquares(StrokeSamples const& samples, double distance_px) : distance_px_(distance_px) {
    Rect box;
    for (auto const& point : samples.points) box.include(point.position);
    if (box.is_empty()) return;
    origin_ = box.min;
    last_ = Grid2<int>(column(box.max.x) + 2, row(box.max.y) + 2, -1);
  }

  /// Whether one of the samples near p is so near; differs(index): but not this one.
  template <typename Differs>
  bool has_near(Vec2 p, StrokeSamples const& kept, Differs differs) const {
    int const x = column(p.x);
    int const y = row(p.y);
    for (int j = y - 1; j <= y + 1; ++j) {
      for (int i = x - 1; i <= x + 1; ++i) {
        for (int k = last_.at(i, j); k >= 0; k = before_[k]) {
          if (squared_norm(kept.points[k].position - p) < distance_px_ * distance_px_ &&
              !differs(k)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /// index: that of the next one kept.
  void keep(Vec2 p, int index) {
    int& last = last_.at(column(p.x), row(p.y));
    before_.push_back(last);
    last = index;
  }

 private:
  // The first column and row stay empty, as do the last ones.
  int column(double x) const { return static_cast<int>((x - origin_.x) / distance_px_) + 1; }
  int row(double y) const { return static_cast<int>((y - origin_.y) / distance_px_) + 1; }

  double distance_px_;
  Vec2 origin_;
  Grid2<int> last_;          // per square; -1: none
  std::vector<int> before_;  // per kept sample: the one before it in its square; -1: none
};

}  // namespace

StrokeSamples thin_samples(Sketch const& sketch, StrokeSamples const& samples, double distance_px) {
  StrokeSamples kept;
  kept.spacing_px = samples.spacing_px + distance_px;
  KeptSquares squares(samples, distance_px);
  auto const kind = [&](StrokeSample const& sample) { return sketch.strokes[sample.stroke].kind; };
  for (int k = 0; k < std::ssize(samples.points); ++k) {
    auto const& point = samples.points[k];
    if (squares.has_near(point.position, kept,
                         [&](int other) { return kind(kept.points[other]) != kind(point); })) {
      continue;
    }
    squares.keep(point.position, static_cast<int>(std::ssize(kept.points)));
    kept.points.push_back(point);
    kept.lattice.push_back(samples.lattice[k]);
  }
  return kept;
}

}  // namespace inkflate
