// SPDX-License-Identifier: Apache-2.0
#include "geometry/curve_fit.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace inkflate {
namespace {

// Newton steps on the parameters before a piece is split instead; more change little (Schneider uses 4).
constexpr int kMostRefinements = 4;

// Refining helps only when the fit is already near: Schneider's threshold, as a factor on the squared error.
constexpr double kWorthRefining = 16;

// The range of sane handles, as a share of the chord.
constexpr double kLeastHandle = 0.02;
constexpr double kMostHandle = 3;

/// The points first .. last, and the tangents that the cubic must have.
struct Piece {
  int first;
  int last;
  Vec2 start_tangent;
  Vec2 end_tangent;
};

struct Worst {
  double squared = 0;
  int index = 0;
};

class Fitter {
 public:
  Fitter(std::span<Vec2 const> points, double tolerance)
      : points_(points), limit_(tolerance * tolerance) {}

  std::optional<Cubic> fit_free() {
    Piece const whole = {0, static_cast<int>(std::ssize(points_)) - 1, {}, {}};
    if (whole.last < 3) return std::nullopt;
    set_chord_parameters(whole);
    auto curve = free_least_squares();
    for (int i = 0; i < kMostRefinements; ++i) {
      if (worst_error(whole, curve).squared <= limit_) return curve;
      refine_parameters(whole, curve);
      curve = free_least_squares();
    }
    return std::nullopt;
  }

  std::vector<FittedCubic> fit(Vec2 start_tangent, Vec2 end_tangent) {
    std::vector<FittedCubic> fitted;
    std::vector<Piece> open = {
        {0, static_cast<int>(std::ssize(points_)) - 1, start_tangent, end_tangent}};
    while (!open.empty()) {
      auto const piece = open.back();
      open.pop_back();
      int split_at = -1;
      auto const curve = fit_one(piece, split_at);
      if (split_at < 0) {
        fitted.push_back({curve, piece.first, piece.last});
        continue;
      }
      auto const tangent = tangent_at(split_at);
      open.push_back({split_at, piece.last, tangent, piece.end_tangent});
      open.push_back(
          {piece.first, split_at, piece.start_tangent, tangent});  // taken next: order is kept
    }
    return fitted;
  }

 private:
  /// One cubic for the piece; split_at >= 0 when none is good enough.
  Cubic fit_one(Piece const& piece, int& split_at) {
    if (piece.last - piece.first == 1) return hermite(piece);
    set_chord_parameters(piece);
    auto curve = least_squares(piece);
    auto worst = worst_error(piece, curve);
    for (int i = 0; i < kMostRefinements && worst.squared > limit_; ++i) {
      if (worst.squared > limit_ * kWorthRefining) break;
      refine_parameters(piece, curve);
      curve = least_squares(piece);
      worst = worst_error(piece, curve);
    }
    split_at = worst.squared > limit_ ? worst.index : -1;
    return curve;
  }

  /// Both inner control points that make the sum of squared distances least, at the current parameters.
  Cubic free_least_squares() const {
    auto const start = points_.front();
    auto const end = points_.back();
    double c00 = 0;
    double c01 = 0;
    double c11 = 0;
    Vec2 x0;
    Vec2 x1;
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      double const t = parameters_[k];
      double const s = 1 - t;
      double const b1 = 3 * s * s * t;
      double const b2 = 3 * s * t * t;
      auto const rest = points_[k] - start * (s * s * s) - end * (t * t * t);
      c00 += b1 * b1;
      c01 += b1 * b2;
      c11 += b2 * b2;
      x0 += rest * b1;
      x1 += rest * b2;
    }
    double const determinant = c00 * c11 - c01 * c01;
    if (determinant <= 1e-9 * c00 * c11) return line_cubic(start, end);
    return {{start, (x0 * c11 - x1 * c01) / determinant, (x1 * c00 - x0 * c01) / determinant, end}};
  }

  /// With two points only the tangents say anything: handles of a third of the distance.
  Cubic hermite(Piece const& piece) const {
    auto const a = points_[piece.first];
    auto const b = points_[piece.last];
    double const third = distance(a, b) / 3;
    return {{a, a + piece.start_tangent * third, b - piece.end_tangent * third, b}};
  }

