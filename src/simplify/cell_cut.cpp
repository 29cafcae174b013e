// SPDX-License-Identifier: Apache-2.0
#include "simplify/cell_cut.h"

#include <cmath>
#include <string>

#include "solvers/min_cut.h"

namespace inkflate {
namespace {

// More than any cut of a drawing can cost in one place: 17 * the frame's diagonal on the lattice is below 2^19. Two of them on
// an arc and its reverse stay below 2^31.
constexpr std::int32_t kForced = 1 << 28;

/// Cells as nodes; a triangle's half-edges are its arcs.
class CellTopology {
 public:
  static constexpr int kDegree = 3;
  explicit CellTopology(Triangulation const& mesh) : mesh_(&mesh) {}
  int node_count() const { return mesh_->triangle_count(); }
  int reverse(int arc) const { return mesh_->twins[arc]; }

 private:
  Triangulation const* mesh_;
};

/// The capacities of the cell graph.
struct CellGraph {
  std::vector<std::int32_t> arcs;
  std::vector<TerminalCapacity> terminals;
};

CellGraph weigh(StrokeSamples const& samples, Triangulation const& mesh,
                CutOptions const& options) {
  CellGraph graph;
  graph.arcs.resize(mesh.corners.size());
  graph.terminals.resize(static_cast<std::size_t>(mesh.triangle_count()));
  auto const longest_ink = longest_ink_edge_squared(samples);
  double const longest_gap = options.gap_px ? *options.gap_px * Frame::kLatticePerPx
                                            : std::numeric_limits<double>::infinity();
  double const paper_weight = options.gap_px ? options.ink_weight : options.paper_weight;
  for (int e = 0; e < std::ssize(mesh.corners); ++e) {
    auto const squared = squared_length(samples, mesh, e);
    double const length = std::sqrt(static_cast<double>(squared));
    auto& terminal = graph.terminals[e / 3];
    if (squared <= longest_ink) {
      terminal.source += static_cast<std::int32_t>(options.ink_weight * length + 0.5);
      continue;
    }
    auto const cost =
        length > longest_gap ? kForced : static_cast<std::int32_t>(paper_weight * length + 0.5);
    if (mesh.twins[e] < 0) {
      terminal.sink += cost;  // beyond the hull all is outside
    } else {
      graph.arcs[e] = cost;
    }
  }
  return graph;
}

}  // namespace

int find_cell(StrokeSamples const& samples, Triangulation const& mesh, Vec2 p) {
  auto const corner = [&](int e) { return samples.lattice[mesh.corners[e]]; };
  auto const lattice = Frame::lattice_point(p);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    auto const a = corner(3 * t);
    auto const b = corner(3 * t + 1);
    auto const c = corner(3 * t + 2);
    if (orientation(a, b, lattice) >= 0 && orientation(b, c, lattice) >= 0 &&
        orientation(c, a, lattice) >= 0) {
      return t;
    }
  }
  return -1;
}

std::int64_t longest_ink_edge_squared(StrokeSamples const& samples) {
  // Rounding to the lattice moves each end by at most half a unit along each axis.
  double const longest = samples.spacing_px * Frame::kLatticePerPx + 1.5;
  return static_cast<std::int64_t>(longest * longest);
}

std::int64_t squared_length(StrokeSamples const& samples, Triangulation const& mesh,
                            int half_edge) {
  auto const a = samples.lattice[mesh.corners[half_edge]];
  auto const b = samples.lattice[mesh.corners[next_half_edge(half_edge)]];
  std::int64_t const dx = b.x - a.x;
  std::int64_t const dy = b.y - a.y;
  return dx * dx + dy * dy;
}

Result<std::vector<std::uint8_t>> label_cells(StrokeSamples const& samples,
                                              Triangulation const& mesh,
                                              CutOptions const& options) {
  auto graph = weigh(samples, mesh, options);
  for (auto const mark : options.outside) {
    int const cell = find_cell(samples, mesh, mark);
    if (cell >= 0) graph.terminals[cell].sink = kForced;
  }
  for (int i = 0; i < std::ssize(options.inside); ++i) {
    int const cell = find_cell(samples, mesh, options.inside[i]);
    if (cell < 0) {
      return Error{ErrorCode::BadOption,
                   "an inside mark lies beyond the strokes: put it between them", i};
    }
    graph.terminals[cell].source = kForced;
  }
  return minimum_cut(CellTopology(mesh), graph.arcs, graph.terminals, CutTies::SmallestSource)
      .in_source;
}

}  // namespace inkflate
