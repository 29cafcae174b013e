// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/check.h"

namespace inkflate {

/// A graph whose nodes all have the same small number of arcs. The arcs of node n are
/// n * kDegree ... n * kDegree + kDegree - 1. reverse(arc) is the arc that runs the other way, which belongs to the
/// node where this one ends; -1: the arc leads nowhere. reverse is its own inverse.
template <class T>
concept CutTopology = requires(T const& topology, int arc) {
  { T::kDegree } -> std::convertible_to<int>;
  { topology.node_count() } -> std::convertible_to<int>;
  { topology.reverse(arc) } -> std::convertible_to<int>;
};

/// What it costs to put a node on the other side: `source` is paid on the sink's side, `sink` on the source's.
struct TerminalCapacity {
  std::int32_t source = 0;  // >= 0
  std::int32_t sink = 0;    // >= 0

  friend bool operator==(TerminalCapacity const&, TerminalCapacity const&) = default;
};

/// Which of several minimum cuts. The source sides of all of them have a common part and a common hull, which are
/// themselves source sides of minimum cuts.
enum class CutTies {
  SmallestSource,  // the source's side: what it still reaches when the flow is maximal
  LargestSource,   // the sink's side: what still reaches the sink
};

/// Finds minimum cuts; keeps its memory from one call to the next. 26 + 4 kDegree bytes per node.
///
/// source  Boykov and Kolmogorov 2004, section 3: two search trees that survive augmentation. Not in the paper:
///         distances to the root, stamped with the round, make orphans take the nearest parent at little cost
template <CutTopology Topology>
class MinCut {
 public:
  /// The value of the minimum cut, which is that of the maximum flow.
  ///
  /// in      capacities: one per arc, >= 0, an arc and its reverse together at most 2^31 - 1; those of arcs that
  ///         lead nowhere do not count
  ///         terminals: one per node
  /// cost    O(arcs nodes^2 value) in theory; near linear on planar graphs with local structure
  std::int64_t solve(Topology const& topology, std::span<std::int32_t const> capacities,
                     std::span<TerminalCapacity const> terminals);

  /// After solve: whether the node is on the source's side.
  bool in_source(int node, CutTies ties = CutTies::SmallestSource) const {
    return ties == CutTies::SmallestSource ? tree_[node] == Tree::Source
                                           : tree_[node] != Tree::Sink;
  }

 private:
  enum class Tree : std::uint8_t { None, Source, Sink };

  // Values of Node::parent that are no arcs.
  static constexpr std::int32_t kRoot = -1;    // the parent is the terminal
  static constexpr std::int32_t kOrphan = -2;  // waits for a new parent, or is in no tree

  struct Node {
    std::int32_t parent = kOrphan;  // the arc from this node to its parent
    std::int32_t terminal = 0;      // residual from the source if > 0, to the sink if < 0
    std::int32_t stamp = 0;         // the round when distance was right
    std::int32_t distance = 0;      // arcs to the terminal
  };

  /// A queue in which every node is at most once: the memory of node_count entries is enough.
  class NodeRing {
   public:
    void reset(int node_count) {
      slots_.resize(static_cast<std::size_t>(node_count));
      first_ = 0;
      size_ = 0;
    }
    bool is_empty() const { return size_ == 0; }
    void push_back(int node) {
      auto const capacity = static_cast<int>(std::ssize(slots_));
      int const slot = first_ + size_++;
      slots_[slot < capacity ? slot : slot - capacity] = node;
    }
    void push_front(int node) {
      first_ = first_ > 0 ? first_ - 1 : static_cast<int>(std::ssize(slots_)) - 1;
      slots_[first_] = node;
      ++size_;
    }
    int pop_front() {
      int const node = slots_[first_];
      first_ = first_ + 1 < std::ssize(slots_) ? first_ + 1 : 0;
      --size_;
      return node;
    }

