// SPDX-License-Identifier: Apache-2.0
#include "ink/line_graph.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "image/components.h"
#include "image/thin.h"

namespace inkflate {
namespace {

/// Spurs within this many radii of the ink (and a px or two) do not reach out of it.
constexpr double kSpurRadii = 1.3;
constexpr double kSpurMarginPx = 2;
/// The two halves of a crossing lie this near, by the radius of the ink there; lines that cross flatly lie farther
/// apart and stay two.
constexpr double kCrossingRadii = 1.6;
constexpr double kCrossingMarginPx = 1;

struct Pixel {
  int x = 0;
  int y = 0;

  friend bool operator==(Pixel const&, Pixel const&) = default;
};

Vec2 centre(Pixel pixel) { return {pixel.x + 0.5, pixel.y + 0.5}; }

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

/// Walks over a thinned mask and collects its edges.
class GraphBuilder {
 public:
  GraphBuilder(Mask const& lines, Grid2<double> const& radius_px)
      : lines_(lines), is_done_(lines.width, lines.height) {
    mark_nodes(radius_px);
  }

  LineGraph build() && {
    for_each_pixel([&](Pixel pixel) {
      if (node_at(pixel) >= 0) walk_from_node(pixel);
    });
    for_each_pixel([&](Pixel pixel) {
      if (node_at(pixel) < 0 && is_done_.at(pixel.x, pixel.y) == 0) walk_around(pixel);
    });
    return std::move(graph_);
  }

 private:
  template <typename Visit>
  void for_each_pixel(Visit const& visit) {
    for (int y = 0; y < lines_.height; ++y) {
      for (int x = 0; x < lines_.width; ++x) {
        if (lines_.at(x, y) != 0) visit(Pixel{x, y});
      }
    }
  }

  /// Every pixel without exactly two neighbours belongs to a node; such pixels that touch share one.
  void mark_nodes(Grid2<double> const& radius_px) {
    Mask ends(lines_.width, lines_.height);
    for_each_pixel([&](Pixel pixel) {
      unsigned const bits = neighbour_bits(lines_, pixel.x, pixel.y);
      int count = 0;
      for (unsigned i = 0; i < 8; ++i) count += (bits >> i & 1U) != 0 ? 1 : 0;
      if (count != 2) ends.at(pixel.x, pixel.y) = 255;
    });
    auto components = connected_components(ends, Neighbours::Eight);
    labels_ = std::move(components.labels);
    graph_.nodes.resize(components.areas.size());
    for_each_pixel([&](Pixel pixel) {
      int const label = node_at(pixel);
      if (label < 0) return;
      auto& node = graph_.nodes[slot(label)];
      node.position += centre(pixel) / static_cast<double>(components.areas[slot(label)]);
      node.radius_px = std::max(node.radius_px, radius_px.at(pixel.x, pixel.y));
    });
  }

  int node_at(Pixel pixel) const { return labels_.at(pixel.x, pixel.y); }

  template <typename Visit>
  void for_each_neighbour(Pixel pixel, Visit const& visit) const {
    unsigned const bits = neighbour_bits(lines_, pixel.x, pixel.y);
    for (unsigned i = 0; i < 8; ++i) {
      if ((bits >> i & 1U) == 0) continue;
      visit(Pixel{pixel.x + kNeighbourSteps[i][0], pixel.y + kNeighbourSteps[i][1]});
    }
  }

  void walk_from_node(Pixel start) {
    for_each_neighbour(start, [&](Pixel first) {
      if (node_at(first) >= 0 || is_done_.at(first.x, first.y) != 0) return;
      LineEdge edge;
      edge.from = node_at(start);
      edge.to = walk(start, first, edge.points);
      // A pixel or two that leave a node and come back are its own thickness.
      if (edge.from == edge.to && edge.points.size() < 4) return;
      graph_.edges.push_back(std::move(edge));
    });
  }

  void walk_around(Pixel start) {
    LineEdge edge;
    edge.points.push_back(centre(start));
    is_done_.at(start.x, start.y) = 1;
    std::optional<Pixel> first;
    for_each_neighbour(start, [&](Pixel pixel) {
      if (!first) first = pixel;
    });
    if (first) walk(start, *first, edge.points);
    graph_.edges.push_back(std::move(edge));
  }

  /// Follows pixels of two neighbours until a node (which it returns) or one already done (-1).
  int walk(Pixel before, Pixel here, Polyline& points) {
    while (true) {
      is_done_.at(here.x, here.y) = 1;
      points.push_back(centre(here));
      std::optional<Pixel> next;
      for_each_neighbour(here, [&](Pixel pixel) {
        if (pixel != before) next = pixel;
      });
      if (!next) return -1;
      if (node_at(*next) >= 0) return node_at(*next);
      if (is_done_.at(next->x, next->y) != 0) return -1;
      before = here;
      here = *next;
    }
  }

