// SPDX-License-Identifier: Apache-2.0
#include "simplify/grid_cut.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "solvers/grid_topology.h"
#include "solvers/min_cut.h"

namespace inkflate {
namespace {

/// Both arcs of a pair of neighbours.
void join(std::vector<std::int32_t>& capacities, int arc, int reverse, std::int32_t weight) {
  capacities[arc] = weight;
  capacities[reverse] = weight;
}

std::vector<std::int32_t> neighbour_weights(Mask const& ink, GridWeights const& weights) {
  using enum GridTopology::Direction;
  std::vector<std::int32_t> capacities(ink.values.size() * GridTopology::kDegree, 0);
  auto const weight = [&](int a, int b) {
    return (ink.values[a] | ink.values[b]) != 0 ? weights.ink : weights.paper;
  };
  for (int y = 0; y < ink.height; ++y) {
    for (int x = 0; x < ink.width; ++x) {
      int const node = y * ink.width + x;
      int const below = node + ink.width;
      if (x + 1 < ink.width) {
        join(capacities, GridTopology::arc(node, Right), GridTopology::arc(node + 1, Left),
             weight(node, node + 1));
      }
      if (y + 1 < ink.height) {
        join(capacities, GridTopology::arc(node, Down), GridTopology::arc(below, Up),
             weight(node, below));
      }
    }
  }
  return capacities;
}

double squared_distance_to_ink(Mask const& ink, Vec2 mark) {
  double nearest = squared_norm({static_cast<double>(ink.width), static_cast<double>(ink.height)});
  for (int y = 0; y < ink.height; ++y) {
    for (int x = 0; x < ink.width; ++x) {
      if (ink.at(x, y) == 0) continue;
      nearest = std::min(nearest, squared_norm(Vec2{x + 0.5, y + 0.5} - mark));
    }
  }
  return nearest;
}

/// Links the pixels of the disc round a mark, at least the one that holds it, with a terminal.
void link_disc(Mask const& ink, Vec2 mark, TerminalCapacity link,
               std::vector<TerminalCapacity>& terminals) {
  if (!(mark.x >= 0 && mark.y >= 0 && mark.x < ink.width && mark.y < ink.height)) return;
  auto const set = [&](int x, int y) {
    bool const is_rim = x == 0 || y == 0 || x + 1 == ink.width || y + 1 == ink.height;
    if (!is_rim) terminals[y * ink.width + x] = link;
  };
  set(static_cast<int>(mark.x), static_cast<int>(mark.y));
  double const reach = squared_distance_to_ink(ink, mark);
  for (int y = 0; y < ink.height; ++y) {
    for (int x = 0; x < ink.width; ++x) {
      if (squared_norm(Vec2{x + 0.5, y + 0.5} - mark) < reach) set(x, y);
    }
  }
}

std::vector<TerminalCapacity> terminal_weights(Mask const& ink, std::int32_t weight,
                                               std::span<Vec2 const> outside,
                                               std::span<Vec2 const> inside) {
  TerminalCapacity const source = {weight, 0};
  TerminalCapacity const sink = {0, weight};
  std::vector<TerminalCapacity> terminals(ink.values.size());
  for (std::size_t i = 0; i < ink.values.size(); ++i) {
    if (ink.values[i] != 0) terminals[i] = source;
  }
  for (auto const mark : inside) link_disc(ink, mark, source, terminals);
  for (auto const mark : outside) link_disc(ink, mark, sink, terminals);
  for (int y = 0; y < ink.height; ++y) {
    bool const is_end = y == 0 || y + 1 == ink.height;
    for (int x = 0; x < ink.width; x += is_end ? 1 : std::max(1, ink.width - 1)) {
      terminals[y * ink.width + x] = sink;
    }
  }
  return terminals;
}

}  // namespace

Mask cut_grid(Mask const& ink, GridWeights const& weights, std::span<Vec2 const> outside,
              std::span<Vec2 const> inside) {
  GridTopology const topology(ink.width, ink.height);
  MinCut<GridTopology> solver;
  solver.solve(topology, neighbour_weights(ink, weights),
               terminal_weights(ink, weights.terminal, outside, inside));
  Mask shape(ink.width, ink.height);
  for (int node = 0; node < topology.node_count(); ++node) {
    if (solver.in_source(node, CutTies::SmallestSource)) shape.values[node] = 255;
  }
  return shape;
}

}  // namespace inkflate
