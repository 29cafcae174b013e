// SPDX-License-Identifier: Apache-2.0
#include "simplify/cell_regions.h"

namespace inkflate {
namespace {

class RegionGrower {
 public:
  RegionGrower(Cells const& cells, std::span<std::uint8_t const> inside, double passage_px)
      : cells_(cells), inside_(inside) {
    double const passage = passage_px * WorkSpace::kLatticePerPx;
    passage_ = static_cast<std::int32_t>(passage * passage);
    result_.of_cell.assign(inside.size(), -1);
    counted_for_.assign(cells.samples.points.size(), -1);
  }

  CellRegions grow_all() {
    for (int t = 0; t < cells_.count(); ++t) {
      if (inside_[t] != 0 && result_.of_cell[t] < 0 && (passage_ == 0 || has_passage(t))) grow(t);
    }
    return std::move(result_);
  }

 private:
  bool is_passage(int e) const {
    int const twin = cells_.twin(e);
    return twin >= 0 && inside_[twin / 3] != 0 && cells_.squared_lengths[e] > passage_;
  }

  bool has_passage(int t) const {
    return is_passage(3 * t) || is_passage(3 * t + 1) || is_passage(3 * t + 2);
  }

  void grow(int seed) {
    int const region = static_cast<int>(std::ssize(result_.regions));
    members_.assign(1, seed);
    result_.of_cell[seed] = region;
    for (std::size_t next = 0; next < members_.size(); ++next) {
      for (int e = 3 * members_[next]; e < 3 * members_[next] + 3; ++e) {
        if (!is_passage(e) || result_.of_cell[cells_.twin(e) / 3] >= 0) continue;
        result_.of_cell[cells_.twin(e) / 3] = region;
        members_.push_back(cells_.twin(e) / 3);
      }
    }
    result_.regions.push_back(measure(region));
  }

  CellRegion measure(int region) {
    CellRegion result;
    Vec2 moment;
    for (int const t : members_) {
      auto const a = cells_.position(cells_.corner(3 * t));
      auto const b = cells_.position(cells_.corner(3 * t + 1));
      auto const c = cells_.position(cells_.corner(3 * t + 2));
      double const area = cross(b - a, c - a) / 2;
      result.area_px2 += area;
      moment += (a + b + c) * (area / 3);
      for (int e = 3 * t; e < 3 * t + 3; ++e) count_edge(region, e, result);
    }
    if (result.area_px2 > 0) result.centroid = moment / result.area_px2;
    return result;
  }

  void count_edge(int region, int e, CellRegion& result) {
    int const corner = cells_.corner(e);
    if (counted_for_[corner] != region) {
      counted_for_[corner] = region;
      result.corners.push_back(corner);
    }
    int const twin = cells_.twin(e);
    if (twin < e || result_.of_cell[twin / 3] != region || !cells_.is_ink(e))
      return;  // twin < e: met from there
    result.inner_ink_px += cells_.length_px(e);
  }

  Cells const& cells_;
  std::span<std::uint8_t const> inside_;
  std::int32_t passage_ = 0;  // lattice units, squared
  CellRegions result_;
  std::vector<int> counted_for_;  // per sample: the last region that listed it
  std::vector<int> members_;      // the cells of the region at hand
};

}  // namespace

CellRegions join_cells(Cells const& cells, std::span<std::uint8_t const> inside,
                       double passage_px) {
  return RegionGrower(cells, inside, passage_px).grow_all();
}

}  // namespace inkflate
