// SPDX-License-Identifier: Apache-2.0
#include "inflate/shape_joints.h"

#include <algorithm>
#include <utility>

#include "inflate/fade.h"
#include "inflate/seam_distance.h"
#include "inflate/unfold.h"

namespace inkflate {
namespace {

// How far from the seam the surface is smoothed, of the limb's width: so that a shoulder forms. Less of the limb would draw it together less,
// but leave a step in its outline where the smoothing ends.
constexpr double kReach = 0.8;

// Chosen by the largest angle between faces at the ends of seams: 44 degrees after 30 passes, 23 after 80, 20 after 100.
constexpr int kPasses = 100;
constexpr double kStep = 0.5;  // of the way to the neighbours' mean; stable up to 1

/// Where it is smoothed, and how strongly.
struct Zone {
  std::vector<int> vertices;      // of the model, ascending
  std::vector<double> strengths;  // 0 .. 1, one for each of them
};

Zone zone_of(FlatModel const& model) {
  std::vector<double> strength(model.vertex_count, 0);
  auto const add = [&](int layer, Side side, std::vector<Vec2> const& line, bool is_host) {
    double const reach_px = kReach * distance(line.front(), line.back());
    auto const& sheet = model.layers[layer].sheets[static_cast<int>(side)];
    auto const& mesh = model.layers[layer].mesh;
    std::vector<double> of_point;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      // The host's outline stays as it was drawn.
      bool const is_fixed = is_host && model.layers[layer].kinds[v] == VertexKind::Drawn;
      double const away = nearest_on_seam(line, mesh.points[v]).distance_px / reach_px;
      of_point.push_back(is_fixed ? 0 : fade(away));
    }
    // By triangles, so that both lips of a slit are found.
    for (std::size_t t = 0; t < sheet.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        auto& own = strength[sheet[t][k]];
        own = std::max(own, of_point[mesh.triangles[t][k]]);
      }
    }
  };
  for (auto const& joint : model.joints) {
    std::vector<Vec2> line;
    for (int const v : joint.limb_vertices) line.push_back(model.layers[joint.limb].mesh.points[v]);
    bool const is_mouth = joint.kind == Joint::Kind::Mouth;
    for (auto const side : {Side::Front, Side::Back}) {
      add(joint.limb, side, line, false);
      if (is_mouth) add(joint.host, side, line, false);
    }
    if (!is_mouth) add(joint.host, joint.side, line, true);
  }
  Zone zone;
  for (int v = 0; v < model.vertex_count; ++v) {
    if (strength[v] <= 0) continue;
    zone.vertices.push_back(v);
    zone.strengths.push_back(strength[v]);
  }
  return zone;
}

/// The zone's vertices and those around it, numbered anew, with the neighbours of the former.
struct Patch {
  std::vector<int> vertices;    // of the model; those of the zone first
  std::vector<int> starts;      // into neighbours, per vertex of the zone, and the end
  std::vector<int> neighbours;  // of the patch
};

Patch patch_of(Zone const& zone, std::span<Triangle const> triangles, int vertex_count) {
  std::vector<int> number(vertex_count, -1);
  Patch patch;
  auto const number_of = [&](int v) {
    if (number[v] < 0) {
      number[v] = static_cast<int>(std::ssize(patch.vertices));
      patch.vertices.push_back(v);
    }
    return number[v];
  };
  for (int const v : zone.vertices) number_of(v);
  int const inner = static_cast<int>(std::ssize(zone.vertices));
  // An edge of a closed surface comes once in each direction, so each neighbour is counted once.
  std::vector<std::pair<int, int>> edges;
  for (auto const& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      int const from = number[t[k]];
      if (from >= 0 && from < inner) edges.emplace_back(from, number_of(t[(k + 1) % 3]));
    }
  }
  patch.starts.assign(inner + 1, 0);
  for (auto const& edge : edges) ++patch.starts[edge.first + 1];
  for (int v = 0; v < inner; ++v) patch.starts[v + 1] += patch.starts[v];
  patch.neighbours.resize(edges.size());
  auto next = patch.starts;
  for (auto const& [from, to] : edges) patch.neighbours[next[from]++] = to;
  return patch;
}

}  // namespace

void shape_joints(FlatModel const& model, std::span<Triangle const> triangles,
                  std::vector<Vec3>& points) {
  if (model.joints.empty()) return;
  auto const zone = zone_of(model);
  auto const patch = patch_of(zone, triangles, model.vertex_count);
  std::vector<Vec3> now;
  for (int const v : patch.vertices) now.push_back(points[v]);
  auto next = now;
  for (int pass = 0; pass < kPasses; ++pass) {
    for (std::size_t v = 0; v < zone.vertices.size(); ++v) {
      Vec3 sum;
      int const begin = patch.starts[v];
      int const end = patch.starts[v + 1];
      for (int k = begin; k < end; ++k) sum += now[patch.neighbours[k]];
      auto const mean = sum / static_cast<double>(end - begin);
      next[v] = now[v] + (mean - now[v]) * (kStep * zone.strengths[v]);
    }
    std::swap(now, next);
  }
  std::vector<bool> is_movable(points.size(), false);
  for (std::size_t v = 0; v < zone.vertices.size(); ++v) {
    // So many passes draw in whole what has only a little strength: taken as it is, the zone would end in a step around the limb.
    auto& point = points[zone.vertices[v]];
    point += (now[v] - point) * zone.strengths[v];
    is_movable[zone.vertices[v]] = true;
  }
  unfold(triangles, is_movable, points);
}

}  // namespace inkflate
