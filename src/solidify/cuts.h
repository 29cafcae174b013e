// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solidify/solid.h"

namespace inkflate {

/// Rising keys and where each one stands. Looking up takes a few steps, for keys that are spread evenly.
class KeyTable {
 public:
  KeyTable() = default;
  KeyTable(std::vector<std::int64_t> keys, std::int64_t end);
  /// The position of a key, or -1.
  int find(std::int64_t key) const;
  std::span<std::int64_t const> keys() const { return keys_; }

 private:
  std::vector<std::int64_t> keys_;
  std::vector<int> begin_;  // per bucket of keys
  std::int64_t bucket_ = 1;
};

/// The steps of the lattice that lead from inside to outside, each with the place where the surface cuts it.
class Cuts {
 public:
  explicit Cuts(Solid const& solid);

  /// Its number, for a step that is cut, given from either end.
  int find(int node, int direction) const;
  int count() const { return static_cast<int>(places_.size()); }
  int node(int cut) const { return static_cast<int>(table_.keys()[cut] / kFamilies); }
  int direction(int cut) const { return kFamilyDirections[table_.keys()[cut] % kFamilies]; }
  /// How far from its node, as a share of the step.
  double share(int cut) const { return places_[cut].share; }
  /// Whether the surface there is a ball's, not the model's.
  bool is_of_ball(int cut) const { return places_[cut].is_of_ball; }

 private:
  std::array<std::array<int, kDirections>, 2> offsets_;
  int plane_size_ = 1;
  KeyTable table_;
  std::vector<Reach> places_;
};

}  // namespace inkflate
