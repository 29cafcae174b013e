// SPDX-License-Identifier: Apache-2.0
#include "deform/outline_ride.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace inkflate {
namespace {

// A cut is no nearer than this to an end of its piece, in t.
constexpr double kLeastShare = 1e-3;
// Of one piece that is cut by its length.
constexpr double kMostCuts = 1000;

/// Adding zeros may change a negative zero.
Vec2 shifted(Vec2 place, Vec2 shift) { return shift == Vec2{} ? place : place + shift; }

double largest_difference(Cubic const& a, Cubic const& b) {
  double largest = 0;
  for (int k = 0; k < 4; ++k) largest = std::max(largest, distance(a.control[k], b.control[k]));
  return largest;
}

/// Where a line's vertices cut a piece, t.
std::vector<double> cuts_at(std::span<double const> parameters, int piece) {
  std::vector<double> cuts;
  auto next = std::upper_bound(parameters.begin(), parameters.end(), piece + kLeastShare);
  for (; next != parameters.end() && *next < piece + 1 - kLeastShare; ++next)
    cuts.push_back(*next - piece);
  return cuts;
}

/// Cuts about so far apart.
std::vector<double> cuts_by_length(Cubic const& curve, double edge_px) {
  double const wanted = std::clamp(std::ceil(length(curve.control) / edge_px), 1.0, kMostCuts);
  int const count = static_cast<int>(wanted);
  std::vector<double> cuts;
  for (int k = 1; k < count; ++k) cuts.push_back(static_cast<double>(k) / count);
  return cuts;
}

}  // namespace

OutlineRide::OutlineRide(Outline outline, ShapeMesh const& shape, int index, RidePlaces& places)
    : rest_(std::move(outline)) {
  auto const& origins = shape.origins;
  auto const own = std::find_if(origins.begin(), origins.end(),
                                [&](BendLineOrigin const& o) { return o.index == index; });
  bool const has_line = own != origins.end();
  line_ = has_line ? static_cast<int>(own - origins.begin()) : -1;
  for (int i = 0; i < std::ssize(rest_.pieces); ++i) {
    auto const& curve = rest_.pieces[i].curve;
    cut_piece(i, has_line ? cuts_at(own->parameters, i) : cuts_by_length(curve, shape.mesh.edge_px),
              places);
  }
}

void OutlineRide::cut_piece(int piece, std::span<double const> cuts, RidePlaces& places) {
  int const first = static_cast<int>(std::ssize(cuts_));
  auto const& curve = rest_.pieces[piece].curve;
  cuts_.push_back({static_cast<double>(piece), add_place(piece, curve.start(), places)});
  for (double const t : cuts) cuts_.push_back({piece + t, 0});
  int const end = static_cast<int>(std::ssize(cuts_));
  auto const parameter = [&](int cut) { return cut < end ? cuts_[cut].parameter : piece + 1.0; };
  auto k = stretches_.size();
  whole_.push_back(static_cast<int>(k));
  stretches_.push_back({curve, first, end});
  for (; k < stretches_.size(); ++k) {
    auto stretch = stretches_[k];
    if (stretch.to - stretch.from < 2) continue;
    int const middle = (stretch.from + stretch.to) / 2;
    double const start = parameter(stretch.from);
    stretch.split = (parameter(middle) - start) / (parameter(stretch.to) - start);
    stretch.halves = static_cast<int>(std::ssize(stretches_));
    auto const halves = split(stretch.rest, stretch.split);
    cuts_[middle].place = add_place(parameter(middle), halves.second.start(), places);
    stretches_[k] = stretch;
    stretches_.push_back({halves.first, stretch.from, middle});
    stretches_.push_back({halves.second, middle, stretch.to});
  }
}

int OutlineRide::add_place(double parameter, Vec2 place, RidePlaces& places) const {
  return line_ >= 0 ? places.add_on_line(line_, parameter, place) : places.add(place);
}

Cubic OutlineRide::bent_stretch(Stretch const& stretch, std::span<VertexMotion const> moved) const {
  auto const& from = moved[stretch.from];
  auto const& to = moved[stretch.to % std::ssize(moved)];
  auto const& rest = stretch.rest.control;
  return {{shifted(rest[0], from.shift),
           shifted(rest[1], from.shift + from.change(rest[1] - rest[0])),
           shifted(rest[2], to.shift + to.change(rest[2] - rest[3])), shifted(rest[3], to.shift)}};
}

std::vector<OutlineRide::BentStretch> OutlineRide::bent_stretches(
    RidePlaces const& places, std::span<VertexMotion const> motions) const {
  std::vector<VertexMotion> moved;
  for (auto const& cut : cuts_)
    moved.push_back({places.shift(motions, cut.place), places.change(motions, cut.place)});
  std::vector<BentStretch> bent(stretches_.size());
  // Halves stand behind the stretch that they are of.
  for (int k = static_cast<int>(std::ssize(stretches_)) - 1; k >= 0; --k) {
    auto const& stretch = stretches_[k];
    bent[k].curve = bent_stretch(stretch, moved);
    if (stretch.halves < 0) continue;
    auto const& first = bent[stretch.halves];
    auto const& second = bent[stretch.halves + 1];
    auto const halves = split(bent[k].curve, stretch.split);
    bent[k].error_px = std::max(first.error_px, second.error_px) +
                       std::max(largest_difference(halves.first, first.curve),
                                largest_difference(halves.second, second.curve));
  }
  return bent;
}

Outline OutlineRide::bent(RidePlaces const& places, std::span<VertexMotion const> motions,
                          double tolerance_px, PlaceGrid const& grid) const {
  auto const bent = bent_stretches(places, motions);
  Outline result;
  std::vector<int> kept;
  std::vector<int> open;
  for (std::size_t piece = 0; piece < rest_.pieces.size(); ++piece) {
    open.push_back(whole_[piece]);
    while (!open.empty()) {
      int const k = open.back();
      open.pop_back();
      int const halves = stretches_[k].halves;
      if (halves >= 0 && bent[k].error_px > tolerance_px) {
        open.push_back(halves + 1);
        open.push_back(halves);
        continue;
      }
      result.pieces.push_back({bent[k].curve, rest_.pieces[piece].kind});
      auto& curve = result.pieces.back().curve;
      for (std::size_t c = 0; c < curve.control.size(); ++c) {
        curve.control[c] = grid(stretches_[k].rest.control[c], curve.control[c]);
      }
      kept.push_back(stretches_[k].from);
    }
  }
  result.sources = rest_.sources;
  if (kept.size() > rest_.pieces.size()) place_sources(kept, result.sources);
  return result;
}

void OutlineRide::place_sources(std::span<int const> kept, std::vector<InkSource>& sources) const {
  double const whole = static_cast<double>(std::ssize(rest_.pieces));
  int const count = static_cast<int>(std::ssize(kept));
  auto const place = [&](double parameter) {
    double const rounds = std::floor(parameter / whole);
    double const own = parameter - rounds * whole;
    auto const after = std::upper_bound(kept.begin(), kept.end(), own, [&](double value, int cut) {
      return value < cuts_[cut].parameter;
    });
    int const i = std::max(0, static_cast<int>(after - kept.begin()) - 1);
    double const start = cuts_[kept[i]].parameter;
    double const end = i + 1 < count ? cuts_[kept[i + 1]].parameter : whole;
    return rounds * count + i + (own - start) / (end - start);
  };
  for (auto& source : sources) {
    source.from = place(source.from);
    source.to = place(source.to);
  }
}

}  // namespace inkflate