  Mask const& lines_;
  Grid2<int> labels_;
  Mask is_done_;
  LineGraph graph_;
};

double edge_length(LineGraph const& graph, LineEdge const& edge) {
  double result = length(edge.points);
  if (edge.from >= 0)
    result += distance(graph.nodes[slot(edge.from)].position, edge.points.front());
  if (edge.to >= 0) result += distance(graph.nodes[slot(edge.to)].position, edge.points.back());
  return result;
}

/// The indices of all edges, shortest first.
std::vector<int> by_length(LineGraph const& graph) {
  std::vector<double> lengths;
  for (auto const& edge : graph.edges) lengths.push_back(edge_length(graph, edge));
  std::vector<int> order(lengths.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return lengths[slot(a)] < lengths[slot(b)]; });
  return order;
}

void remove_edges(LineGraph& graph, std::vector<char> const& is_removed) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    if (is_removed[i] != 0) continue;
    if (kept != i) graph.edges[kept] = std::move(graph.edges[i]);
    ++kept;
  }
  graph.edges.resize(kept);
}

/// The node that a node became part of; follows the chain and shortens it.
int root(std::vector<int>& parents, int node) {
  while (parents[slot(node)] != node) {
    parents[slot(node)] = parents[slot(parents[slot(node)])];
    node = parents[slot(node)];
  }
  return node;
}

}  // namespace

LineGraph line_graph(Mask const& lines, Grid2<double> const& radius_px) {
  return GraphBuilder(lines, radius_px).build();
}

std::vector<int> node_degrees(LineGraph const& graph) {
  std::vector<int> degrees(graph.nodes.size());
  for (auto const& edge : graph.edges) {
    if (edge.from >= 0) ++degrees[slot(edge.from)];
    if (edge.to >= 0) ++degrees[slot(edge.to)];
  }
  return degrees;
}

void prune_spurs(LineGraph& graph) {
  auto degrees = node_degrees(graph);
  std::vector<char> is_removed(graph.edges.size());
  for (int const index : by_length(graph)) {
    auto const& edge = graph.edges[slot(index)];
    if (edge.from < 0 || edge.to < 0 || edge.from == edge.to) continue;
    bool const starts_free = degrees[slot(edge.from)] == 1;
    int const inner = starts_free ? edge.to : edge.from;
    int const outer = starts_free ? edge.from : edge.to;
    if (degrees[slot(outer)] != 1 || degrees[slot(inner)] < 3) continue;
    double const reach_px = kSpurRadii * graph.nodes[slot(inner)].radius_px + kSpurMarginPx;
    if (edge_length(graph, edge) > reach_px) continue;
    is_removed[slot(index)] = 1;
    --degrees[slot(inner)];
    // No line is left at the outer end: it must not come back as a dot.
    degrees[slot(outer)] = 0;
    graph.nodes[slot(outer)].radius_px = 0;
  }
  remove_edges(graph, is_removed);
}

void merge_crossings(LineGraph& graph) {
  auto const degrees = node_degrees(graph);
  std::vector<int> parents(graph.nodes.size());
  std::iota(parents.begin(), parents.end(), 0);
  std::vector<char> is_removed(graph.edges.size());
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    auto const& edge = graph.edges[i];
    if (edge.from < 0 || edge.to < 0 || edge.from == edge.to) continue;
    if (degrees[slot(edge.from)] != 3 || degrees[slot(edge.to)] != 3) continue;
    double const radius_px =
        std::max(graph.nodes[slot(edge.from)].radius_px, graph.nodes[slot(edge.to)].radius_px);
    if (edge_length(graph, edge) > kCrossingRadii * radius_px + kCrossingMarginPx) continue;
    int const from = root(parents, edge.from);
    int const to = root(parents, edge.to);
    if (from == to) continue;
    is_removed[i] = 1;
    parents[slot(to)] = from;
    auto& node = graph.nodes[slot(from)];
    node.position = (node.position + graph.nodes[slot(to)].position) / 2;
    node.radius_px = radius_px;
    graph.nodes[slot(to)].radius_px = 0;
  }
  remove_edges(graph, is_removed);
  for (auto& edge : graph.edges) {
    if (edge.from >= 0) edge.from = root(parents, edge.from);
    if (edge.to >= 0) edge.to = root(parents, edge.to);
  }
}

}  // namespace inkflate
