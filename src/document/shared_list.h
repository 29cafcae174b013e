// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/check.h"
#include "document/shared_node.h"

namespace inkflate {

/// A list that never changes; a changed copy shares all but a few nodes with it, so keeping every version of a list
/// costs little more than keeping its elements. A tree of nodes of at most 8 entries that know how many elements are
/// under them.
///
/// cost    copy O(1); operator[], with_replaced() and with_pushed() O(log n) time and memory; of() and for_each() O(n)
/// source  persistent vectors: Bagwell and Rompf 2011 (relaxed radix balanced trees), here without rebalancing
template <typename T>
class SharedList {
 public:
  SharedList() = default;
  static SharedList of(std::span<T const> items);

  int size() const { return root_.get() == nullptr ? 0 : root_.get()->size; }
  bool is_empty() const { return size() == 0; }
  T const& operator[](int index) const;

  /// With one more element at the end.
  SharedList with_pushed(T item) const;
  /// With the element at index replaced by items: none removes it, several take its place in their order.
  SharedList with_replaced(int index, std::span<T const> items) const;

  /// visit(element) in order.
  template <typename Visit>
  void for_each(Visit visit) const;

  std::vector<T> to_vector() const;

  /// True when both are the same nodes: a quick "nothing has changed" that may say no although the elements are equal.
  bool is_same(SharedList const& other) const { return root_.get() == other.root_.get(); }

 private:
  using Share = detail::NodeShare<T>;
  enum class Cut {
    Even,       // halves have room for more
    FullFirst,  // for what grows at its end
  };

  /// A node and which of its entries is meant.
  struct Step {
    detail::SharedNode* node = nullptr;
    int entry = 0;
  };
  /// The way from the root down to an element, by level.
  using Way = std::array<Step, static_cast<std::size_t>(detail::kNodeLevels)>;

  Way way_to(int index) const;
  static std::span<T const> elements(detail::SharedNode* leaf) {
    return {detail::entries<T>(leaf), leaf->count};
  }
  static detail::SharedNode* child(Step step) {
    return detail::entries<detail::SharedNode*>(step.node)[step.entry];
  }

  /// Calls take(span) for as few parts of at most 8 as there can be.
  template <typename Entry, typename Take>
  static void cut(std::vector<Entry> const& whole, Cut how, Take take);
  static std::vector<Share> leaves(std::vector<T> const& items, Cut how);
  static std::vector<Share> nodes_above(std::vector<Share> const& nodes, Cut how);
  static SharedList topped(std::vector<Share> nodes, Cut how);
  /// With the leaf at the end of the way replaced by one with these elements, or by several.
  SharedList with_leaf(Way const& way, std::vector<T> const& items, Cut how) const;

  Share root_;  // never a node with one child: it would only be on the way
};

template <typename T>
template <typename Entry, typename Take>
void SharedList<T>::cut(std::vector<Entry> const& whole, Cut how, Take take) {
  std::size_t constexpr most = detail::kNodeEntries;
  std::size_t const parts = (whole.size() + most - 1) / most;
  std::span<Entry const> rest = whole;
  for (std::size_t i = 0; i < parts; ++i) {
    std::size_t const even = (rest.size() + parts - i - 1) / (parts - i);
    std::size_t const count = how == Cut::Even ? even : (rest.size() < most ? rest.size() : most);
    take(rest.first(count));
    rest = rest.subspan(count);
  }
}

template <typename T>
std::vector<detail::NodeShare<T>> SharedList<T>::leaves(std::vector<T> const& items, Cut how) {
  std::vector<Share> result;
  cut(items, how, [&](std::span<T const> part) { result.push_back(Share::leaf(part)); });
  return result;
}

template <typename T>
std::vector<detail::NodeShare<T>> SharedList<T>::nodes_above(std::vector<Share> const& nodes,
                                                             Cut how) {
  std::vector<Share> result;
  cut(nodes, how, [&](std::span<Share const> part) { result.push_back(Share::above(part)); });
  return result;
}

template <typename T>
SharedList<T> SharedList<T>::topped(std::vector<Share> nodes, Cut how) {
  while (nodes.size() > 1) nodes = nodes_above(nodes, how);
  SharedList list;
  if (nodes.empty()) return list;
  list.root_ = nodes.front();
  while (list.root_.get()->level > 0 && list.root_.get()->count == 1) {
    list.root_ = Share::of(child({list.root_.get(), 0}));
  }
  return list;
}

template <typename T>
SharedList<T> SharedList<T>::of(std::span<T const> items) {
  return topped(leaves({items.begin(), items.end()}, Cut::FullFirst), Cut::FullFirst);
}

template <typename T>
auto SharedList<T>::way_to(int index) const -> Way {
  CHECK(index >= 0 && index < size(), "an index outside of the list");
  Way way;
  Step step = {root_.get(), 0};
  while (step.node->level > 0) {
    for (step.entry = 0; index >= child(step)->size; ++step.entry) index -= child(step)->size;
    way[step.node->level] = step;
    step.node = child(step);
  }
  way[0] = {step.node, index};
  return way;
}

template <typename T>
T const& SharedList<T>::operator[](int index) const {
  auto const leaf = way_to(index)[0];
  return detail::entries<T>(leaf.node)[leaf.entry];
}

template <typename T>
SharedList<T> SharedList<T>::with_leaf(Way const& way, std::vector<T> const& items, Cut how) const {
  auto changed = leaves(items, how);
  for (std::size_t level = 1; level <= root_.get()->level; ++level) {
    auto const [node, entry] = way[level];
    std::vector<Share> children;
    children.reserve(node->count + changed.size());
    for (int i = 0; i < node->count; ++i) {
      if (i == entry) {
        children.insert(children.end(), changed.begin(), changed.end());
      } else {
        children.push_back(Share::of(child({node, i})));
      }
    }
    changed = nodes_above(children, how);
  }
  return topped(std::move(changed), how);
}

template <typename T>
SharedList<T> SharedList<T>::with_pushed(T item) const {
  if (is_empty()) return of({&item, 1});
  auto const way = way_to(size() - 1);
  auto const old = elements(way[0].node);
  std::vector<T> items(old.begin(), old.end());
  items.push_back(std::move(item));
  return with_leaf(way, items, Cut::FullFirst);
}

template <typename T>
SharedList<T> SharedList<T>::with_replaced(int index, std::span<T const> items) const {
  auto const way = way_to(index);
  auto const old = elements(way[0].node);
  std::vector<T> all(old.begin(), old.begin() + way[0].entry);
  all.insert(all.end(), items.begin(), items.end());
  all.insert(all.end(), old.begin() + way[0].entry + 1, old.end());
  return with_leaf(way, all, Cut::Even);
}

template <typename T>
template <typename Visit>
void SharedList<T>::for_each(Visit visit) const {
  if (is_empty()) return;
  Way way;
  std::size_t level = root_.get()->level;
  std::size_t const top = level;
  way[level] = {root_.get(), 0};
  while (true) {
    if (level == 0) {
      for (auto const& element : elements(way[0].node)) visit(element);
    } else if (way[level].entry < way[level].node->count) {
      auto* const next = child(way[level]);
      way[--level] = {next, 0};
      continue;
    }
    if (level == top) return;
    ++way[++level].entry;
  }
}

template <typename T>
std::vector<T> SharedList<T>::to_vector() const {
  std::vector<T> items;
  items.reserve(static_cast<std::size_t>(size()));
  for_each([&](T const& item) { items.push_back(item); });
  return items;
}

}  // namespace inkflate
