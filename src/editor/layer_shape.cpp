// SPDX-License-Identifier: Apache-2.0
#include "editor/layer_shape.h"

#include "geometry/predicates.h"

namespace inkflate {
namespace {

// 3 px of the screen at the largest zoom: a hand does not point more exactly.
constexpr double kTolerancePx = 0.05;

struct Edge {
  Vec2 from;
  Vec2 to;
};

Rect box_of(Edge const& edge) {
  Rect box;
  box.include(edge.from);
  box.include(edge.to);
  return box;
}

/// Edges of a shape that come into a box.
std::vector<Edge> edges_in(LayerShape const& shape, Rect const& box) {
  std::vector<Edge> edges;
  for (auto const& contour : shape.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      Edge const edge = {contour[i], contour[(i + 1) % contour.size()]};
      if (touch(box_of(edge), box)) edges.push_back(edge);
    }
  }
  return edges;
}

bool do_rims_touch(LayerShape const& a, LayerShape const& b) {
  auto const edges_of_b = edges_in(b, a.box);
  for (auto const& edge : edges_in(a, b.box)) {
    auto const box = box_of(edge);
    for (auto const& other : edges_of_b) {
      if (touch(box, box_of(other)) && segments_touch(edge.from, edge.to, other.from, other.to)) {
        return true;
      }
    }
  }
  return false;
}

/// Where rims do not touch, a shape lies inside of another when any point of each of its contours does; an island in a hole
/// of the other is one of several contours, so each is asked.
bool has_contour_in(LayerShape const& inner, LayerShape const& outer) {
  for (auto const& contour : inner.contours) {
    if (!contour.empty() && contains(outer, contour.front())) return true;
  }
  return false;
}

}  // namespace

LayerShape layer_shape(Layer const& layer) {
  LayerShape shape;
  for (auto const& outline : layer.outlines) {
    shape.contours.push_back(flatten(outline, kTolerancePx));
    shape.box = united(shape.box, bounds(shape.contours.back()));
  }
  return shape;
}

Rect loose_box(Layer const& layer) {
  Rect box;
  for (auto const& outline : layer.outlines) {
    for (auto const& piece : outline.pieces) {
      for (auto const p : piece.curve.control) box.include(p);
    }
  }
  return box;
}

bool contains(LayerShape const& shape, Vec2 p) {
  return contains(shape.box, p) && contains(shape.contours, p);
}

bool is_rim_near(LayerShape const& shape, Vec2 p, double reach_px) {
  if (!contains(shape.box.grown(reach_px), p)) return false;
  for (auto const& contour : shape.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      auto const next = contour[(i + 1) % contour.size()];
      if (squared_distance_to_segment(p, contour[i], next) <= reach_px * reach_px) return true;
    }
  }
  return false;
}

bool overlap(LayerShape const& a, LayerShape const& b) {
  return touch(a.box, b.box) &&
         (do_rims_touch(a, b) || has_contour_in(a, b) || has_contour_in(b, a));
}

}  // namespace inkflate
