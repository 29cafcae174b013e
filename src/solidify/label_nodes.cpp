// SPDX-License-Identifier: Apache-2.0
#include "solidify/label_nodes.h"

#include <algorithm>
#include <cmath>

#include "solidify/node_stretches.h"

namespace inkflate {
namespace {

// A piece of fewer nodes than this, and than so many balls hold, may be a crumb.
constexpr double kCrumbNodes = 8;
constexpr double kCrumbBalls = 4;

/// How deep a place lies in a ball.
double depth(Ball const& ball, Vec3 place) { return ball.radius - distance(ball.centre, place); }

/// The first number >= x that is even or odd as wanted.
int round_up_to_parity(double x, int parity) {
  int const whole = static_cast<int>(std::ceil(x));
  return whole + ((whole ^ parity) & 1);
}

void mark_spans(Solid& solid) {
  auto const& rows = solid.families[0];
  auto const& lattice = solid.lattice;
  for (int k = 0; k < lattice.planes; ++k) {
    for (int j = k & 1; j < lattice.size_j(); j += 2) {
      auto const crossings = rows.crossings(rows.line({k & 1, j, k}));
      for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) {
        for (int i = round_up_to_parity(crossings[c].at, k & 1); i <= crossings[c + 1].at; i += 2)
          solid.sides[lattice.index({i, j, k})] = NodeSide::Inside;
      }
    }
  }
}

void mark_ball(Solid& solid, int b) {
  auto const& [centre, radius, triangle] = solid.balls[b];
  double const lowest = std::max(centre.z - radius, solid.base);
  for (int k = static_cast<int>(std::ceil(lowest)); k <= centre.z + radius; ++k) {
    for (int j = round_up_to_parity(centre.y - radius, k & 1); j <= centre.y + radius; j += 2) {
      double const left =
          radius * radius - (k - centre.z) * (k - centre.z) - (j - centre.y) * (j - centre.y);
      if (left < 0) continue;
      double const half = std::sqrt(left);
      for (int i = round_up_to_parity(centre.x - half, k & 1); i <= centre.x + half; i += 2) {
        LatticeNode const node{i, j, k};
        int const index = solid.lattice.index(node);
        int const other = solid.ball_of_node[index];
        if (other >= 0 &&
            depth(solid.balls[other], place_of(node)) >= depth(solid.balls[b], place_of(node)))
          continue;
        solid.ball_of_node[index] = b;
        solid.sides[index] = NodeSide::Inside;
      }
    }
  }
}

void fill_voids(Solid& solid) {
  // The lattice's rim is all outside, its first node with it.
  NodeStretches const outside(solid.lattice, solid.sides, NodeSide::Outside);
  for (int r = 0; r < std::ssize(outside.stretches()); ++r) {
    if (outside.piece(r) == 0) continue;
    auto const& stretch = outside.stretches()[r];
    auto const row = solid.sides.begin() + std::ptrdiff_t{stretch.row} * solid.lattice.columns;
    std::fill(row + stretch.first, row + stretch.last + 1, NodeSide::Inside);
  }
}

/// Calls with each shell that some of the stretch's nodes lie in.
template <typename OnShell>
void for_shells(Solid const& solid, std::span<int const> shell_of_triangle,
                NodeStretch const& stretch, OnShell const& on_shell) {
  int const first = stretch.row * solid.lattice.columns + stretch.first;
  for (int n = first; n <= first + stretch.last - stretch.first && !solid.balls.empty(); ++n) {
    if (solid.ball_of_node[n] >= 0)
      on_shell(shell_of_triangle[solid.balls[solid.ball_of_node[n]].triangle]);
  }
  auto const start = solid.lattice.node(first);
  auto const crossings = solid.families[0].crossings(solid.families[0].line(start));
  for (auto const& crossing : crossings) {
    bool const is_near = crossing.at >= start.i - 2 &&
                         crossing.at <= start.i + 2 * (stretch.last - stretch.first) + 2;
    if (is_near && crossing.triangle >= 0) on_shell(shell_of_triangle[crossing.triangle]);
  }
}

/// Takes away small pieces that belong to shells of which a larger piece is there.
void drop_crumbs(Solid& solid, std::span<int const> shell_of_triangle) {
  NodeStretches const inside(solid.lattice, solid.sides, NodeSide::Inside);
  if (inside.piece_count() < 2) return;
  auto const& stretches = inside.stretches();
  std::vector<double> sizes(static_cast<std::size_t>(inside.piece_count()), 0);
  for (int r = 0; r < std::ssize(stretches); ++r)
    sizes[inside.piece(r)] += stretches[r].last - stretches[r].first + 1;
  std::vector<int> main_piece(shell_of_triangle.size(), -1);  // per shell
  auto const for_all = [&](auto const& on_shell) {
    for (int r = 0; r < std::ssize(stretches); ++r)
      for_shells(solid, shell_of_triangle, stretches[r],
                 [&](int shell) { on_shell(shell, inside.piece(r)); });
  };
  for_all([&](int shell, int piece) {
    int& main = main_piece[shell];
    if (main < 0 || sizes[piece] > sizes[main]) main = piece;
  });
  std::vector<bool> is_kept(sizes.size(), false);
  for_all(
      [&](int shell, int piece) { is_kept[piece] = is_kept[piece] || main_piece[shell] == piece; });
  double largest = 0;
  for (auto const& ball : solid.balls) largest = std::max(largest, ball.radius);
  // Each node stands for four cubic units; so a ball holds about as many nodes as its radius has cubic units.
  double const most = kCrumbNodes + kCrumbBalls * largest * largest * largest;
  for (int r = 0; r < std::ssize(stretches); ++r) {
    if (is_kept[inside.piece(r)] || sizes[inside.piece(r)] > most) continue;
    auto const row = solid.sides.begin() + std::ptrdiff_t{stretches[r].row} * solid.lattice.columns;
    std::fill(row + stretches[r].first, row + stretches[r].last + 1, NodeSide::Outside);
  }
}

}  // namespace

void label_nodes(Solid& solid, std::span<int const> shell_of_triangle) {
  auto const count = static_cast<std::size_t>(solid.lattice.node_count());
  solid.sides.assign(count, NodeSide::Outside);
  mark_spans(solid);
  if (!solid.balls.empty()) solid.ball_of_node.assign(count, -1);
  for (int b = 0; b < std::ssize(solid.balls); ++b) mark_ball(solid, b);
  fill_voids(solid);
  drop_crumbs(solid, shell_of_triangle);
}

}  // namespace inkflate
