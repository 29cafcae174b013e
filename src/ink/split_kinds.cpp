// SPDX-License-Identifier: Apache-2.0
#include "ink/split_kinds.h"

#include <algorithm>

#include "ink/ink_colour.h"

namespace inkflate {
namespace {

/// The kind at a point is that of most points this far along the line: crossings and noise do not cut it.
constexpr int kMajorityReach = 7;

std::vector<int> kinds_along(Polyline const& points, Picture const& colour) {
  std::vector<int> blue_before = {0};  // running count
  for (auto const& point : points) {
    bool const is = is_blue(colour.at(static_cast<int>(point.x), static_cast<int>(point.y)));
    blue_before.push_back(blue_before.back() + (is ? 1 : 0));
  }
  auto const count = static_cast<int>(points.size());
  std::vector<int> kinds;
  for (int i = 0; i < count; ++i) {
    int const first = std::max(0, i - kMajorityReach);
    int const end = std::min(count, i + kMajorityReach + 1);
    int const blue =
        blue_before[static_cast<std::size_t>(end)] - blue_before[static_cast<std::size_t>(first)];
    kinds.push_back(2 * blue > end - first ? kHelpLineKind : kInkKind);
  }
  return kinds;
}

}  // namespace

void split_kinds(LineGraph& graph, Picture const& colour) {
  std::vector<LineEdge> result;
  for (auto const& edge : graph.edges) {
    auto const kinds = kinds_along(edge.points, colour);
    LineEdge piece = {{}, edge.from, edge.to, kinds[0]};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      if (kinds[i] != piece.kind) {
        // Nothing but the change of colour is at this node: both pieces end here.
        auto const node = static_cast<int>(graph.nodes.size());
        graph.nodes.push_back(LineNode{edge.points[i], 0});
        piece.to = node;
        result.push_back(piece);
        piece = {{}, node, edge.to, kinds[i]};
      }
      piece.points.push_back(edge.points[i]);
    }
    result.push_back(std::move(piece));
  }
  graph.edges = std::move(result);
}

}  // namespace inkflate
