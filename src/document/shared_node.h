// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <utility>

#include "base/check.h"

namespace inkflate::detail {

/// How many entries a node has at most.
inline constexpr int kNodeEntries = 8;

/// How many levels a tree has at most. A level is added when a node of every level below overflows, and a half of 9 entries needs
/// 4 more to overflow again: 16 levels take 4^16 changes.
inline constexpr int kNodeLevels = 24;

/// What stands before the entries of a node, in one piece of memory with them that is exactly as long as they need: most nodes that
/// a history keeps are copies of not yet full ones.
struct SharedNode {
  std::atomic<int> owners = 1;
  int size = 0;            // elements under this node
  std::uint8_t count = 0;  // entries: 1 .. kNodeEntries
  std::uint8_t level = 0;  // 0: the entries are elements; else nodes of one level less
};

/// Where the entries begin: aligned for all of them.
inline constexpr std::size_t kEntriesOffsetBytes = 16;
static_assert(sizeof(SharedNode) <= kEntriesOffsetBytes);

template <typename Entry>
Entry* entries(SharedNode* node) {
  static_assert(alignof(Entry) <= kEntriesOffsetBytes);
  auto* const bytes = static_cast<std::byte*>(static_cast<void*>(node));
  return static_cast<Entry*>(static_cast<void*>(bytes + kEntriesOffsetBytes));
}

/// Counts one owner less; true: it was the last.
inline bool drop_owner(SharedNode& node) {
  return node.owners.fetch_sub(1, std::memory_order_acq_rel) == 1;
}

/// Memory for a node with room for its entries.
template <typename Entry>
SharedNode* allocate_node(std::size_t count, int level) {
  // Entries of inner nodes are pointers indeed. NOLINTNEXTLINE(bugprone-sizeof-expression)
  std::size_t const entry_bytes = sizeof(Entry);
  auto* const node = new (::operator new(kEntriesOffsetBytes + count * entry_bytes)) SharedNode;
  node->count = static_cast<std::uint8_t>(count);
  node->level = static_cast<std::uint8_t>(level);
  return node;
}

/// Gives up one share of a tree; what has no other owner goes. At each level at most the brothers of the node at work wait.
template <typename T>
void release_node(SharedNode* node) {
  if (node == nullptr || !drop_owner(*node)) return;
  std::array<SharedNode*, static_cast<std::size_t>(kNodeEntries * kNodeLevels)> dead;
  std::size_t dead_count = 0;
  dead[dead_count++] = node;
  while (dead_count > 0) {
    auto* const gone = dead[--dead_count];
    if (gone->level == 0) {
      std::destroy_n(entries<T>(gone), gone->count);
    } else {
      for (auto* const child : std::span(entries<SharedNode*>(gone), gone->count)) {
        if (drop_owner(*child)) dead[dead_count++] = child;
      }
    }
    gone->~SharedNode();
    ::operator delete(gone);
  }
}

/// A share in a node of a list of T.
template <typename T>
class NodeShare {
 public:
  NodeShare() = default;
  NodeShare(NodeShare const& other) : node_(other.node_) {
    if (node_ != nullptr) node_->owners.fetch_add(1, std::memory_order_relaxed);
  }
  NodeShare(NodeShare&& other) noexcept : node_(std::exchange(other.node_, nullptr)) {}
  NodeShare& operator=(NodeShare other) noexcept {
    std::swap(node_, other.node_);
    return *this;
  }
  ~NodeShare() { release_node<T>(node_); }

  static NodeShare leaf(std::span<T const> items) {
    auto* const node = allocate_node<T>(items.size(), 0);
    std::uninitialized_copy(items.begin(), items.end(), entries<T>(node));
    node->size = static_cast<int>(items.size());
    return NodeShare(node);
  }

  /// A node above others of one level.
  static NodeShare above(std::span<NodeShare const> children) {
    int const level = children.front().get()->level + 1;
    CHECK(level < kNodeLevels, "a list is deeper than its elements can be many");
    auto* const node = allocate_node<SharedNode*>(children.size(), level);
    auto* slot = entries<SharedNode*>(node);
    for (auto const& child : children) {
      *slot++ = NodeShare(child).give_up();
      node->size += child.get()->size;
    }
    return NodeShare(node);
  }

  /// One more share in a node that others hold.
  static NodeShare of(SharedNode* node) {
    node->owners.fetch_add(1, std::memory_order_relaxed);
    return NodeShare(node);
  }

  SharedNode* get() const { return node_; }

 private:
  explicit NodeShare(SharedNode* node) : node_(node) {}
  SharedNode* give_up() { return std::exchange(node_, nullptr); }

  SharedNode* node_ = nullptr;
};

}  // namespace inkflate::detail
