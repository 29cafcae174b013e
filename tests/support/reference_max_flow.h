// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace inkflate {

/// The maximum flow from one node to another by shortest augmenting paths (Edmonds and Karp 1972): slow and plain,
/// to compare with.
class ReferenceMaxFlow {
 public:
  explicit ReferenceMaxFlow(int node_count) : arcs_of_(static_cast<std::size_t>(node_count)) {}

  void add_arc(int from, int to, std::int64_t capacity) {
    arcs_of_[from].push_back(static_cast<int>(std::ssize(arcs_)));
    arcs_.push_back({to, capacity});
    arcs_of_[to].push_back(static_cast<int>(std::ssize(arcs_)));
    arcs_.push_back({from, 0});
  }

  std::int64_t solve(int source, int sink);

 private:
  struct Arc {
    int head = 0;
    std::int64_t residual = 0;
  };

  /// Per node the arc by which a breadth-first search from the source reaches it; -1: not reached.
  std::vector<int> search(int source) const;

  std::vector<Arc> arcs_;  // 2 i and 2 i + 1 run opposite ways
  std::vector<std::vector<int>> arcs_of_;
};

}  // namespace inkflate
