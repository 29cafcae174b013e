// SPDX-License-Identifier: Apache-2.0
#include "render/dash.h"

#include <algorithm>

#include "base/check.h"

namespace inkflate {
namespace {

/// No line gets more dashes than this: a hostile length would otherwise fill the memory.
constexpr int kMostDashes = 100'000;

/// Walks along a line and cuts it where the pattern changes.
class Dasher {
 public:
  explicit Dasher(StrokedPolyline const& line) : line_(line), left_px_(line.dashes_px[0]) {
    start_piece(line.points[0], width(0));
  }

  std::vector<StrokedPolyline> pieces() && {
    int const last = static_cast<int>(line_.points.size()) - 1;
    for (int i = 0; i < last && std::ssize(pieces_) < kMostDashes; ++i) walk_segment(i);
    if (is_on_) pieces_.push_back(piece_);
    return std::move(pieces_);
  }

 private:
  double width(int i) const {
    return line_.widths_px.size() == 1 ? line_.widths_px[0]
                                       : line_.widths_px[static_cast<std::size_t>(i)];
  }

  void start_piece(Vec2 point, double width_px) {
    piece_ = StrokedPolyline{{point}, {width_px}, {}, line_.colour};
  }

  void walk_segment(int i) {
    Vec2 const a = line_.points[static_cast<std::size_t>(i)];
    Vec2 const b = line_.points[static_cast<std::size_t>(i) + 1];
    double const length_px = distance(a, b);
    double done_px = 0;
    while (length_px - done_px > left_px_ && std::ssize(pieces_) < kMostDashes) {
      done_px += left_px_;
      double const t = done_px / length_px;
      turn(lerp(a, b, t), width(i) + t * (width(i + 1) - width(i)));
    }
    left_px_ -= length_px - done_px;
    if (is_on_) extend(b, width(i + 1));
  }

  void extend(Vec2 point, double width_px) {
    if (point == piece_.points.back()) return;
    piece_.points.push_back(point);
    piece_.widths_px.push_back(width_px);
  }

  /// Ends or starts a dash here.
  void turn(Vec2 point, double width_px) {
    if (is_on_) {
      extend(point, width_px);
      pieces_.push_back(piece_);
    } else {
      start_piece(point, width_px);
    }
    is_on_ = !is_on_;
    index_ = (index_ + 1) % line_.dashes_px.size();
    left_px_ = line_.dashes_px[index_];
  }

  StrokedPolyline const& line_;
  std::vector<StrokedPolyline> pieces_;
  StrokedPolyline piece_;
  bool is_on_ = true;
  std::size_t index_ = 0;
  double left_px_ = 0;
};

}  // namespace

std::vector<StrokedPolyline> dashes(StrokedPolyline const& line) {
  if (line.dashes_px.empty() || line.points.empty()) return {line};
  double sum_px = 0;
  for (double const dash_px : line.dashes_px) sum_px += std::max(dash_px, 0.0);
  CHECK(line.dashes_px.size() % 2 == 0 && sum_px > 0, "a dash pattern is pairs with a length");
  return Dasher(line).pieces();
}

}  // namespace inkflate
