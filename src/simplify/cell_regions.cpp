// SPDX-License-Identifier: Apache-2.0
#include "simplify/cell_regions.h"

#include <cmath>

#include "simplify/cell_cut.h"

namespace inkflate {
namespace {

class RegionGrower {
 public:
  RegionGrower(StrokeSamples const& samples, Triangulation const& mesh,
               std::span<std::uint8_t const> inside, double passage_px)
      : samples_(samples),
        mesh_(mesh),
        inside_(inside),
        longest_ink_(longest_ink_edge_squared(samples)) {
    double const passage = passage_px * Frame::kLatticePerPx;
    passage_ = static_cast<std::int64_t>(passage * passage);
    result_.of_cell.assign(inside.size(), -1);
    counted_for_.assign(samples.points.size(), -1);
  }

  CellRegions grow_all() {
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      if (inside_[t] != 0 && result_.of_cell[t] < 0 && (passage_ == 0 || has_passage(t))) grow(t);
    }
    return std::move(result_);
  }

 private:
  std::int64_t squared(int e) const { return squared_length(samples_, mesh_, e); }

  bool is_passage(int e) const {
    int const twin = mesh_.twins[e];
    return twin >= 0 && inside_[twin / 3] != 0 && squared(e) > passage_;
  }

  bool has_passage(int t) const {
    return is_passage(3 * t) || is_passage(3 * t + 1) || is_passage(3 * t + 2);
  }

  void grow(int seed) {
    int const region = static_cast<int>(std::ssize(result_.regions));
    cells_.assign(1, seed);
    result_.of_cell[seed] = region;
    for (std::size_t next = 0; next < cells_.size(); ++next) {
      for (int e = 3 * cells_[next]; e < 3 * cells_[next] + 3; ++e) {
        if (!is_passage(e) || result_.of_cell[mesh_.twins[e] / 3] >= 0) continue;
        result_.of_cell[mesh_.twins[e] / 3] = region;
        cells_.push_back(mesh_.twins[e] / 3);
      }
    }
    result_.regions.push_back(measure(region));
  }

  CellRegion measure(int region) {
    CellRegion result;
    Vec2 moment;
    for (int const t : cells_) {
      auto const a = samples_.points[mesh_.corners[3 * t]].position;
      auto const b = samples_.points[mesh_.corners[3 * t + 1]].position;
      auto const c = samples_.points[mesh_.corners[3 * t + 2]].position;
      double const area = cross(b - a, c - a) / 2;
      result.area_px2 += area;
      moment += (a + b + c) * (area / 3);
      for (int e = 3 * t; e < 3 * t + 3; ++e) count_edge(region, e, result);
    }
    if (result.area_px2 > 0) result.centroid = moment / result.area_px2;
    return result;
  }

  void count_edge(int region, int e, CellRegion& result) {
    int const corner = mesh_.corners[e];
    if (counted_for_[corner] != region) {
      counted_for_[corner] = region;
      result.corners.push_back(corner);
    }
    int const twin = mesh_.twins[e];
    if (twin < e || result_.of_cell[twin / 3] != region || squared(e) > longest_ink_) return;
    result.inner_ink_px += std::sqrt(static_cast<double>(squared(e))) / Frame::kLatticePerPx;
  }

  StrokeSamples const& samples_;
  Triangulation const& mesh_;
  std::span<std::uint8_t const> inside_;
  std::int64_t longest_ink_;
  std::int64_t passage_ = 0;
  CellRegions result_;
  std::vector<int> counted_for_;  // per sample: the last region that listed it
  std::vector<int> cells_;
};

}  // namespace

CellRegions join_cells(StrokeSamples const& samples, Triangulation const& mesh,
                       std::span<std::uint8_t const> inside, double passage_px) {
  return RegionGrower(samples, mesh, inside, passage_px).grow_all();
}

}  // namespace inkflate
