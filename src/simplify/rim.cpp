// SPDX-License-Identifier: Apache-2.0
#include "simplify/rim.h"

#include "simplify/cell_cut.h"

namespace inkflate {
namespace {

bool is_rim_edge(Triangulation const& mesh, std::span<std::uint8_t const> inside, int e) {
  return inside[e / 3] != 0 && (mesh.twins[e] < 0 || inside[mesh.twins[e] / 3] == 0);
}

/// The rim edge that follows e: turn about e's end through the inside cells that share it. So cells that meet only there stay
/// on rims of their own.
int next_rim_edge(Triangulation const& mesh, std::span<std::uint8_t const> inside, int e) {
  int next = next_half_edge(e);
  while (!is_rim_edge(mesh, inside, next)) next = next_half_edge(mesh.twins[next]);
  return next;
}

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

EdgeKinds::EdgeKinds(Sketch const& sketch, StrokeSamples const& samples)
    : samples_(&samples), longest_ink_(longest_ink_edge_squared(samples)) {
  for (auto const& stroke : sketch.strokes) {
    is_help_.push_back(stroke.kind == StrokeKind::HelpLine ? 1 : 0);
  }
}

RunKind EdgeKinds::operator()(int sample_a, int sample_b) const {
  auto const a = samples_->lattice[sample_a];
  auto const b = samples_->lattice[sample_b];
  std::int64_t const dx = b.x - a.x;
  std::int64_t const dy = b.y - a.y;
  if (dx * dx + dy * dy > longest_ink_) return RunKind::Closing;
  bool const both_help = is_help_[samples_->points[sample_a].stroke] != 0 &&
                         is_help_[samples_->points[sample_b].stroke] != 0;
  return both_help ? RunKind::HelpLine : RunKind::Ink;
}

std::vector<Rim> trace_rims(Triangulation const& mesh, std::span<std::uint8_t const> inside,
                            EdgeKinds const& kind_of) {
  std::vector<Rim> rims;
  std::vector<std::uint8_t> is_done(mesh.corners.size(), 0);
  LoopSplitter splitter(static_cast<int>(std::ssize(mesh.same_as)), rims);
  for (int start = 0; start < std::ssize(mesh.corners); ++start) {
    if (is_done[start] != 0 || !is_rim_edge(mesh, inside, start)) continue;
    int e = start;
    do {
      is_done[e] = 1;
      splitter.add(mesh.corners[e], kind_of);
      e = next_rim_edge(mesh, inside, e);
    } while (e != start);
    splitter.finish(kind_of);
  }
  return rims;
}

Contour positions(Rim const& rim, StrokeSamples const& samples) {
  Contour contour;
  contour.reserve(rim.size());
  for (auto const& point : rim) contour.push_back(samples.points[point.sample].position);
  return contour;
}

}  // namespace inkflate
