// SPDX-License-Identifier: Apache-2.0
#include "simplify/rim.h"

namespace inkflate {
namespace {

bool is_rim_edge(Cells const& cells, CellLabels const& inside, int e) {
  return inside[e / 3] != 0 && (cells.twin(e) < 0 || inside[cells.twin(e) / 3] == 0);
}

/// The rim edge that follows e: turn about e's end through the inside cells that share it. So cells that meet only there stay
/// on rims of their own.
int next_rim_edge(Cells const& cells, CellLabels const& inside, int e) {
  int next = next_half_edge(e);
  while (!is_rim_edge(cells, inside, next)) next = next_half_edge(cells.twin(next));
  return next;
}

/// What the edge between two samples is: ink or help line up to the length of an ink edge, a closing above.
class EdgeKinds {
 public:
  EdgeKinds(Sketch const& sketch, Cells const& cells) : cells_(&cells) {
    for (auto const& stroke : sketch.strokes)
      is_help_.push_back(stroke.kind == StrokeKind::HelpLine ? 1 : 0);
  }

  RunKind operator()(int sample_a, int sample_b) const {
    auto const a = cells_->samples.lattice[sample_a];
    auto const b = cells_->samples.lattice[sample_b];
    if ((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y) > cells_->longest_ink_squared)
      return RunKind::Closing;
    return is_help(sample_a) && is_help(sample_b) ? RunKind::HelpLine : RunKind::Ink;
  }

 private:
  bool is_help(int sample) const {
    auto const& samples = cells_->samples;
    return !samples.is_chord(sample) && is_help_[samples.points[sample].stroke] != 0;
  }

  Cells const* cells_;
  std::vector<std::uint8_t> is_help_;  // per stroke
};

/// Takes a closed walk apart where it comes back to a corner, so that each piece visits every corner once.
class LoopSplitter {
 public:
  LoopSplitter(int sample_count, std::vector<Rim>& rims)
      : place_(static_cast<std::size_t>(sample_count), -1), rims_(&rims) {}

  void add(int sample, EdgeKinds const& kind_of) {
    if (place_[sample] >= 0) close_from(place_[sample], kind_of);
    place_[sample] = static_cast<int>(std::ssize(open_));
    open_.push_back(sample);
  }

  void finish(EdgeKinds const& kind_of) { close_from(0, kind_of); }

 private:
  void close_from(int first, EdgeKinds const& kind_of) {
    int const size = static_cast<int>(std::ssize(open_)) - first;
    Rim rim;
    for (int i = 0; i < size; ++i) {
      int const sample = open_[first + i];
      rim.push_back({sample, kind_of(sample, open_[first + (i + 1) % size])});
      place_[sample] = -1;
    }
    open_.resize(static_cast<std::size_t>(first));
    if (size >= 3) rims_->push_back(std::move(rim));
  }

  std::vector<int> open_;
  std::vector<int> place_;  // per sample: where it stands in open_, or -1
  std::vector<Rim>* rims_;
};

}  // namespace

std::vector<Rim> trace_rims(Sketch const& sketch, Cells const& cells, CellLabels const& inside) {
  std::vector<Rim> rims;
  EdgeKinds const kind_of(sketch, cells);
  std::vector<std::uint8_t> is_done(cells.mesh.corners.size(), 0);
  LoopSplitter splitter(static_cast<int>(std::ssize(cells.samples.points)), rims);
  for (int start = 0; start < 3 * cells.count(); ++start) {
    if (is_done[start] != 0 || !is_rim_edge(cells, inside, start)) continue;
    int e = start;
    do {
      is_done[e] = 1;
      splitter.add(cells.corner(e), kind_of);
      e = next_rim_edge(cells, inside, e);
    } while (e != start);
    splitter.finish(kind_of);
  }
  return rims;
}

Contour positions(Rim const& rim, StrokeSamples const& samples) {
  Contour contour;
  contour.reserve(rim.size());
  for (auto const& point : rim)
    contour.push_back(WorkSpace::lattice_position(samples.lattice[point.sample]));
  return contour;
}

}  // namespace inkflate
