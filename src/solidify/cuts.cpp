// SPDX-License-Identifier: Apache-2.0
#include "solidify/cuts.h"

#include <algorithm>

#include "base/check.h"

namespace inkflate {

KeyTable::KeyTable(std::vector<std::int64_t> keys, std::int64_t end) : keys_(std::move(keys)) {
  bucket_ = std::max<std::int64_t>(1, end / (std::ssize(keys_) + 1));
  begin_.assign(static_cast<std::size_t>(end / bucket_) + 2, 0);
  for (auto const key : keys_) ++begin_[key / bucket_ + 1];
  for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
}

int KeyTable::find(std::int64_t key) const {
  auto const bucket = key / bucket_;
  auto const first = keys_.begin() + begin_[bucket];
  auto const last = keys_.begin() + begin_[bucket + 1];
  auto const found = std::lower_bound(first, last, key);
  if (found == last || *found != key) return -1;
  return static_cast<int>(found - keys_.begin());
}

Cuts::Cuts(Solid const& solid)
    : offsets_(solid.lattice.offsets()), plane_size_(solid.lattice.columns * solid.lattice.rows) {
  auto const& lattice = solid.lattice;
  std::vector<std::int64_t> keys;
  // The outermost two planes are outside, so are the first and last rows and columns: their steps are never cut.
  for (int n = 2 * plane_size_; n < lattice.node_count() - 2 * plane_size_; ++n) {
    auto const& offsets = offsets_[n / plane_size_ & 1];
    for (int f = 0; f < kFamilies; ++f) {
      int const d = kFamilyDirections[f];
      int const other = n + offsets[d];
      if (solid.sides[n] == solid.sides[other]) continue;
      keys.push_back(std::int64_t{n} * kFamilies + f);
      bool const starts_inside = solid.sides[n] == NodeSide::Inside;
      if (starts_inside) {
        places_.push_back(solid.reach(lattice.node(n), d));
      } else {
        Reach const back = solid.reach(lattice.node(other), opposite_direction(d));
        places_.push_back({1 - back.share, back.is_of_ball});
      }
    }
  }
  table_ = KeyTable(std::move(keys), std::int64_t{lattice.node_count()} * kFamilies);
}

int Cuts::find(int node, int direction) const {
  if (is_forward(direction))
    return table_.find(std::int64_t{node} * kFamilies + family_of(direction));
  int const start = node + offsets_[node / plane_size_ & 1][direction];
  return table_.find(std::int64_t{start} * kFamilies + family_of(direction));
}

}  // namespace inkflate
