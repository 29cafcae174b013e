// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "mesh/check_mesh.h"

namespace inkflate {
namespace {

// Of cells, per triangle; triangles much larger than the others make cells larger until this holds.
constexpr double kMostCellsPerTriangle = 16;
constexpr int kMostCellsPerAxis = 1 << 20;
// Products of three differences of larger coordinates would not be finite.
constexpr double kFarthest = 1e100;

using Corners = std::array<Vec3, 3>;

struct Box {
  Vec3 low;
  Vec3 high;
};

Box box_of(Corners const& t) {
  return {{std::min({t[0].x, t[1].x, t[2].x}), std::min({t[0].y, t[1].y, t[2].y}),
           std::min({t[0].z, t[1].z, t[2].z})},
          {std::max({t[0].x, t[1].x, t[2].x}), std::max({t[0].y, t[1].y, t[2].y}),
           std::max({t[0].z, t[1].z, t[2].z})}};
}

/// On which side of the plane a b c the point d lies: 1, -1, or 0 where rounding could decide.
int side_of_plane(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  auto const p = a - d;
  auto const q = b - d;
  auto const r = c - d;
  double const determinant = dot(p, cross(q, r));
  double const permanent = std::abs(p.x) * (std::abs(q.y * r.z) + std::abs(q.z * r.y)) +
                           std::abs(p.y) * (std::abs(q.z * r.x) + std::abs(q.x * r.z)) +
                           std::abs(p.z) * (std::abs(q.x * r.y) + std::abs(q.y * r.x));
  // (7 + 56 u) u with u = 2^-53, rounded up: the error bound of Shewchuk 1997.
  double const bound = 7.8e-16 * permanent;
  if (determinant > bound) return 1;
  return determinant < -bound ? -1 : 0;
}

bool pierces(Vec3 p, Vec3 q, Corners const& t) {
  if (side_of_plane(t[0], t[1], t[2], p) * side_of_plane(t[0], t[1], t[2], q) >= 0) return false;
  int const first = side_of_plane(p, q, t[0], t[1]);
  return first != 0 && first == side_of_plane(p, q, t[1], t[2]) &&
         first == side_of_plane(p, q, t[2], t[0]);
}

bool cross_each_other(Corners const& a, Corners const& b) {
  for (int i = 0; i < 3; ++i) {
    if (pierces(a[i], a[(i + 1) % 3], b) || pierces(b[i], b[(i + 1) % 3], a)) return true;
  }
  return false;
}

bool overlap(Box const& a, Box const& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

struct Cells {
  std::array<int, 3> low;
  std::array<int, 3> high;
};

/// The cells of a cubic grid that each triangle's box meets.
class CellGrid {
 public:
  explicit CellGrid(std::vector<Box> const& boxes) {
    Vec3 high = boxes.front().high;
    origin_ = boxes.front().low;
    double total = 0;
    for (auto const& box : boxes) {
      origin_ = {std::min(origin_.x, box.low.x), std::min(origin_.y, box.low.y),
                 std::min(origin_.z, box.low.z)};
      high = {std::max(high.x, box.high.x), std::max(high.y, box.high.y),
              std::max(high.z, box.high.z)};
      auto const size = box.high - box.low;
      total += std::max({size.x, size.y, size.z});
    }
    auto const whole = high - origin_;
    double const count = static_cast<double>(boxes.size());
    side_ = std::max(
        {total / count, std::max({whole.x, whole.y, whole.z}) / kMostCellsPerAxis, 1e-300});
    while (cell_count(boxes) > kMostCellsPerTriangle * count) side_ *= 2;
  }

  Cells cells_of(Box const& box) const {
    auto const low = (box.low - origin_) / side_;
    auto const high = (box.high - origin_) / side_;
    return {{static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(low.z)},
            {static_cast<int>(high.x), static_cast<int>(high.y), static_cast<int>(high.z)}};
  }

 private:
  double cell_count(std::vector<Box> const& boxes) const {
    double count = 0;
    for (auto const& box : boxes) {
      auto const cells = cells_of(box);
      double product = 1;
      for (int axis = 0; axis < 3; ++axis) product *= cells.high[axis] - cells.low[axis] + 1.0;
      count += product;
    }
    return count;
  }

  Vec3 origin_;
  double side_ = 1;
};

struct Entry {
  std::array<int, 3> cell;
  int triangle;

  friend bool operator<(Entry const& a, Entry const& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.triangle < b.triangle;
  }
};

std::vector<Entry> sorted_entries(std::vector<Cells> const& cells) {
  std::vector<Entry> entries;
  for (int t = 0; t < std::ssize(cells); ++t) {
    auto const& [low, high] = cells[t];
    for (int x = low[0]; x <= high[0]; ++x) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int z = low[2]; z <= high[2]; ++z) entries.push_back({{x, y, z}, t});
      }
    }
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// The first cell that two triangles share: the one place where they are compared.
std::array<int, 3> home(Cells const& a, Cells const& b) {
  return {std::max(a.low[0], b.low[0]), std::max(a.low[1], b.low[1]), std::max(a.low[2], b.low[2])};
}

bool share_a_vertex(Triangle const& a, Triangle const& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](int v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

bool is_usable(TriMesh const& mesh, Triangle const& t) {
  return std::all_of(t.begin(), t.end(), [&](int v) {
    if (v < 0 || v >= std::ssize(mesh.points)) return false;
    auto const p = mesh.points[v];
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kFarthest &&
           std::isfinite(p.x + p.y + p.z);
  });
}

}  // namespace

int count_self_crossings(TriMesh const& mesh, int most) {
  std::vector<Triangle> triangles;
  std::vector<Corners> corners;
  std::vector<Box> boxes;
  for (auto const& t : mesh.triangles) {
    if (!is_usable(mesh, t)) continue;
    triangles.push_back(t);
    corners.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
    boxes.push_back(box_of(corners.back()));
  }
  if (triangles.empty()) return 0;
  CellGrid const grid(boxes);
  std::vector<Cells> cells;
  cells.reserve(boxes.size());
  for (auto const& box : boxes) cells.push_back(grid.cells_of(box));
  auto const entries = sorted_entries(cells);
  int found = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    int const a = entries[i].triangle;
    for (std::size_t j = i + 1; j < entries.size() && entries[j].cell == entries[i].cell; ++j) {
      int const b = entries[j].triangle;
      if (!overlap(boxes[a], boxes[b]) || home(cells[a], cells[b]) != entries[i].cell) continue;
      if (share_a_vertex(triangles[a], triangles[b]) || !cross_each_other(corners[a], corners[b]))
        continue;
      if (++found >= most) return found;
    }
  }
  return found;
}

}  // namespace inkflate
