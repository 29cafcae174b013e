// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "mesh/tri_mesh.h"
#include "solidify/lattice.h"

namespace inkflate {

/// Quanta per lattice unit. Points are rounded to odd numbers of quanta, nodes lie at even ones: no point lies on an axis line.
constexpr std::int64_t kQuanta = 4096;

/// The model in lattice units, ready to be scanned.
struct LatticeMesh {
  std::vector<std::array<std::int64_t, 3>> points;  // quanta
  std::vector<Triangle> triangles;

  Vec3 place(int p) const {
    constexpr double unit = 1.0 / static_cast<double>(kQuanta);
    return {static_cast<double>(points[p][0]) * unit, static_cast<double>(points[p][1]) * unit,
            static_cast<double>(points[p][2]) * unit};
  }
  /// Points out; length 1.
  Vec3 normal(int t) const {
    auto const& corners = triangles[t];
    Vec3 const a = place(corners[0]);
    return normalized(cross(place(corners[1]) - a, place(corners[2]) - a));
  }
};

/// A point across a family of lines: quanta, or numbers of lines.
using LinePlanePoint = std::array<std::int64_t, 2>;

/// Where a line goes into the union of all shells or leaves it.
struct LineCrossing {
  double at = 0;     // along the line, see LineSpans::position
  int triangle = 0;  // that is crossed there
};

/// All lines of one direction through lattice nodes, each with the stretches of it that lie inside the union.
class LineSpans {
 public:
  LineSpans(Lattice const& lattice, int family);

  int line(LatticeNode a) const {
    return line_at(dot_of(across_u_, a) - first_u_, dot_of(across_v_, a) - first_v_);
  }
  /// A node's coordinate along its line: its i, j or k on axis lines, its k on diagonals.
  int position(LatticeNode a) const { return along_ == 0 ? a.i : along_ == 1 ? a.j : a.k; }
  /// The point at a position of a line.
  Vec3 place(int line, double at) const;
  int line_count() const { return columns_ * rows_; }
  int direction() const { return kFamilyDirections[family_]; }
  /// The crossings of a line, rising: in, out, in, out ...
  std::span<LineCrossing const> crossings(int line) const {
    return {crossings_.data() + begin_[line],
            static_cast<std::size_t>(begin_[line + 1] - begin_[line])};
  }
  std::size_t crossing_count() const { return crossings_.size(); }

  /// Scans the mesh. What lies on a line or in a node is decided as if the line were shifted by an infinitely small step, so every line
  /// crosses a closed mesh in and out equally often. TooLarge when there are more crossings than memory is meant for.
  Result<bool> scan(LatticeMesh const& mesh);
  /// Takes away what lies below a plane of constant k. Crossings made so name no triangle (-1).
  void cut_below(double k);

 private:
  struct Hit {
    double at;
    int line;
    int triangle_and_turn;  // 2 t + 1 where the line goes in
  };

  static int dot_of(LatticeNode a, LatticeNode b) { return a.i * b.i + a.j * b.j + a.k * b.k; }
  int line_at(int u, int v) const { return (is_axis() ? v : v >> 1) * columns_ + (u >> 1); }
  bool is_axis() const { return family_ < 3; }
  /// A triangle as the lines see it, turning left.
  struct Projection {
    std::array<LinePlanePoint, 3> corners{};
    std::array<double, 3> along{};  // quanta
    std::int64_t area = 0;          // twice
    bool is_out = false;
  };

  Projection project(LatticeMesh const& mesh, int t) const;
  /// False: too many hits or too much work.
  bool scan_triangle(Projection const& shape, int t, std::vector<Hit>& hits,
                     std::int64_t& work) const;
  void scan_row(Projection const& shape, int t, LinePlanePoint first, std::int64_t last_u,
                std::vector<Hit>& hits) const;
  /// Where the hits of each line begin.
  std::vector<int> sort_by_line(std::vector<Hit>& hits) const;
  void keep_union(std::vector<Hit>& hits);

  int family_ = 0;
  int along_ = 0;
  LatticeNode across_u_;  // lines are numbered by these two products with their nodes
  LatticeNode across_v_;
  int first_u_ = 0;
  int first_v_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> begin_;
  std::vector<LineCrossing> crossings_;
};

}  // namespace inkflate
