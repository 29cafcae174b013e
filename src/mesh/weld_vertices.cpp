// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "mesh/check_mesh.h"

namespace inkflate {
namespace {

/// A point by the bits of its coordinates, which have an order even where they are not numbers; -0 is 0.
struct Place {
  std::array<std::uint64_t, 3> bits;
  int vertex;

  friend bool operator<(Place const& a, Place const& b) {
    return a.bits != b.bits ? a.bits < b.bits : a.vertex < b.vertex;
  }
};

std::uint64_t bits_of(double number) {
  double const clean = number + 0.0;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &clean, sizeof bits);
  return bits;
}

/// For each vertex the first one at its place.
std::vector<int> first_at_place(std::vector<Vec3> const& points) {
  std::vector<Place> places;
  places.reserve(points.size());
  for (int v = 0; v < std::ssize(points); ++v)
    places.push_back({{bits_of(points[v].x), bits_of(points[v].y), bits_of(points[v].z)}, v});
  std::sort(places.begin(), places.end());
  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    bool const is_same = i > 0 && places[i].bits == places[i - 1].bits;
    first[places[i].vertex] = is_same ? first[places[i - 1].vertex] : places[i].vertex;
  }
  return first;
}

}  // namespace

TriMesh weld_vertices(TriMesh const& mesh) {
  auto const first = first_at_place(mesh.points);
  auto const is_named = [&](int v) { return v >= 0 && v < std::ssize(mesh.points); };
  std::vector<int> names(mesh.points.size(), -1);
  for (auto const& t : mesh.triangles) {
    for (int const v : t) {
      if (is_named(v)) names[first[v]] = 0;
    }
  }
  TriMesh result;
  for (int v = 0; v < std::ssize(mesh.points); ++v) {
    if (names[v] < 0) continue;
    names[v] = static_cast<int>(result.points.size());
    result.points.push_back(mesh.points[v]);
  }
  result.triangles = mesh.triangles;
  for (auto& t : result.triangles) {
    for (int& v : t) v = is_named(v) ? names[first[v]] : -1;
  }
  return result;
}

}  // namespace inkflate
