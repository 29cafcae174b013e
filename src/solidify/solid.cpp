// SPDX-License-Identifier: Apache-2.0
#include "solidify/solid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace inkflate {
namespace {

// Two families may disagree by rounding about a node that lies on the surface.
constexpr double kRounding = 1e-6;

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
          solid.sides[lattice.index({i, j, k})] = Side::Inside;
      }
    }
  }
}

void mark_ball(Solid& solid, int b) {
  auto const& [centre, radius] = solid.balls[b];
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
        solid.sides[index] = Side::Inside;
      }
    }
  }
}

/// Nodes of one row without a node inside between them.
struct Run {
  int first = 0;  // columns
  int last = 0;
};

class OutsideRuns {
 public:
  explicit OutsideRuns(Solid& solid) : solid_(solid), lattice_(solid.lattice) {
    int const row_count = lattice_.rows * lattice_.planes;
    for (int row = 0; row < row_count; ++row) {
      begin_.push_back(static_cast<int>(runs_.size()));
      add_row(row);
    }
    begin_.push_back(static_cast<int>(runs_.size()));
    parents_.resize(runs_.size());
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  /// Joins runs that have neighbouring nodes.
  void join() {
    for (int k = 0; k < lattice_.planes; ++k) {
      int const shift = k & 1;
      for (int r = 0; r < lattice_.rows; ++r) {
        int const row = k * lattice_.rows + r;
        if (r + 1 < lattice_.rows) join_rows(row, row + 1, 0, 0);
        if (k + 2 < lattice_.planes) join_rows(row, row + 2 * lattice_.rows, 0, 0);
        if (k + 1 == lattice_.planes) continue;
        // A diagonal step from an even plane leads to the same column or one less, from an odd one to the same or one more.
        for (int const other : {r + shift - 1, r + shift}) {
          if (other < 0 || other >= lattice_.rows) continue;
          join_rows(row, (k + 1) * lattice_.rows + other, shift - 1, shift);
        }
      }
    }
  }

  /// What is not joined to the first run becomes inside: the lattice's rim is all outside.
  void fill_voids() {
    int const outside = root(0);
    for (int row = 0; row + 1 < std::ssize(begin_); ++row) {
      for (int r = begin_[row]; r < begin_[row + 1]; ++r) {
        if (root(r) == outside) continue;
        auto const nodes = solid_.sides.begin() + std::ptrdiff_t{row} * lattice_.columns;
        std::fill(nodes + runs_[r].first, nodes + runs_[r].last + 1, Side::Inside);
      }
    }
  }

 private:
  void add_row(int row) {
    auto const* const nodes = solid_.sides.data() + std::ptrdiff_t{row} * lattice_.columns;
    for (int c = 0; c < lattice_.columns; ++c) {
      if (nodes[c] == Side::Inside) continue;
      int const first = c;
      while (c + 1 < lattice_.columns && nodes[c + 1] != Side::Inside) ++c;
      runs_.push_back({first, c});
    }
  }

  void join_rows(int row, int other_row, int least_shift, int most_shift) {
    int b = begin_[other_row];
    for (int a = begin_[row]; a < begin_[row + 1]; ++a) {
      int const first = runs_[a].first + least_shift;
      int const last = runs_[a].last + most_shift;
      while (b < begin_[other_row + 1] && runs_[b].last < first) ++b;
      for (int c = b; c < begin_[other_row + 1] && runs_[c].first <= last; ++c)
        parents_[root(c)] = root(a);
    }
  }

  int root(int run) {
    while (parents_[run] != run) run = parents_[run] = parents_[parents_[run]];
    return run;
  }

  Solid& solid_;
  Lattice const& lattice_;
  std::vector<Run> runs_;
  std::vector<int> begin_;
  std::vector<int> parents_;
};

/// The part of a step that lies in a ball, as shares of the step; empty (first > last) if none.
std::array<double, 2> share_in_ball(Ball const& ball, Vec3 from, Vec3 step) {
  double const length = squared_norm(step);
  double const middle = dot(ball.centre - from, step) / length;
  double const off = squared_norm(from + step * middle - ball.centre);
  double const left = ball.radius * ball.radius - off;
  if (left < 0) return {1, 0};
  double const half = std::sqrt(left / length);
  return {middle - half, middle + half};
}

}  // namespace

Reach Solid::reach(LatticeNode from, int direction) const {
  auto const& family = families[family_of(direction)];
  auto const crossings = family.crossings(family.line(from));
  double const start = family.position(from);
  double const size = direction < kLongDirections ? 2 : 1;
  double const scale = is_forward(direction) ? 1 / size : -1 / size;
  LatticeNode const to = from + kSteps[direction];
  std::array<int, 2> touching = {-1, -1};
  if (!balls.empty())
    touching = {ball_of_node[lattice.index(from)], ball_of_node[lattice.index(to)]};
  double reached = 0;
  bool is_of_ball = false;
  for (double before = -1; reached > before && reached < 1;) {
    before = reached;
    auto const extend = [&](double a, double b, bool is_by_ball) {
      if (std::min(a, b) > reached + kRounding || std::max(a, b) <= reached) return;
      reached = std::max(a, b);
      is_of_ball = is_by_ball;
    };
    for (std::size_t c = 0; c + 1 < crossings.size(); c += 2)
      extend((crossings[c].at - start) * scale, (crossings[c + 1].at - start) * scale, false);
    for (int const b : touching) {
      if (b < 0) continue;
      auto const [first, last] =
          share_in_ball(balls[b], place_of(from), place_of(kSteps[direction]));
      if (first <= last && last > 0) extend(first, last, true);
    }
  }
  double const to_base = to.k < base ? (from.k - base) / (from.k - to.k) : 1;
  if (reached >= to_base) return {to_base, false};
  return {std::max(reached, 0.0), is_of_ball};
}

void label_nodes(Solid& solid) {
  auto const count = static_cast<std::size_t>(solid.lattice.node_count());
  solid.sides.assign(count, Side::Outside);
  mark_spans(solid);
  if (!solid.balls.empty()) solid.ball_of_node.assign(count, -1);
  for (int b = 0; b < std::ssize(solid.balls); ++b) mark_ball(solid, b);
  OutsideRuns runs(solid);
  runs.join();
  runs.fill_voids();
}

}  // namespace inkflate
