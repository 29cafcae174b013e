// SPDX-License-Identifier: Apache-2.0
#include "deform/wire_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "deform/wire_solver.h"
#include "deform/wire_strip.h"
#include "support/extremes.h"
#include "support/wire_strips.h"

namespace inkflate {
namespace {

using namespace support;

/// The solution of a dense system, by elimination.
std::vector<Vec2> solved(std::vector<std::vector<double>> matrix, std::vector<Vec2> values) {
  auto const count = values.size();
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < count; ++i)
      if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k])) pivot = i;
    std::swap(matrix[k], matrix[pivot]);
    std::swap(values[k], values[pivot]);
    for (std::size_t i = 0; i < count; ++i) {
      if (i == k) continue;
      double const factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < count; ++j) matrix[i][j] -= factor * matrix[k][j];
      values[i] -= values[k] * factor;
    }
  }
  for (std::size_t k = 0; k < count; ++k) values[k] = values[k] / matrix[k][k];
  return values;
}

/// The first iteration from the rest pose, where all rotations are none, by a dense system with Lagrange multipliers.
BendPose first_by_elimination(BendMesh const& mesh, BendHold const& hold) {
  auto const vertices = mesh.rest.points.size();
  auto const fixed =
      static_cast<std::size_t>(std::count(hold.is_fixed.begin(), hold.is_fixed.end(), char{1}));
  auto const size = vertices + hold.handles.size() + fixed;
  std::vector<std::vector<double>> matrix(size, std::vector<double>(size, 0));
  std::vector<Vec2> values(size);
  for (auto const& [a, b, weight, rest] : wire_edges(mesh)) {
    matrix[a][a] += weight;
    matrix[b][b] += weight;
    matrix[a][b] -= weight;
    matrix[b][a] -= weight;
  }
  std::size_t row = vertices;
  for (auto const& handle : hold.handles) {
    for (int k = 0; k < 3; ++k) {
      int const v = mesh.rest.triangles[handle.anchor.triangle][k];
      matrix[row][v] = matrix[v][row] = handle.anchor.weights[k];
    }
    values[row++] = handle.target - at(handle.anchor, mesh, mesh.rest.points);
  }
  for (std::size_t v = 0; v < hold.is_fixed.size(); ++v) {
    if (hold.is_fixed[v] == 0) continue;
    matrix[row][v] = matrix[v][row] = 1;
    ++row;
  }
  auto pose = mesh.rest.points;
  auto const moves = solved(matrix, values);
  for (std::size_t v = 0; v < vertices; ++v) pose[v] += moves[v];
  return pose;
}

TEST(WireSystem, EqualsDirectElimination) {
  auto const mesh = bean_strip();
  std::vector<char> is_fixed(mesh.rest.points.size(), 0);
  for (int v = 0; v < 10; ++v) is_fixed[v] = is_fixed[v + 40] = 1;
  auto const handles = three_handles(mesh);
  auto const without_first = std::span(handles).subspan(1);
  for (BendHold const& hold : {BendHold{handles, {}}, BendHold{without_first, is_fixed}}) {
    WireSolver solver(mesh);
    auto pose = mesh.rest.points;
    solver.step(pose, hold, 1);
    EXPECT_LT(largest_distance(pose, first_by_elimination(mesh, hold)), 1e-8);
  }
}

TEST(WireSystem, MeetsHandlesExactly) {
  auto const mesh = bean_strip();
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  auto handles = three_handles(mesh);
  handles.push_back({{50, {1, 0, 0}}, {300, 300}});
  handles.push_back({{90, {-0.2, 0.7, 0.5}}, {-300, 10}});
  solver.step(pose, {handles, {}}, 3);
  for (auto const& handle : handles)
    EXPECT_LT(distance(at(handle.anchor, mesh, pose), handle.target), 1e-8);
}

