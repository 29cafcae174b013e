// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/vec2.h"
#include "mesh/delaunay.h"

namespace inkflate {

/// Free edges may be turned to make the mesh better; the others are lines that were asked for.
enum class EdgeKind : std::uint8_t { Free, Rim, Seam };

/// Triangles in the plane that can be changed: points come, edges turn, lines become edges. Half-edges as in mesh/delaunay.h.
///
/// Works on the points as they are. What decides about the triangles' shape is the exact side of a line, so every triangle
/// always has positive area; the in-circle test is only taken when it is sure, so Lawson's flips end.
class DynamicTriangulation {
 public:
  /// points: finite, within 1e6; they are vertices 0 .. n - 1 once they are inserted. Vertices n .. n + 3 are the corners of a
  /// box around them.
  explicit DynamicTriangulation(std::span<Vec2 const> points);

  /// All given points. The index of a point that stands where another one is, if there is one.
  std::optional<int> insert_all();

  enum class Fix { Done, Crosses, Touches };
  /// Makes the edge from vertex a to vertex b by turning the edges in its way (Sloan 1993). Crosses: another fixed edge is in the
  /// way or is the edge; Touches: a vertex is.
  Fix fix_edge(int a, int b, EdgeKind kind);

  /// Where a point is: inside of a triangle, or on the edge of it, or on a vertex.
  struct Place {
    int triangle = -1;  // -1: not found without crossing a fixed edge
    int edge = -1;
    int vertex = -1;
  };
  /// Walks from a triangle to the point, over free edges only.
  Place locate(Vec2 p, int from_triangle) const;

  /// A new vertex inside of a triangle or on a free edge, as locate says; then the edges around it are turned until they are
  /// Delaunay.
  int insert(Vec2 p, Place const& place);

  /// The half-edge from vertex a to vertex b; -1 if there is none.
  int find_edge(int a, int b) const;

  /// Turns free edges until all of them are Delaunay, as far as is allowed.
  void make_delaunay();

  /// From now on no edge between two vertices of the rim comes to be.
  void keep_rim_apart() { keeps_rim_apart_ = true; }

  /// The vertex elsewhere. All its triangles must keep positive area: see can_move.
  void move(int v, Vec2 p) { points_[v] = p; }
  bool can_move(int v, Vec2 p) const;
  /// Whether v can be put at p after edge e, free, is split there.
  bool can_split(int e, Vec2 p) const;

  /// Whether d lies inside the circle through a, b, c for sure.
  static bool is_in_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

  int triangle_count() const { return static_cast<int>(corners_.size() / 3); }
  int vertex_count() const { return static_cast<int>(points_.size()); }
  int given_count() const { return given_count_; }
  /// A triangle at a corner of the box.
  int outer_triangle() const { return leaving_[given_count_] / 3; }
  Vec2 point(int v) const { return points_[v]; }
  Vec2 start(int e) const { return points_[corners_[e]]; }
  int corner(int e) const { return corners_[e]; }
  int end_corner(int e) const { return corners_[next_half_edge(e)]; }
  int apex(int e) const { return corners_[previous_half_edge(e)]; }
  int twin(int e) const { return twins_[e]; }
  EdgeKind kind(int e) const { return kinds_[e]; }
  bool is_free(int e) const { return kinds_[e] == EdgeKind::Free; }
  bool is_rim(int v) const { return is_rim_[v] != 0; }
  bool is_fixed(int v) const { return is_fixed_[v] != 0; }

  /// Calls visit(e) for each half-edge that leaves v; v is no corner of the box.
  template <typename Visit>
  void around(int v, Visit visit) const {
    int const first = leaving_[v];
    int e = first;
    do {
      visit(e);
      e = twins_[previous_half_edge(e)];
    } while (e != first);
  }

 private:
  int new_triangles(int count);
  void set_triangle(int t, int a, int b, int c);
  void join(int e, int f, EdgeKind kind);
  void split_triangle(int t, int v);
  void split_edge(int e, int v);
  void flip(int e);
  void legalise();
  bool should_flip(int e) const;
  bool is_convex_around(int e) const;
  Place place_in(int t, Vec2 p) const;
  Place search(Vec2 p) const;
  std::optional<int> insert_given(int v);
  void mark_fixed(int e, EdgeKind kind);
  struct Ends {
    int from;
    int to;
  };

  Fix find_crossed(int a, int b, std::vector<Ends>& crossed) const;
  bool turn_away(int a, int b, std::vector<Ends> crossed);
  bool separates(int a, int b, Ends ends) const;

  std::vector<Vec2> points_;
  std::vector<int> corners_;
  std::vector<int> twins_;
  std::vector<EdgeKind> kinds_;
  std::vector<int> leaving_;  // per vertex a half-edge that leaves it
  std::vector<std::uint8_t> is_rim_;
  std::vector<std::uint8_t> is_fixed_;  // on the rim or a seam
  std::vector<int> pending_;            // edges to be looked at by legalise
  int given_count_;
  int last_ = 0;  // the triangle where a walk starts
  bool keeps_rim_apart_ = false;
};

}  // namespace inkflate
