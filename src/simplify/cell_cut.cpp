// SPDX-License-Identifier: Apache-2.0
#include "simplify/cell_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/min_cut.h"

namespace inkflate {
namespace {

// More than any cut of a drawing can cost in one place: 17 times the lattice's diagonal is below 2^19. Two of them on an arc and its
// reverse stay below 2^31.
constexpr std::int32_t kForced = 1 << 28;

// Of the width of the free disc around an outside mark: what is at least so wide is still the bay that was meant. At half the width, marks
// leaked into wings through gaps of their lines.
constexpr double kPassageOfDisc = 0.8;

/// Cells as nodes; a cell's half-edges are its arcs.
class CellTopology {
 public:
  static constexpr int kDegree = 3;
  explicit CellTopology(Cells const& cells) : cells_(&cells) {}
  int node_count() const { return cells_->count(); }
  int reverse(int arc) const { return cells_->twin(arc); }

 private:
  Cells const* cells_;
};

/// The capacities of the cell graph.
struct Capacities {
  std::vector<std::int32_t> arcs;
  std::vector<TerminalCapacity> terminals;
};

Capacities weigh(Cells const& cells, CutOptions const& options) {
  Capacities capacities;
  capacities.arcs.resize(cells.mesh.corners.size());
  capacities.terminals.resize(static_cast<std::size_t>(cells.count()));
  double const longest_gap =
      options.gap_px ? *options.gap_px : std::numeric_limits<double>::infinity();
  // In lattice units, so that whole numbers are fine enough.
  double const ink_weight = options.ink_weight * WorkSpace::kLatticePerPx;
  double const paper_weight = paper_weight_for_gap(options) * WorkSpace::kLatticePerPx;
  for (int e = 0; e < std::ssize(capacities.arcs); ++e) {
    double const length = cells.length_px(e);
    auto& terminal = capacities.terminals[e / 3];
    if (cells.is_ink(e)) {
      if (cells.is_chord(e)) continue;
      terminal.source += static_cast<std::int32_t>(ink_weight * length + 0.5);
      continue;
    }
    auto const cost =
        length > longest_gap ? kForced : static_cast<std::int32_t>(paper_weight * length + 0.5);
    if (cells.twin(e) < 0) {
      terminal.sink += cost;  // beyond the hull all is outside
    } else {
      capacities.arcs[e] = cost;
    }
  }
  return capacities;
}

/// From p to the nearest stroke, work px.
double clearance(Cells const& cells, Vec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (auto const& sample : cells.samples.points)
    nearest = std::min(nearest, squared_norm(sample.position - p));
  return std::sqrt(nearest);
}

/// The cells that stand for a mark: the one that holds it and those in the middle of the paper around it.
std::vector<int> free_disc(Cells const& cells, Vec2 mark) {
  double const radius = clearance(cells, mark);
  std::vector<int> found = {find_cell(cells, mark)};
  for (int t = 0; t < cells.count(); ++t) {
    auto const middle =
        (cells.position(cells.corner(3 * t)) + cells.position(cells.corner(3 * t + 1)) +
         cells.position(cells.corner(3 * t + 2))) /
        3;
    if (t != found.front() && squared_norm(middle - mark) < radius * radius) found.push_back(t);
  }
  return found;
}

/// The filled bay or region that a mark is in: all cells labelled inside that can be reached from it through passages hardly narrower than
/// the free disc around the mark. One click opens a bay to its end, and does not leak through a gap in its rim.
std::vector<int> marked_bay(Cells const& cells, CellLabels const& labels, Vec2 mark) {
  int const first = find_cell(cells, mark);
  if (first < 0) return {};
  double const passage_px = kPassageOfDisc * 2 * clearance(cells, mark);
  std::vector<int> found = {first};
  std::vector<std::uint8_t> is_found(labels.size(), 0);
  is_found[first] = 1;
  for (std::size_t next = 0; next < found.size(); ++next) {
    for (int e = 3 * found[next]; e < 3 * found[next] + 3; ++e) {
      int const other = cells.twin(e) / 3;
      if (cells.twin(e) < 0 || labels[other] == 0 || is_found[other] != 0) continue;
      if (cells.is_ink(e) || cells.length_px(e) <= passage_px) continue;
      is_found[other] = 1;
      found.push_back(other);
    }
  }
  return found;
}

}  // namespace

double paper_weight_for_gap(CutOptions const& options) {
  if (!options.gap_px) return options.paper_weight;
  // The outline of a shape some 200 work px across.
  constexpr double paying_ink_px = 600;
  // A right corner is cut when its two sides pull more than its diagonal costs: at a weight of sqrt(2) times that of ink.
  double const least = 1.6 * options.ink_weight;
  return std::clamp(options.ink_weight * paying_ink_px / *options.gap_px,
                    std::min(least, options.paper_weight), options.paper_weight);
}

Result<CellLabels> label_cells(Cells const& cells, CutOptions const& options) {
  CellTopology const topology(cells);
  auto capacities = weigh(cells, options);
  for (int i = 0; i < std::ssize(options.inside); ++i) {
    int const cell = find_cell(cells, options.inside[i]);
    if (cell < 0) {
      return Error{ErrorCode::BadOption,
                   "an inside mark lies beyond the strokes: put it between them", i};
    }
    for (int const marked : free_disc(cells, options.inside[i])) {
      capacities.terminals[marked].source = kForced;
    }
  }
  auto labels = minimum_cut(topology, capacities.arcs, capacities.terminals).in_source;
  if (options.outside.empty()) return labels;
  for (auto const mark : options.outside) {
    for (int const marked : marked_bay(cells, labels, mark))
      capacities.terminals[marked] = {0, kForced};
  }
  return minimum_cut(topology, capacities.arcs, capacities.terminals).in_source;
}

}  // namespace inkflate
