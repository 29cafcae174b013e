// SPDX-License-Identifier: Apache-2.0
#include "render/layer_rims.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace inkflate {
namespace {

/// An edge of a triangle, in the direction in which the front's triangles have it.
struct SheetEdge {
  int layer = 0;
  int from = 0;
  int to = 0;
  Side side = Side::Front;
  int triangle = 0;

  auto key() const { return std::tie(layer, from, to, side); }
  bool is_across_rim_from(SheetEdge const& other) const {
    return layer == other.layer && from == other.from && to == other.to && side != other.side;
  }
};

struct RimEdge {
  int layer = 0;
  int from = 0;
  int to = 0;
  double steepness = 1;
};

/// A triangle that leaves no trace on the canvas is no steeper than this.
constexpr double kSteepest = 100;

/// How much higher a triangle is over the edge from the rim on the surface than on the canvas.
double steepness(RestModel const& model, SheetEdge const& edge) {
  auto const& [a, b, c] = model.mesh.triangles[static_cast<std::size_t>(edge.triangle)];
  auto const place = [&](int vertex) { return model.canvas[static_cast<std::size_t>(vertex)]; };
  auto const point = [&](int vertex) {
    return model.mesh.points[static_cast<std::size_t>(vertex)];
  };
  double const flat_area = std::abs(cross(place(b) - place(a), place(c) - place(a)));
  double const area = norm(cross(point(b) - point(a), point(c) - point(a)));
  double const flat_length = distance(place(edge.from), place(edge.to));
  double const length = distance(point(edge.from), point(edge.to));
  double const flat_height = flat_area * length;  // both times both lengths
  double const height = area * flat_length;
  return height < kSteepest * flat_height ? std::max(height / flat_height, 1.0) : kSteepest;
}

/// Caps of open runs stand upright on the canvas: two of their corners are at the same place.
bool is_cap(RestModel const& model, Triangle const& corners) {
  auto const place = [&](std::size_t k) {
    return model.canvas[static_cast<std::size_t>(corners[k])];
  };
  return place(0) == place(1) || place(1) == place(2) || place(2) == place(0);
}

/// Edges of the front that have one of the back at their other side; by layer, then by their first vertex.
std::vector<RimEdge> rim_edges(RestModel const& model) {
  std::vector<SheetEdge> edges;
  for (std::size_t t = 0; t < model.faces.size(); ++t) {
    auto const [layer, side] = model.faces[t];
    auto const& corners = model.mesh.triangles[t];
    if (is_cap(model, corners)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      int const a = corners[k];
      int const b = corners[(k + 1) % 3];
      int const triangle = static_cast<int>(t);
      edges.push_back(side == Side::Front ? SheetEdge{layer, a, b, side, triangle}
                                          : SheetEdge{layer, b, a, side, triangle});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](SheetEdge const& a, SheetEdge const& b) { return a.key() < b.key(); });
  std::vector<RimEdge> rim;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    auto const& front = edges[i];
    auto const& back = edges[i + 1];
    if (!front.is_across_rim_from(back)) continue;
    rim.push_back({front.layer, front.from, front.to,
                   std::max(steepness(model, front), steepness(model, back))});
  }
  return rim;
}

class Chainer {
 public:
  explicit Chainer(RestModel const& model) : model_(model), edges_(rim_edges(model)) {
    is_used_.resize(edges_.size());
    std::size_t layer_count = 0;
    for (auto const& face : model.faces) {
      layer_count = std::max(layer_count, static_cast<std::size_t>(face.layer) + 1);
    }
    lines_.resize(layer_count);
  }

  /// First the lines with two ends, then what is left: the closed ones.
  std::vector<std::vector<RimLine>> lines() && {
    auto const ends = edge_ends();
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      auto const& edge = edges_[i];
      bool const has_edge_before =
          std::binary_search(ends.begin(), ends.end(), std::pair(edge.layer, edge.from));
      if (!has_edge_before) follow(i);
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!is_used_[i]) follow(i);
    }
    return std::move(lines_);
  }

 private:
  std::vector<std::pair<int, int>> edge_ends() const {
    std::vector<std::pair<int, int>> ends;
    for (auto const& edge : edges_) ends.push_back({edge.layer, edge.to});
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  void follow(std::size_t i) {
    int const layer = edges_[i].layer;
    RimLine line = {{place(edges_[i].from)}, {1}};
    while (i < edges_.size()) {
      auto const& edge = edges_[i];
      is_used_[i] = true;
      line.steepness.back() = std::max(line.steepness.back(), edge.steepness);
      line.points.push_back(place(edge.to));
      line.steepness.push_back(edge.steepness);
      i = unused_edge_from(layer, edge.to);
    }
    lines_[static_cast<std::size_t>(layer)].push_back(std::move(line));
  }

  /// The number of edges: none.
  std::size_t unused_edge_from(int layer, int vertex) const {
    auto const key = std::pair(layer, vertex);
    auto const first = std::lower_bound(
        edges_.begin(), edges_.end(), key,
        [](RimEdge const& edge, auto const& k) { return std::pair(edge.layer, edge.from) < k; });
    for (auto i = static_cast<std::size_t>(first - edges_.begin()); i < edges_.size(); ++i) {
      if (edges_[i].layer != layer || edges_[i].from != vertex) break;
      if (!is_used_[i]) return i;
    }
    return edges_.size();
  }

  Vec2 place(int vertex) const { return model_.canvas[static_cast<std::size_t>(vertex)]; }

  RestModel const& model_;
  std::vector<RimEdge> edges_;
  std::vector<bool> is_used_;
  std::vector<std::vector<RimLine>> lines_;
};

}  // namespace

std::vector<std::vector<RimLine>> layer_rims(RestModel const& model) {
  return Chainer(model).lines();
}

}  // namespace inkflate