   private:
    std::vector<std::int32_t> slots_;
    int first_ = 0;
    int size_ = 0;
  };

  static constexpr int kDegree = Topology::kDegree;
  static constexpr int kFar = std::numeric_limits<int>::max();

  void reset(Topology const& topology, std::span<std::int32_t const> capacities,
             std::span<TerminalCapacity const> terminals);
  void activate(int node);
  /// Lets a tree take the free neighbours of a node. Returns the arc from the source's to the sink's tree where
  /// it meets the other tree, or -1 when there is nothing more to take.
  template <Tree side>
  int grow(Topology const& topology, int node);
  void augment(Topology const& topology, int bridge);
  template <Tree side>
  int bottleneck(Topology const& topology, int node, int limit) const;
  template <Tree side>
  void push(Topology const& topology, int node, int amount);
  void adopt_orphans(Topology const& topology);
  template <Tree side>
  void adopt(Topology const& topology, int orphan);
  template <Tree side>
  void set_free(Topology const& topology, int orphan);
  int distance_to_root(Topology const& topology, int node) const;
  void remember_distances(Topology const& topology, int node, int distance);
  void next_round();

  /// The residual capacity of the arc along which flow passes between a node of the tree and its neighbour:
  /// away from the source, towards the sink.
  template <Tree side>
  std::int32_t& residual_outward(int arc, int reverse) {
    return residual_[side == Tree::Source ? arc : reverse];
  }

