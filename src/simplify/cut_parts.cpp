// SPDX-License-Identifier: Apache-2.0
#include "simplify/cut_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/crossings.h"
#include "simplify/carve_holes.h"
#include "simplify/cell_cut.h"
#include "simplify/prune_whiskers.h"

namespace inkflate {
namespace {

// What is nowhere wider is a line, not a shape, work px: about three times the width of a pencil line.
constexpr double kWhiskerPx = 7;

// A piece with less than this share of the largest one's area is a speck.
constexpr double kLeastShare = 0.01;

/// An outer rim and the holes in it.
struct Part {
  int outer;
  std::vector<int> holes;
  double area_px2;
};

/// Whether a hole lies in an outer rim. They may share a corner, so no single one decides.
bool holds(Contour const& outer, Contour const& hole) {
  auto const third = hole.size() / 3;
  int within = 0;
  for (auto const corner : {hole[0], hole[third], hole[2 * third]})
    within += contains(outer, corner) ? 1 : 0;
  return within >= 2;
}

/// Sorts rims into parts, largest first. A hole belongs to the smallest outer rim around it.
std::vector<Part> nest(std::vector<Contour> const& contours) {
  std::vector<Part> parts;
  std::vector<int> holes;
  for (int r = 0; r < std::ssize(contours); ++r) {
    double const area = signed_area(contours[r]);
    if (area > 0) {
      parts.push_back({r, {}, area});
    } else if (area < 0) {
      holes.push_back(r);
    }
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](Part const& a, Part const& b) { return a.area_px2 > b.area_px2; });
  for (int const hole : holes) {
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
      if (part->area_px2 > -signed_area(contours[hole]) &&
          holds(contours[part->outer], contours[hole])) {
        part->holes.push_back(hole);
        break;
      }
    }
  }
  return parts;
}

Error cancelled() { return {ErrorCode::Cancelled, "stopped on request"}; }

CutOptions cut_options(SimplifyOptions const& options, WorkSpace const& space, Cells const& cells) {
  CutOptions cut;
  if (options.gap_px) cut.gap_px = *options.gap_px * space.to_work;
  for (auto const mark : options.outside) cut.outside.push_back(space.work_point(mark));
  for (auto const mark : options.inside) cut.inside.push_back(space.work_point(mark));
  if (options.marks_beyond == MarksBeyond::PassOver || options.parts == Parts::Groups)
    std::erase_if(cut.inside, [&](Vec2 mark) { return find_cell(cells, mark) < 0; });
  return cut;
}

/// The mean width of what a contour encloses: a long band of width w has area w L and perimeter 2 L.
double mean_width(Contour const& contour) {
  return 2 * std::abs(signed_area(contour)) / perimeter(contour);
}

/// The rims of everything that is wider than a line.
std::vector<Rim> wide_rims(std::vector<Rim> const& traced, StrokeSamples const& samples) {
  std::vector<Rim> rims;
  for (auto const& rim : traced) {
    auto pruned = prune_whiskers(rim, samples, kWhiskerPx);
    if (!pruned.empty()) rims.push_back(std::move(pruned));
  }
  return rims;
}

/// The parts that are no specks, as the options want them.
std::vector<Part> choose_parts(std::vector<Rim> const& rims, StrokeSamples const& samples,
                               Parts wanted) {
  std::vector<Contour> contours;
  for (auto const& rim : rims) contours.push_back(positions(rim, samples));
  auto parts = nest(contours);
  if (parts.empty()) return parts;
  double const least = kLeastShare * parts.front().area_px2;
  std::erase_if(parts, [&](Part const& part) {
    return part.area_px2 < least || mean_width(contours[part.outer]) < kWhiskerPx;
  });
  if (wanted == Parts::One && !parts.empty()) parts.resize(1);
  return parts;
}

/// Takes the chords' samples out of the rims, so that a closing along a chord is one edge from ink to ink. False: a rim is none then.
bool take_out_chords(std::vector<Rim>& rims, StrokeSamples const& samples) {
  for (auto& rim : rims) {
    bool const has_chord = std::any_of(rim.begin(), rim.end(), [&](RimPoint const& point) {
      return samples.is_chord(point.sample);
    });
    if (!has_chord) continue;
    int const count = static_cast<int>(std::ssize(rim));
    for (int i = 0; i < count; ++i) {
      if (samples.is_chord(rim[(i + 1) % count].sample)) rim[i].to_next = RunKind::Closing;
    }
    std::erase_if(rim, [&](RimPoint const& point) { return samples.is_chord(point.sample); });
    if (!is_simple(positions(rim, samples))) return false;
  }
  return true;
}

}  // namespace

Result<CutParts> cut_parts(Sketch const& sketch, StrokeSamples samples, WorkSpace const& space,
                           SimplifyOptions const& options, Progress const& progress) {
  if (!progress.enter("triangulate")) return cancelled();
  CutParts result;
  result.cells = make_cells(std::move(samples));
  auto const& cells = result.cells;
  if (!progress.enter("cut")) return cancelled();
  auto const cut = cut_options(options, space, cells);
  auto inside = label_cells(cells, cut);
  if (!inside) return inside.error();
  if (options.holes == Holes::Keep) {
    if (!progress.enter("holes")) return cancelled();
    std::vector<int> kept;
    for (auto const mark : cut.inside) kept.push_back(find_cell(cells, mark));
    inside = carve_holes(cells, *std::move(inside), kept);
  }

  if (!progress.enter("trace")) return cancelled();
  auto traced = wide_rims(trace_rims(sketch, cells, *inside), cells.samples);
  if (!take_out_chords(traced, cells.samples)) return result;
  for (auto const& part : choose_parts(traced, cells.samples, options.parts)) {
    std::vector<Rim> rims = {std::move(traced[part.outer])};
    for (int const hole : part.holes) rims.push_back(std::move(traced[hole]));
    result.parts.push_back(std::move(rims));
  }
  return result;
}

}  // namespace inkflate