TEST(WireSystem, AHandleAddedAndRemovedIsNothing) {
  auto const mesh = bean_strip();
  WireSolver solver(mesh);
  WireSolver other(mesh);
  auto const handles = three_handles(mesh);
  std::vector<BendHandle> const more = {handles[0], moved(mesh, 90, {9, 9}), handles[2]};
  auto pose = mesh.rest.points;
  solver.step(pose, {more, {}}, 3);
  solver.step(pose, {handles, {}}, 1);
  pose = mesh.rest.points;
  auto same = pose;
  solver.step(pose, {handles, {}}, 10);
  other.step(same, {handles, {}}, 10);
  EXPECT_EQ(pose, same);
}

TEST(WireSystem, WhatIsFixedStaysToTheBit) {
  auto const mesh = bean_strip();
  WireSolver solver(mesh);
  std::vector<char> is_fixed(mesh.rest.points.size(), 0);
  for (std::size_t v = 0; v < 20; ++v) is_fixed[v] = is_fixed[v + 40] = is_fixed[v + 80] = 1;
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {moved(mesh, 30, {50, -20})};
  solver.step(pose, {handles, is_fixed}, 50);
  double moved_px = 0;
  for (std::size_t v = 0; v < pose.size(); ++v) {
    if (is_fixed[v] != 0) {
      EXPECT_EQ(pose[v], mesh.rest.points[v]);
    }
    moved_px = support::larger(moved_px, distance(pose[v], mesh.rest.points[v]));
  }
  EXPECT_GT(moved_px, 40);
  EXPECT_LT(distance(at(handles[0].anchor, mesh, pose), handles[0].target), 1e-8);
}

TEST(WireSystem, AHandleInsideOfWhatIsFixedDoesNotCount) {
  auto const mesh = bean_strip();
  WireSolver solver(mesh);
  std::vector<char> const is_fixed(mesh.rest.points.size(), 1);
  auto pose = mesh.rest.points;
  solver.step(pose, {three_handles(mesh), is_fixed}, 5);
  EXPECT_EQ(pose, mesh.rest.points);
}

TEST(WireSystem, AStripWithoutAHandleStaysWhereItIs) {
  std::vector<Contour> const contours = {bean(40), bean(20, {400, 0})};
  auto const mesh = wire_strip(contours, 6);
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  solver.step(pose, {three_handles(mesh), {}}, 20);
  for (std::size_t v = 0; v < pose.size(); ++v) {
    bool const is_at_rest = pose[v] == mesh.rest.points[v];
    EXPECT_EQ(is_at_rest, v >= 120);
  }
}

TEST(WireSystem, EachOfSeveralStripsFollowsItsOwnHandles) {
  std::vector<Contour> const contours = {bean(40), bean(20, {400, 0})};
  auto const mesh = wire_strip(contours, 6);
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {moved(mesh, 0, {10, 0}), moved(mesh, 170, {0, 20})};
  solver.step(pose, {handles, {}}, 5);
  for (std::size_t v = 0; v < pose.size(); ++v)
    EXPECT_LT(distance(pose[v], mesh.rest.points[v] + (v < 120 ? Vec2{10, 0} : Vec2{0, 20})), 1e-9);
}

TEST(WireSystem, OfHandlesAtOnePlaceTheLastCounts) {
  auto const mesh = bean_strip();
  WireSolver solver(mesh);
  auto handles = three_handles(mesh);
  auto again = handles[1];
  again.target += {7, 7};
  handles.push_back(again);
  // The same corner of two triangles.
  int const corner = mesh.rest.triangles[60][0];
  handles.push_back({{60, {1, 0, 0}}, {0, 0}});
  for (int t = 0; t < 60; ++t) {
    auto const& corners = mesh.rest.triangles[t];
    for (int k = 0; k < 3; ++k) {
      if (corners[k] != corner) continue;
      BendHandle other = {{t, {0, 0, 0}}, {5, 5}};
      other.anchor.weights[k] = 1;
      handles.push_back(other);
    }
  }
  ASSERT_GT(handles.size(), 5U);
  auto pose = mesh.rest.points;
  solver.step(pose, {handles, {}}, 5);
  EXPECT_LT(distance(at(again.anchor, mesh, pose), again.target), 1e-8);
  EXPECT_LT(distance(pose[corner], {5, 5}), 1e-8);
}

}  // namespace
}  // namespace inkflate