  std::vector<std::int32_t> residual_;
  std::vector<Node> nodes_;
  std::vector<Tree> tree_;
  std::vector<std::uint8_t> is_active_;
  NodeRing active_;
  NodeRing orphans_;
  std::int64_t flow_ = 0;
  std::int32_t round_ = 0;
};

struct Cut {
  std::int64_t value = 0;
  std::vector<std::uint8_t> in_source;  // per node, 0 or 1
};

/// One minimum cut; see MinCut::solve.
template <CutTopology Topology>
Cut minimum_cut(Topology const& topology, std::span<std::int32_t const> capacities,
                std::span<TerminalCapacity const> terminals,
                CutTies ties = CutTies::SmallestSource) {
  MinCut<Topology> solver;
  Cut cut;
  cut.value = solver.solve(topology, capacities, terminals);
  cut.in_source.reserve(terminals.size());
  for (int node = 0; node < std::ssize(terminals); ++node) {
    cut.in_source.push_back(solver.in_source(node, ties) ? 1 : 0);
  }
  return cut;
}

template <CutTopology Topology>
std::int64_t MinCut<Topology>::solve(Topology const& topology,
                                     std::span<std::int32_t const> capacities,
                                     std::span<TerminalCapacity const> terminals) {
  reset(topology, capacities, terminals);
  while (!active_.is_empty()) {
    int const node = active_.pop_front();
    // The same node goes on growing after an augmentation, as long as it keeps its tree: its other neighbours
    // are warm in the cache, and likely bridges too.
    while (tree_[node] != Tree::None) {
      int const bridge = tree_[node] == Tree::Source ? grow<Tree::Source>(topology, node)
                                                     : grow<Tree::Sink>(topology, node);
      if (bridge < 0) break;
      augment(topology, bridge);
      next_round();
      adopt_orphans(topology);
    }
    is_active_[node] = 0;
  }
  return flow_;
}

template <CutTopology Topology>
void MinCut<Topology>::reset(Topology const& topology, std::span<std::int32_t const> capacities,
                             std::span<TerminalCapacity const> terminals) {
  int const count = topology.node_count();
  CHECK(count <= std::numeric_limits<int>::max() / kDegree, "arcs are numbered by int");
  CHECK(std::ssize(capacities) == static_cast<std::ptrdiff_t>(count) * kDegree, "one per arc");
  CHECK(std::ssize(terminals) == count, "one pair of terminal capacities per node");
  for (int arc = 0; arc < count * kDegree; ++arc) {
    [[maybe_unused]] auto const is_legal = [&] {
      int const reverse = topology.reverse(arc);
      if (reverse < 0) return true;
      return topology.reverse(reverse) == arc && capacities[arc] >= 0 &&
             capacities[reverse] <= kFar - capacities[arc];
    };
    DCHECK(is_legal(), "arcs come in pairs whose capacities fit into 32 bits together");
  }
  residual_.assign(capacities.begin(), capacities.end());
  nodes_.assign(static_cast<std::size_t>(count), Node{});
  tree_.assign(static_cast<std::size_t>(count), Tree::None);
  is_active_.assign(static_cast<std::size_t>(count), 0);
  active_.reset(count);
  orphans_.reset(count);
  flow_ = 0;
  round_ = 0;
  for (int n = 0; n < count; ++n) {
    // What both terminals pay is paid by every cut.
    auto const [source, sink] = terminals[n];
    flow_ += std::min(source, sink);
    if (source == sink) continue;
    tree_[n] = source > sink ? Tree::Source : Tree::Sink;
    nodes_[n] = {kRoot, source - sink, 0, 1};
    activate(n);
  }
}

template <CutTopology Topology>
void MinCut<Topology>::activate(int node) {
  if (is_active_[node] != 0) return;
  is_active_[node] = 1;
  active_.push_back(node);
}

template <CutTopology Topology>
template <typename MinCut<Topology>::Tree side>
int MinCut<Topology>::grow(Topology const& topology, int node) {
  auto const& from = nodes_[node];
  for (int arc = node * kDegree; arc < node * kDegree + kDegree; ++arc) {
    int const reverse = topology.reverse(arc);
    if (reverse < 0 || residual_outward<side>(arc, reverse) == 0) continue;
    int const neighbour = reverse / kDegree;
    auto& to = nodes_[neighbour];
    if (tree_[neighbour] == Tree::None) {
      tree_[neighbour] = side;
      to = {reverse, to.terminal, from.stamp, from.distance + 1};
      activate(neighbour);
    } else if (tree_[neighbour] != side) {
      return side == Tree::Source ? arc : reverse;
    } else if (to.stamp <= from.stamp && to.distance > from.distance + 1) {
      to = {reverse, to.terminal, from.stamp, from.distance + 1};  // a shorter way to the root
    }
  }
  return -1;
}

template <CutTopology Topology>
void MinCut<Topology>::augment(Topology const& topology, int bridge) {
  int const reverse = topology.reverse(bridge);
  int const from = bridge / kDegree;
  int const to = reverse / kDegree;
  int amount = bottleneck<Tree::Source>(topology, from, residual_[bridge]);
  amount = bottleneck<Tree::Sink>(topology, to, amount);
  residual_[bridge] -= amount;
  residual_[reverse] += amount;
  push<Tree::Source>(topology, from, amount);
  push<Tree::Sink>(topology, to, amount);
  flow_ += amount;
}

template <CutTopology Topology>
template <typename MinCut<Topology>::Tree side>
int MinCut<Topology>::bottleneck(Topology const& topology, int node, int limit) const {
  int arc = nodes_[node].parent;
  while (arc >= 0) {
    int const reverse = topology.reverse(arc);
    limit = std::min(limit, residual_[side == Tree::Source ? reverse : arc]);
    node = reverse / kDegree;
    arc = nodes_[node].parent;
  }
  return std::min(limit, side == Tree::Source ? nodes_[node].terminal : -nodes_[node].terminal);
}

template <CutTopology Topology>
template <typename MinCut<Topology>::Tree side>
void MinCut<Topology>::push(Topology const& topology, int node, int amount) {
  int arc = nodes_[node].parent;
  while (arc >= 0) {
    int const reverse = topology.reverse(arc);
    auto& inward = residual_[side == Tree::Source ? reverse : arc];
    inward -= amount;
    residual_[side == Tree::Source ? arc : reverse] += amount;
    int const next = reverse / kDegree;
    if (inward == 0) {
      nodes_[node].parent = kOrphan;
      orphans_.push_front(node);  // the one nearest to the root is adopted first
    }
    node = next;
    arc = nodes_[node].parent;
  }
  auto& root = nodes_[node];
  root.terminal += side == Tree::Source ? -amount : amount;
  if (root.terminal == 0) {
    root.parent = kOrphan;
    orphans_.push_front(node);
  }
}

template <CutTopology Topology>
void MinCut<Topology>::adopt_orphans(Topology const& topology) {
  while (!orphans_.is_empty()) {
    int const orphan = orphans_.pop_front();
    if (tree_[orphan] == Tree::Source) {
      adopt<Tree::Source>(topology, orphan);
    } else {
      adopt<Tree::Sink>(topology, orphan);
    }
  }
}

template <CutTopology Topology>
template <typename MinCut<Topology>::Tree side>
void MinCut<Topology>::adopt(Topology const& topology, int orphan) {
  int best_arc = kOrphan;
  int best_distance = kFar;
  for (int arc = orphan * kDegree; arc < orphan * kDegree + kDegree; ++arc) {
    int const reverse = topology.reverse(arc);
    if (reverse < 0 || residual_outward<side>(reverse, arc) == 0) continue;
    int const neighbour = reverse / kDegree;
    if (tree_[neighbour] != side) continue;
    int const distance = distance_to_root(topology, neighbour);
    if (distance == kFar) continue;  // hangs on an orphan, perhaps on this one
    remember_distances(topology, neighbour, distance);
    if (distance < best_distance) {
      best_arc = arc;
      best_distance = distance;
    }
  }
  if (best_arc < 0) {
    set_free<side>(topology, orphan);
    return;
  }
  auto& node = nodes_[orphan];
  node = {best_arc, node.terminal, round_, best_distance + 1};
}

template <CutTopology Topology>
template <typename MinCut<Topology>::Tree side>
void MinCut<Topology>::set_free(Topology const& topology, int orphan) {
  tree_[orphan] = Tree::None;
  for (int arc = orphan * kDegree; arc < orphan * kDegree + kDegree; ++arc) {
    int const reverse = topology.reverse(arc);
    if (reverse < 0) continue;
    int const neighbour = reverse / kDegree;
    if (tree_[neighbour] != side) continue;
    if (residual_outward<side>(reverse, arc) > 0) activate(neighbour);
    if (nodes_[neighbour].parent == reverse) {
      nodes_[neighbour].parent = kOrphan;
      orphans_.push_back(neighbour);
    }
  }
}

/// kFar when the way up ends at an orphan.
template <CutTopology Topology>
int MinCut<Topology>::distance_to_root(Topology const& topology, int node) const {
  int steps = 0;
  while (nodes_[node].stamp != round_) {
    int const arc = nodes_[node].parent;
    if (arc == kRoot) return steps + 1;
    if (arc == kOrphan) return kFar;
    node = topology.reverse(arc) / kDegree;
    ++steps;
  }
  return steps + nodes_[node].distance;
}

/// Stamps the way up that distance_to_root has just gone, so that it is gone once per round.
template <CutTopology Topology>
void MinCut<Topology>::remember_distances(Topology const& topology, int node, int distance) {
  while (nodes_[node].stamp != round_) {
    nodes_[node].stamp = round_;
    nodes_[node].distance = distance--;
    int const arc = nodes_[node].parent;
    if (arc == kRoot) return;
    node = topology.reverse(arc) / kDegree;
  }
}

template <CutTopology Topology>
void MinCut<Topology>::next_round() {
  if (round_ == std::numeric_limits<std::int32_t>::max()) {  // old stamps would look new
    for (auto& node : nodes_) node.stamp = 0;
    round_ = 0;
  }
  ++round_;
}

}  // namespace inkflate