  void set_chord_parameters(Piece const& piece) {
    parameters_.assign(1, 0);
    for (int i = piece.first; i < piece.last; ++i) {
      parameters_.push_back(parameters_.back() + distance(points_[i], points_[i + 1]));
    }
    double const total = parameters_.back();
    if (total > 0) {
      for (auto& t : parameters_) t /= total;
    }
  }

  /// The two handle lengths that make the sum of squared distances least, at the current parameters.
  Cubic least_squares(Piece const& piece) const {
    auto const start = points_[piece.first];
    auto const end = points_[piece.last];
    double c00 = 0;
    double c01 = 0;
    double c11 = 0;
    double x0 = 0;
    double x1 = 0;
    double const turn = dot(piece.start_tangent, -piece.end_tangent);
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      double const t = parameters_[k];
      double const s = 1 - t;
      double const b1 = 3 * s * s * t;
      double const b2 = 3 * s * t * t;
      auto const rest = points_[piece.first + static_cast<int>(k)] - start * (s * s * s + b1) -
                        end * (t * t * t + b2);
      c00 += b1 * b1;
      c01 += b1 * b2 * turn;
      c11 += b2 * b2;
      x0 += b1 * dot(piece.start_tangent, rest);
      x1 += b2 * dot(-piece.end_tangent, rest);
    }
    double const determinant = c00 * c11 - c01 * c01;
    double const span = distance(start, end);
    double first = span / 3;
    double second = span / 3;
    if (std::abs(determinant) > 1e-9 * c00 * c11) {
      // Negative handles run backwards: a loop. Very long ones loop too.
      first =
          std::clamp((x0 * c11 - x1 * c01) / determinant, kLeastHandle * span, kMostHandle * span);
      second =
          std::clamp((c00 * x1 - c01 * x0) / determinant, kLeastHandle * span, kMostHandle * span);
    }
    return {{start, start + piece.start_tangent * first, end - piece.end_tangent * second, end}};
  }

  Worst worst_error(Piece const& piece, Cubic const& curve) const {
    Worst worst = {0, (piece.first + piece.last) / 2};
    for (int i = piece.first + 1; i < piece.last; ++i) {
      double const squared =
          squared_norm(point_at(curve, parameters_[i - piece.first]) - points_[i]);
      if (squared > worst.squared) worst = {squared, i};
    }
    return worst;
  }

  /// One Newton step for each parameter towards the nearest point of the curve; the order stays.
  void refine_parameters(Piece const& piece, Cubic const& curve) {
    auto const& p = curve.control;
    for (int i = piece.first + 1; i < piece.last; ++i) {
      double& t = parameters_[i - piece.first];
      auto const off = point_at(curve, t) - points_[i];
      auto const first = derivative_at(curve, t);
      auto const second = 6 * ((1 - t) * (p[2] - 2 * p[1] + p[0]) + t * (p[3] - 2 * p[2] + p[1]));
      double const slope = squared_norm(first) + dot(off, second);
      if (slope <= 0) continue;
      t = std::clamp(t - dot(off, first) / slope, parameters_[i - piece.first - 1], 1.0);
    }
  }

  /// The direction of travel at an inner point.
  Vec2 tangent_at(int i) const {
    int const count = static_cast<int>(std::ssize(points_));
    auto const wide = points_[std::min(count - 1, i + 2)] - points_[std::max(0, i - 2)];
    if (squared_norm(wide) > 0) return normalized(wide);
    return normalized(points_[i + 1] - points_[i]);
  }

  std::span<Vec2 const> points_;
  double limit_;
  std::vector<double> parameters_;
};

}  // namespace

std::optional<Cubic> fit_one_cubic(std::span<Vec2 const> points, double tolerance) {
  CHECK(points.size() >= 2, "a curve needs two points");
  CHECK(tolerance > 0, "no fit is exact");
  return Fitter(points, tolerance).fit_free();
}

std::vector<FittedCubic> fit_cubics(std::span<Vec2 const> points, Vec2 start_tangent,
                                    Vec2 end_tangent, double tolerance) {
  CHECK(points.size() >= 2, "a curve needs two points");
  CHECK(tolerance > 0, "no fit is exact");
  return Fitter(points, tolerance).fit(start_tangent, end_tangent);
}

}  // namespace inkflate
