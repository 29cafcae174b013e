// SPDX-License-Identifier: Apache-2.0
#include "image/fill_polygon.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace inkflate {
namespace {

struct Edge {
  Vec2 top;
  Vec2 bottom;
  int turn = 0;       // 1 for one that runs down, -1 for one that runs up
  int first_row = 0;  // the rows whose centres the edge crosses: first_row ... end_row - 1
  int end_row = 0;
};

/// Where an edge crosses the centres of a row.
struct RowCrossing {
  double x = 0;
  int turn = 0;
};

/// The index of the first pixel of 0 ... size whose centre is not before the coordinate.
int first_centre_from(double coordinate, int size) {
  return static_cast<int>(std::clamp(std::ceil(coordinate - 0.5), 0.0, static_cast<double>(size)));
}

std::vector<Edge> edges_by_row(std::span<Contour const> contours, int height) {
  std::vector<Edge> edges;
  for (auto const& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      auto top = contour[i];
      auto bottom = contour[(i + 1) % contour.size()];
      int const turn = top.y > bottom.y ? -1 : 1;
      if (turn < 0) std::swap(top, bottom);
      Edge const edge = {top, bottom, turn, first_centre_from(top.y, height),
                         first_centre_from(bottom.y, height)};
      if (edge.first_row < edge.end_row) edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](Edge const& a, Edge const& b) { return a.first_row < b.first_row; });
  return edges;
}

}  // namespace

void fill_polygon(std::span<Contour const> contours, Mask& mask, std::uint8_t value) {
  auto const edges = edges_by_row(contours, mask.height);
  std::vector<Edge> active;
  std::vector<RowCrossing> crossings;
  std::size_t next = 0;
  for (int row = 0; row < mask.height; ++row) {
    active.erase(std::remove_if(active.begin(), active.end(),
                                [&](Edge const& edge) { return edge.end_row <= row; }),
                 active.end());
    for (; next < edges.size() && edges[next].first_row == row; ++next) {
      active.push_back(edges[next]);
    }
    crossings.clear();
    for (auto const& [top, bottom, turn, first_row, end_row] : active) {
      crossings.push_back(
          {top.x + (row + 0.5 - top.y) * (bottom.x - top.x) / (bottom.y - top.y), turn});
    }
    std::sort(crossings.begin(), crossings.end(),
              [](RowCrossing const& a, RowCrossing const& b) { return a.x < b.x; });
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      winding += crossings[i].turn;
      if (winding == 0) continue;
      int const end = first_centre_from(crossings[i + 1].x, mask.width);
      for (int x = first_centre_from(crossings[i].x, mask.width); x < end; ++x) {
        mask.at(x, row) = value;
      }
    }
  }
}

}  // namespace inkflate
