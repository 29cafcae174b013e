// SPDX-License-Identifier: Apache-2.0
#include "render/layer_rims.h"

#include <algorithm>
#include <tuple>

namespace inkflate {
namespace {

/// An edge of a triangle, in the direction in which the front's triangles have it.
struct SheetEdge {
  int layer = 0;
  int from = 0;
  int to = 0;
  Side side = Side::Front;

  auto key() const { return std::tie(layer, from, to, side); }
  bool is_across_rim_from(SheetEdge const& other) const {
    return layer == other.layer && from == other.from && to == other.to && side != other.side;
  }
};

/// Those of the front that have one of the back at the other side; by layer, then by their first vertex.
std::vector<SheetEdge> rim_edges(RestModel const& model) {
  std::vector<SheetEdge> edges;
  for (std::size_t t = 0; t < model.faces.size(); ++t) {
    auto const [layer, side] = model.faces[t];
    auto const& corners = model.mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      int const a = corners[k];
      int const b = corners[(k + 1) % 3];
      edges.push_back(side == Side::Front ? SheetEdge{layer, a, b, side}
                                          : SheetEdge{layer, b, a, side});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](SheetEdge const& a, SheetEdge const& b) { return a.key() < b.key(); });
  std::vector<SheetEdge> rim;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (edges[i].is_across_rim_from(edges[i + 1])) rim.push_back(edges[i]);
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
  std::vector<std::vector<Polyline>> lines() && {
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
    Polyline line = {place(edges_[i].from)};
    while (i < edges_.size()) {
      is_used_[i] = true;
      line.push_back(place(edges_[i].to));
      i = unused_edge_from(layer, edges_[i].to);
    }
    lines_[static_cast<std::size_t>(layer)].push_back(std::move(line));
  }

  /// The number of edges: none.
  std::size_t unused_edge_from(int layer, int vertex) const {
    auto const key = std::pair(layer, vertex);
    auto const first = std::lower_bound(
        edges_.begin(), edges_.end(), key,
        [](SheetEdge const& edge, auto const& k) { return std::pair(edge.layer, edge.from) < k; });
    for (auto i = static_cast<std::size_t>(first - edges_.begin()); i < edges_.size(); ++i) {
      if (edges_[i].layer != layer || edges_[i].from != vertex) break;
      if (!is_used_[i]) return i;
    }
    return edges_.size();
  }

  Vec2 place(int vertex) const { return model_.canvas[static_cast<std::size_t>(vertex)]; }

  RestModel const& model_;
  std::vector<SheetEdge> edges_;
  std::vector<bool> is_used_;
  std::vector<std::vector<Polyline>> lines_;
};

}  // namespace

std::vector<std::vector<Polyline>> layer_rims(RestModel const& model) {
  return Chainer(model).lines();
}

}  // namespace inkflate
