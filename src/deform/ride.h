// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "deform/motion_field.h"
#include "deform/shape_mesh.h"
#include "geometry/point_grid.h"
#include "geometry/rect.h"
#include "mesh/triangle_grid.h"

namespace inkflate {

/// Places of a shape and how they ride on the vertices of its mesh: exact where a mesh moves by an affine map, to the last bit where it
/// has not moved; between vertices smooth, so that straight lines become arcs and not chains.
///
/// source  docs/algorithms/ride.md
class RidePlaces {
 public:
  /// in      shape: has to outlive the places
  explicit RidePlaces(ShapeMesh const& shape);

  /// A place of the outline or line from which line `line` of the mesh was made, by its parameter there. Returns the place's index.
  int add_on_line(int line, double parameter, Vec2 place);
  /// A place anywhere: rides in its triangle or, outside of all, after the lines that are near. Returns its index.
  /// cost    O(1) inside and near a line; far away O(points of the mesh's lines) once, and some tens of vertices to ride on
  int add(Vec2 place);
  /// The points of a line, in order. Where the shape lies over itself they stay in the sheet in which the line is: where it is in one alone it
  /// begins; what is nowhere so rides in the smallest. Returns their indices.
  std::vector<int> add_line(std::span<Vec2 const> line);

  Vec2 rest(int index) const { return places_[index]; }
  /// How far the place has moved.
  Vec2 shift(std::span<VertexMotion const> motions, int index) const;
  /// How what is around it has changed.
  Linear2 change(std::span<VertexMotion const> motions, int index) const;

 private:
  /// What a place takes from one vertex: of its shift, of its change at an arm, and of its change as such.
  struct Term {
    int vertex = 0;
    double share = 0;
    Vec2 arm;
    double frame = 0;
  };

  /// A vertex of a line and what stands beside it there.
  struct LinePoint {
    int vertex = 0;
    int next = 0;  // vertex; itself where the line ends
    Vec2 place;
    double length_px = 0;  // of the line that is its own: half of both edges
    int rank = 0;          // along the line, from 0
    int left = 0;          // how many points the line has from this one on
  };

  void add_line_points(BendLine const& line);
  int finish(Vec2 place);
  int add_in(Vec2 place, std::optional<MeshPlace> const& inside);
  void add_triangle(MeshPlace const& in);
  void add_edge(int from, int to, Vec2 place, double weight);
  /// visit(LinePoint) for at least every point of the lines within radius.
  template <typename Visit>
  void visit_near(Vec2 place, double radius, Visit visit) const;
  double nearest_point_px(Vec2 place) const;
  void add_near(Vec2 place);
  void add_around(Vec2 place, double nearest_px, double weight);
  void add_all_within(double reach, int stride, Vec2 place, double nearest_px, double weight);

  ShapeMesh const* shape_;
  TriangleGrid triangles_;
  std::vector<LinePoint> line_points_;
  double longest_edge_px_ = 0;  // of the lines
  Rect box_;                    // of their points
  std::optional<PointGrid> grid_;
  std::vector<Vec2> places_;
  std::vector<int> starts_ = {0};  // per place, into terms_
  std::vector<Term> terms_;
};

}  // namespace inkflate
