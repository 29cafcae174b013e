// SPDX-License-Identifier: Apache-2.0
#include "support/reference_max_flow.h"

#include <algorithm>

namespace inkflate {

std::vector<int> ReferenceMaxFlow::search(int source) const {
  std::vector<int> arc_to(arcs_of_.size(), -1);
  std::vector<int> queue = {source};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (int const arc : arcs_of_[queue[i]]) {
      int const head = arcs_[arc].head;
      if (arcs_[arc].residual == 0 || head == source || arc_to[head] >= 0) continue;
      arc_to[head] = arc;
      queue.push_back(head);
    }
  }
  return arc_to;
}

std::int64_t ReferenceMaxFlow::solve(int source, int sink) {
  std::int64_t flow = 0;
  for (auto arc_to = search(source); arc_to[sink] >= 0; arc_to = search(source)) {
    std::int64_t amount = INT64_MAX;
    for (int node = sink; node != source; node = arcs_[arc_to[node] ^ 1].head) {
      amount = std::min(amount, arcs_[arc_to[node]].residual);
    }
    for (int node = sink; node != source; node = arcs_[arc_to[node] ^ 1].head) {
      arcs_[arc_to[node]].residual -= amount;
      arcs_[arc_to[node] ^ 1].residual += amount;
    }
    flow += amount;
  }
  return flow;
}

}  // namespace inkflate
