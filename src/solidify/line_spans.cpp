// SPDX-License-Identifier: Apache-2.0
#include "solidify/line_spans.h"

#include <algorithm>

#include "base/check.h"

namespace inkflate {
namespace {

constexpr std::size_t kMostHits = 8'000'000;       // 128 MB, twice while they are sorted
constexpr std::int64_t kMostWork = 2'000'000'000;  // lines tested for one direction
constexpr int kSlackLines = 2;

using Point2 = LinePlanePoint;

/// Twice the area of a, b, p; positive when p lies left of a -> b.
std::int64_t turn(Point2 a, Point2 b, Point2 p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// The least turn that counts as left of a -> b, when points on the edge are meant to lie a little to the right (+u) and less up (+v).
std::int64_t least_turn(Point2 a, Point2 b) {
  bool const is_left = b[1] != a[1] ? b[1] < a[1] : b[0] > a[0];
  return is_left ? 0 : 1;
}

std::int64_t ceil_line(std::int64_t quanta) { return -((-quanta) >> 12); }
std::int64_t floor_line(std::int64_t quanta) { return quanta >> 12; }

}  // namespace

static_assert(kQuanta == 1 << 12, "ceil_line and floor_line shift by 12");

LineSpans::LineSpans(Lattice const& lattice, int family) : family_(family) {
  if (is_axis()) {
    constexpr std::array<LatticeNode, 3> units = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    along_ = family;
    across_u_ = units[(family + 1) % 3];
    across_v_ = units[(family + 2) % 3];
    std::array<int, 3> const sizes = {lattice.size_i(), lattice.size_j(), lattice.size_k()};
    columns_ = (sizes[(family + 1) % 3] + 1) / 2;
    rows_ = sizes[(family + 2) % 3];
  } else {
    auto const step = kSteps[kFamilyDirections[family]];
    along_ = 2;
    across_u_ = {1, 0, -step.i};
    across_v_ = {0, 1, -step.j};
    int const k_even = lattice.size_k() + lattice.size_k() % 2;
    first_u_ = step.i > 0 ? -k_even : 0;
    first_v_ = step.j > 0 ? -k_even : 0;
    columns_ = (lattice.size_i() + k_even) / 2 + kSlackLines;
    rows_ = (lattice.size_j() + k_even) / 2 + kSlackLines;
  }
  begin_.assign(static_cast<std::size_t>(line_count()) + 1, 0);
}

Vec3 LineSpans::place(int line, double at) const {
  int const row = line / columns_;
  if (!is_axis()) {
    auto const step = kSteps[kFamilyDirections[family_]];
    return {2.0 * (line % columns_) + first_u_ + step.i * at, 2.0 * row + first_v_ + step.j * at,
            at};
  }
  double const u = 2 * (line % columns_) + (row & 1);
  double const v = row;
  if (along_ == 0) return {at, u, v};
  if (along_ == 1) return {v, at, u};
  return {u, v, at};
}

LineSpans::Projection LineSpans::project(LatticeMesh const& mesh, int t) const {
  Projection shape;
  for (int c = 0; c < 3; ++c) {
    auto const& q = mesh.points[mesh.triangles[t][c]];
    shape.corners[c] = {across_u_.i * q[0] + across_u_.j * q[1] + across_u_.k * q[2],
                        across_v_.i * q[0] + across_v_.j * q[1] + across_v_.k * q[2]};
    shape.along[c] = static_cast<double>(q[along_]);
  }
  shape.area = turn(shape.corners[0], shape.corners[1], shape.corners[2]);
  // Seen against the lines a front face turns left: a line that meets it leaves the solid.
  shape.is_out = shape.area > 0;
  if (shape.is_out) return shape;
  std::swap(shape.corners[1], shape.corners[2]);
  std::swap(shape.along[1], shape.along[2]);
  shape.area = -shape.area;
  return shape;
}

bool LineSpans::scan_triangle(Projection const& shape, int t, std::vector<Hit>& hits,
                              std::int64_t& work) const {
  auto const& p = shape.corners;
  auto const u_range = std::minmax({p[0][0], p[1][0], p[2][0]});
  auto const v_range = std::minmax({p[0][1], p[1][1], p[2][1]});
  std::int64_t const last_u = floor_line(u_range.second);
  std::int64_t const last_v = floor_line(v_range.second);
  for (std::int64_t v = ceil_line(v_range.first); v <= last_v; ++v) {
    if (!is_axis() && (v & 1) != 0) continue;
    std::int64_t u = ceil_line(u_range.first);
    if (((u ^ (is_axis() ? v : 0)) & 1) != 0) ++u;
    if (u > last_u) continue;
    work += (last_u - u) / 2 + 1;
    scan_row(shape, t, {u, v}, last_u, hits);
  }
  return hits.size() <= kMostHits && work <= kMostWork;
}

void LineSpans::scan_row(Projection const& shape, int t, Point2 first, std::int64_t last_u,
                         std::vector<Hit>& hits) const {
  auto const& p = shape.corners;
  std::int64_t const v = first[1];
  double const scale = 1.0 / (static_cast<double>(shape.area) * kQuanta);
  std::array<std::int64_t, 3> turns{};
  std::array<std::int64_t, 3> least{};
  std::array<std::int64_t, 3> steps{};
  for (int c = 0; c < 3; ++c) {
    Point2 const a = p[(c + 1) % 3];
    Point2 const b = p[(c + 2) % 3];
    turns[c] = turn(a, b, {first[0] * kQuanta, v * kQuanta});
    least[c] = least_turn(a, b);
    steps[c] = -2 * kQuanta * (b[1] - a[1]);
  }
  for (std::int64_t u = first[0]; u <= last_u; u += 2) {
    if (turns[0] >= least[0] && turns[1] >= least[1] && turns[2] >= least[2]) {
      double const position = (static_cast<double>(turns[0]) * shape.along[0] +
                               static_cast<double>(turns[1]) * shape.along[1] +
                               static_cast<double>(turns[2]) * shape.along[2]) *
                              scale;
      int const line = line_at(static_cast<int>(u) - first_u_, static_cast<int>(v) - first_v_);
      hits.push_back({position, line, 2 * t + (shape.is_out ? 0 : 1)});
    }
    for (int c = 0; c < 3; ++c) turns[c] += steps[c];
  }
}

Result<bool> LineSpans::scan(LatticeMesh const& mesh) {
  std::vector<Hit> hits;
  std::int64_t work = 0;
  for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
    Projection const shape = project(mesh, t);
    if (shape.area > 0 && !scan_triangle(shape, t, hits, work))
      return Error{ErrorCode::TooLarge,
                   "The model has too many large triangles to be made solid; use fewer cells.", t};
  }
  keep_union(hits);
  return true;
}

std::vector<int> LineSpans::sort_by_line(std::vector<Hit>& hits) const {
  std::vector<int> first(begin_.size(), 0);
  for (auto const& hit : hits) ++first[hit.line + 1];
  for (std::size_t l = 1; l < first.size(); ++l) first[l] += first[l - 1];
  auto next = first;
  std::vector<Hit> sorted(hits.size());
  for (auto const& hit : hits) sorted[next[hit.line]++] = hit;
  hits = std::move(sorted);
  return first;
}

void LineSpans::keep_union(std::vector<Hit>& hits) {
  auto const first = sort_by_line(hits);
  crossings_.clear();
  for (int l = 0; l < line_count(); ++l) {
    begin_[l] = static_cast<int>(crossings_.size());
    std::span<Hit> const line{hits.data() + first[l],
                              static_cast<std::size_t>(first[l + 1] - first[l])};
    // In before out: shells that touch are one.
    std::sort(line.begin(), line.end(), [](Hit const& a, Hit const& b) {
      if (a.at != b.at) return a.at < b.at;
      int const a_in = a.triangle_and_turn & 1;
      int const b_in = b.triangle_and_turn & 1;
      return a_in != b_in ? a_in > b_in : a.triangle_and_turn < b.triangle_and_turn;
    });
    int winding = 0;
    for (auto const& hit : line) {
      int const before = winding;
      winding += (hit.triangle_and_turn & 1) != 0 ? 1 : -1;
      if ((before > 0) != (winding > 0)) crossings_.push_back({hit.at, hit.triangle_and_turn / 2});
    }
    CHECK(winding == 0, "a line leaves a closed mesh as often as it goes in");
  }
  begin_.back() = static_cast<int>(crossings_.size());
  crossings_.shrink_to_fit();
}

void LineSpans::cut_below(double k) {
  std::vector<LineCrossing> kept;
  int read = 0;
  for (int l = 0; l < line_count(); ++l) {
    int const end = begin_[l + 1];
    begin_[l] = static_cast<int>(kept.size());
    bool const is_flat = along_ != 2;
    bool const is_below = is_flat && place(l, 0).z < k;
    for (; read + 1 < end; read += 2) {
      LineCrossing in = crossings_[read];
      LineCrossing const out = crossings_[read + 1];
      if (is_below || (!is_flat && out.at <= k)) continue;
      if (!is_flat && in.at < k) in = {k, -1};
      kept.push_back(in);
      kept.push_back(out);
    }
    read = end;
  }
  begin_.back() = static_cast<int>(kept.size());
  crossings_ = std::move(kept);
}

}  // namespace inkflate
