// SPDX-License-Identifier: Apache-2.0
#include "ink/join_lines.h"

#include <algorithm>

namespace inkflate {
namespace {

/// Lines that turn by more than 60 degrees at a crossing are two; with no other way to go they still are one.
constexpr double kStraightCosine = 0.5;
/// The direction of a line's end is taken over this many points beyond the ink of the node.
constexpr int kDirectionPoints = 8;

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

/// The end of an edge: 2 * edge for its first point, 2 * edge + 1 for its last.
int edge_of(int end) { return end / 2; }
int other_end(int end) { return end ^ 1; }

class Joiner {
 public:
  explicit Joiner(LineGraph const& graph)
      : graph_(graph), mates_(2 * graph.edges.size(), -1), ends_(graph.nodes.size()) {
    for (int end = 0; end < std::ssize(mates_); ++end) {
      if (node_of(end) >= 0) ends_[slot(node_of(end))].push_back(end);
    }
    for (auto const& ends : ends_) pair_ends(ends);
  }

  std::vector<JoinedLine> lines() && {
    is_used_.resize(graph_.edges.size());
    for (int end = 0; end < std::ssize(mates_); ++end) {
      if (mates_[slot(end)] < 0 && node_of(end) >= 0) follow(end);
    }
    for (int end = 0; end < std::ssize(mates_); end += 2) follow(end);
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      if (ends_[i].empty() && graph_.nodes[i].radius_px > 0) {
        lines_.push_back(JoinedLine{{graph_.nodes[i].position}, false, 0});
      }
    }
    return std::move(lines_);
  }

 private:
  LineEdge const& edge(int end) const { return graph_.edges[slot(edge_of(end))]; }
  int node_of(int end) const { return end % 2 == 0 ? edge(end).from : edge(end).to; }

  /// Point number i of an edge, counted from the given end.
  Vec2 point(int end, int i) const {
    auto const& points = edge(end).points;
    int const last = static_cast<int>(points.size()) - 1;
    i = std::min(i, last);
    return points[slot(end % 2 == 0 ? i : last - i)];
  }

  /// How many points at a joined end lie in the ink of the crossing, where the other lines bend them.
  int bent_points(int end) const {
    if (ends_[slot(node_of(end))].size() == 2) return 0;  // no other line: a corner
    int const count = static_cast<int>(edge(end).points.size());
    return std::min(static_cast<int>(graph_.nodes[slot(node_of(end))].radius_px), count / 3);
  }

  /// Away from the node.
  Vec2 direction(int end) const {
    int const first = bent_points(end);
    Vec2 const near = point(end, first);
    Vec2 const far = point(end, first + kDirectionPoints);
    if (near != far) return normalized(far - near);
    return normalized(far - graph_.nodes[slot(node_of(end))].position);
  }

  struct Pair {
    double straightness = 0;
    int a = 0;
    int b = 0;
  };

  void pair_ends(std::vector<int> const& ends) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t k = i + 1; k < ends.size(); ++k) {
        if (edge(ends[i]).kind != edge(ends[k]).kind) continue;
        double const straightness = -dot(direction(ends[i]), direction(ends[k]));
        if (ends.size() > 2 && straightness < kStraightCosine) continue;
        pairs.push_back(Pair{straightness, ends[i], ends[k]});
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](Pair const& p, Pair const& q) { return p.straightness > q.straightness; });
    for (auto const& pair : pairs) {
      if (mates_[slot(pair.a)] >= 0 || mates_[slot(pair.b)] >= 0) continue;
      mates_[slot(pair.a)] = pair.b;
      mates_[slot(pair.b)] = pair.a;
    }
  }

  /// Collects the line that starts with the given end of an edge, unless it is part of one already.
  void follow(int end) {
    if (is_used_[slot(edge_of(end))] != 0) return;
    JoinedLine line;
    line.kind = edge(end).kind;
    add_node(end, line);
    int const start = end;
    while (true) {
      is_used_[slot(edge_of(end))] = 1;
      add_points(end, line);
      int const far = other_end(end);
      int const mate = mates_[slot(far)];
      if (mate < 0) {
        line.is_closed = node_of(far) < 0;
        add_node(far, line);
        break;
      }
      if (ends_[slot(node_of(far))].size() == 2) {
        line.points.push_back(graph_.nodes[slot(node_of(far))].position);
      }
      if (mate == start) {
        line.is_closed = true;
        break;
      }
      end = mate;
    }
    lines_.push_back(std::move(line));
  }

  /// The node itself where the line ends there.
  void add_node(int end, JoinedLine& line) const {
    if (node_of(end) >= 0 && mates_[slot(end)] < 0) {
      line.points.push_back(graph_.nodes[slot(node_of(end))].position);
    }
  }

  void add_points(int end, JoinedLine& line) const {
    int const far = other_end(end);
    int const first = mates_[slot(end)] >= 0 ? bent_points(end) : 0;
    int const cut = mates_[slot(far)] >= 0 ? bent_points(far) : 0;
    int const count = static_cast<int>(edge(end).points.size());
    for (int i = first; i < count - cut; ++i) line.points.push_back(point(end, i));
  }

  LineGraph const& graph_;
  std::vector<int> mates_;              // by end; -1: none
  std::vector<std::vector<int>> ends_;  // by node
  std::vector<char> is_used_;           // by edge
  std::vector<JoinedLine> lines_;
};

}  // namespace

std::vector<JoinedLine> join_lines(LineGraph const& graph) { return Joiner(graph).lines(); }

}  // namespace inkflate
