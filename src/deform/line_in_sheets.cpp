// SPDX-License-Identifier: Apache-2.0
#include "deform/line_in_sheets.h"

#include <algorithm>

namespace inkflate {

std::vector<std::optional<MeshPlace>> line_in_sheets(ShapeMesh const& shape,
                                                     TriangleGrid const& triangles,
                                                     std::span<Vec2 const> line) {
  auto const sheet_of = [&](MeshPlace const& place) { return shape.sheets[place.triangle]; };
  std::vector<std::vector<MeshPlace>> held;
  for (Vec2 const point : line) held.push_back(triangles.find_all(point));
  // Ascending, as the triangles are.
  auto const is_in_one = [&](std::vector<MeshPlace> const& places) {
    return !places.empty() && sheet_of(places.front()) == sheet_of(places.back());
  };
  std::vector<std::optional<MeshPlace>> result(line.size());
  auto const follow = [&](std::size_t k, int sheet) {
    auto const& places = held[k];
    if (places.empty()) return sheet;
    auto const same = std::find_if(places.begin(), places.end(), [&](MeshPlace const& place) {
      return sheet_of(place) == sheet;
    });
    result[k] = same != places.end() ? *same : places.front();
    return sheet_of(*result[k]);
  };
  auto const sure = std::find_if(held.begin(), held.end(), is_in_one);
  auto const start = sure == held.end() ? 0 : static_cast<std::size_t>(sure - held.begin());
  int sheet = -1;
  for (std::size_t k = start; k < line.size(); ++k) sheet = follow(k, sheet);
  sheet = start < line.size() && result[start] ? sheet_of(*result[start]) : -1;
  for (std::size_t k = start; k-- > 0;) sheet = follow(k, sheet);
  return result;
}

}  // namespace inkflate
