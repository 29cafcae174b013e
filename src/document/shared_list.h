// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace inkflate {

/// A list that never changes; a changed copy shares all but a few nodes with it, so keeping every version of a list
/// costs little more than keeping its elements. A tree of nodes of at most 8 entries that know how many elements are
/// under them.
///
/// cost    copy O(1); operator[], with() and with_pushed() O(log n) time and memory; of() and for_each() O(n)
/// source  persistent vectors: Bagwell and Rompf 2011 (relaxed radix balanced trees), here without rebalancing
template <typename T>
class SharedList {
 public:
  SharedList() = default;
  static SharedList of(std::span<T const> items);

  int size() const;
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
  bool is_same(SharedList const& other) const;
};

}  // namespace inkflate
