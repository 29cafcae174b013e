// SPDX-License-Identifier: Apache-2.0
#include "solvers/min_cut.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "solvers/grid_topology.h"
#include "support/reference_max_flow.h"

namespace inkflate {
namespace {

/// Every node is joined to every other: arc i of node n leads to the i-th of the others.
template <int node_count_>
struct Complete {
  static constexpr int kDegree = node_count_ - 1;
  static int node_count() { return node_count_; }
  static int reverse(int arc) {
    int const from = arc / kDegree;
    int const to = arc % kDegree + (arc % kDegree >= from ? 1 : 0);
    return to * kDegree + (from > to ? from - 1 : from);
  }
};

/// Three arcs per node, as in the cells of a triangulation; the twins are stored.
struct Cells {
  static constexpr int kDegree = 3;
  std::vector<int> twins;
  int node_count() const { return static_cast<int>(std::ssize(twins)) / kDegree; }
  int reverse(int arc) const { return twins[arc]; }
};

struct Problem {
  std::vector<std::int32_t> capacities;
  std::vector<TerminalCapacity> terminals;
};

enum class Weights { Small, WithZeros, Large };

std::int32_t random_weight(Rng& rng, Weights weights) {
  switch (weights) {
    case Weights::Small:
      return 1 + rng.below(4);
    case Weights::WithZeros:
      return std::max(0, rng.below(10) - 5);
    case Weights::Large:
      return rng.below(1 << 30);
  }
  return 0;
}

template <CutTopology Topology>
Problem random_problem(Topology const& topology, Rng& rng) {
  auto const weights = static_cast<Weights>(rng.below(3));
  bool const few_terminals = rng.below(2) == 0;
  Problem problem;
  for (int arc = 0; arc < topology.node_count() * Topology::kDegree; ++arc) {
    problem.capacities.push_back(random_weight(rng, weights));
  }
  for (int node = 0; node < topology.node_count(); ++node) {
    TerminalCapacity terminal;
    if (!few_terminals || rng.below(5) == 0)
      terminal.source = 2 * (random_weight(rng, weights) / 2);
    if (!few_terminals || rng.below(5) == 0) terminal.sink = random_weight(rng, weights);
    problem.terminals.push_back(terminal);
  }
  return problem;
}

Problem random_grid_problem(int width, int height, Rng& rng) {
  GridTopology const topology(width, height);
  auto problem = random_problem(topology, rng);
  for (int node = 0; node < topology.node_count(); ++node) {
    auto const clear = [&](GridTopology::Direction direction) {
      problem.capacities[GridTopology::arc(node, direction)] = 0;
    };
    if (node % width == 0) clear(GridTopology::Left);
    if (node % width == width - 1) clear(GridTopology::Right);
    if (node / width == 0) clear(GridTopology::Up);
    if (node / width == height - 1) clear(GridTopology::Down);
  }
  return problem;
}

/// What a labelling costs; in_source(node) tells the side.
template <CutTopology Topology, class InSource>
std::int64_t cost_of(Topology const& topology, Problem const& problem, InSource in_source) {
  std::int64_t cost = 0;
  for (int node = 0; node < topology.node_count(); ++node) {
    auto const& terminal = problem.terminals[node];
    cost += in_source(node) ? terminal.sink : terminal.source;
    if (!in_source(node)) continue;
    for (int i = 0; i < Topology::kDegree; ++i) {
      int const arc = node * Topology::kDegree + i;
      int const reverse = topology.reverse(arc);
      if (reverse >= 0 && !in_source(reverse / Topology::kDegree)) cost += problem.capacities[arc];
    }
  }
  return cost;
}

/// Compares value and both extreme source sides with all labellings.
template <CutTopology Topology>
void expect_as_brute_force(Topology const& topology, Problem const& problem) {
  std::int64_t least = INT64_MAX;
  unsigned smallest = 0;
  unsigned largest = 0;
  for (unsigned labels = 0; labels < 1U << static_cast<unsigned>(topology.node_count()); ++labels) {
    auto const cost = cost_of(topology, problem, [&](int node) {
      return (labels >> static_cast<unsigned>(node) & 1U) != 0;
    });
    if (cost < least) {
      least = cost;
      smallest = largest = labels;
    } else if (cost == least) {
      smallest &= labels;
      largest |= labels;
    }
  }
  MinCut<Topology> solver;
  EXPECT_EQ(solver.solve(topology, problem.capacities, problem.terminals), least);
  for (int node = 0; node < topology.node_count(); ++node) {
    auto const bit = static_cast<unsigned>(node);
    EXPECT_EQ(solver.in_source(node, CutTies::SmallestSource), (smallest >> bit & 1U) != 0);
    EXPECT_EQ(solver.in_source(node, CutTies::LargestSource), (largest >> bit & 1U) != 0);
  }
}

template <int node_count>
void expect_complete_as_brute_force(int cases, Rng& rng) {
  Complete<node_count> const topology;
  for (int i = 0; i < cases; ++i) {
    expect_as_brute_force(topology, random_problem(topology, rng));
  }
}

template <CutTopology Topology>
void expect_as_reference(Topology const& topology, Problem const& problem) {
  int const count = topology.node_count();
  ReferenceMaxFlow reference(count + 2);
  for (int node = 0; node < count; ++node) {
    reference.add_arc(count, node, problem.terminals[node].source);
    reference.add_arc(node, count + 1, problem.terminals[node].sink);
    for (int arc = node * Topology::kDegree; arc < (node + 1) * Topology::kDegree; ++arc) {
      int const reverse = topology.reverse(arc);
      if (reverse >= 0)
        reference.add_arc(node, reverse / Topology::kDegree, problem.capacities[arc]);
    }
  }
  auto const flow = reference.solve(count, count + 1);
  for (auto const ties : {CutTies::SmallestSource, CutTies::LargestSource}) {
    auto const cut = minimum_cut(topology, problem.capacities, problem.terminals, ties);
    EXPECT_EQ(cut.value, flow);
    EXPECT_EQ(cost_of(topology, problem, [&](int node) { return cut.in_source[node] != 0; }), flow);
  }
}

/// A strip of triangles with random gluings: few neighbours, long ways, some arcs that lead nowhere.
Cells random_cells(int count, Rng& rng) {
  Cells cells{std::vector<int>(static_cast<std::size_t>(count) * 3U, -1)};
  for (int n = 0; n + 1 < count; ++n) {
    int const arc = n * Cells::kDegree;
    cells.twins[arc] = arc + 4;
    cells.twins[arc + 4] = arc;
  }
  for (int n = 0; n < count; ++n) {
    int const other = n + rng.below(std::min(30, count - n));
    if (other == n || cells.twins[n * 3 + 2] >= 0 || cells.twins[other * 3 + 2] >= 0) continue;
    cells.twins[n * 3 + 2] = other * 3 + 2;
    cells.twins[other * 3 + 2] = n * 3 + 2;
  }
  return cells;
}

TEST(MinCut, EqualsBruteForceOnCompleteGraphs) {
  Rng rng(1);
  expect_complete_as_brute_force<2>(200, rng);
  expect_complete_as_brute_force<3>(500, rng);
  expect_complete_as_brute_force<5>(500, rng);
  expect_complete_as_brute_force<8>(150, rng);
  expect_complete_as_brute_force<11>(10, rng);
}

TEST(MinCut, EqualsBruteForceOnSixteenNodes) {
  Rng rng(2);
  expect_complete_as_brute_force<16>(1, rng);
  for (int i = 0; i < 3; ++i) {
    expect_as_brute_force(GridTopology(4, 4), random_grid_problem(4, 4, rng));
  }
}

TEST(MinCut, EqualsBruteForceOnSmallGrids) {
  Rng rng(3);
  for (int i = 0; i < 200; ++i) {
    int const width = 1 + rng.below(4);
    int const height = 1 + rng.below(12 / width);
    expect_as_brute_force(GridTopology(width, height), random_grid_problem(width, height, rng));
  }
}

TEST(MinCut, EqualsShortestAugmentingPathsOnGrids) {
  Rng rng(4);
  for (int i = 0; i < 30; ++i) {
    expect_as_reference(GridTopology(20, 20), random_grid_problem(20, 20, rng));
  }
}

TEST(MinCut, EqualsShortestAugmentingPathsOnCells) {
  Rng rng(5);
  for (int i = 0; i < 200; ++i) {
    auto const cells = random_cells(2 + rng.below(150), rng);
    expect_as_reference(cells, random_problem(cells, rng));
  }
}

TEST(MinCut, CapacitiesOfArcsThatLeadNowhereDoNotCount) {
  Cells const lonely{{-1, -1, -1}};
  auto const cut = minimum_cut(lonely, std::vector<std::int32_t>{7, 8, 9},
                               std::vector<TerminalCapacity>{{5, 2}});
  EXPECT_EQ(cut.value, 2);
  EXPECT_EQ(cut.in_source, std::vector<std::uint8_t>{1});
}

TEST(MinCut, UndecidedNodesGoWhereTiesSay) {
  // Source - 0 - 1 - 2 - sink, all links alike: every one of them is a minimum cut.
  GridTopology const row(3, 1);
  std::vector<std::int32_t> capacities(12, 0);
  for (int node = 0; node < 2; ++node) {
    capacities[GridTopology::arc(node, GridTopology::Right)] = 4;
    capacities[GridTopology::arc(node + 1, GridTopology::Left)] = 4;
  }
  std::vector<TerminalCapacity> const terminals = {{4, 0}, {0, 0}, {0, 4}};
  EXPECT_EQ(minimum_cut(row, capacities, terminals, CutTies::SmallestSource).in_source,
            (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_EQ(minimum_cut(row, capacities, terminals, CutTies::LargestSource).in_source,
            (std::vector<std::uint8_t>{1, 1, 1}));
}

TEST(MinCut, NothingWithoutNodes) { EXPECT_EQ(minimum_cut(Cells{}, {}, {}).value, 0); }

TEST(MinCut, TheSameSolverSolvesAgain) {
  Rng rng(6);
  MinCut<GridTopology> solver;
  for (int i = 0; i < 100; ++i) {
    int const width = 1 + rng.below(9);
    int const height = 1 + rng.below(9);
    GridTopology const topology(width, height);
    auto const problem = random_grid_problem(width, height, rng);
    EXPECT_EQ(solver.solve(topology, problem.capacities, problem.terminals),
              minimum_cut(topology, problem.capacities, problem.terminals).value);
  }
}

}  // namespace
}  // namespace inkflate
