// SPDX-License-Identifier: Apache-2.0
#include "inflate/shape_joints.h"

#include <algorithm>

#include "inflate/raise_sheets.h"
#include "inflate/seam_distance.h"

namespace inkflate {
namespace {

// The surface is smoothed up to this share of the limb's width from the seam.
constexpr double kReachShare = 0.45;
constexpr int kPasses = 30;
constexpr double kStep = 0.5;  // of the way to the neighbours' mean; stable up to 1

double fade(double t) { return t >= 1 ? 0 : (1 - t) * (1 - t) * (1 + 2 * t); }

/// How strongly each vertex of the model is smoothed, 0 .. 1.
class Zone {
 public:
  explicit Zone(FlatModel const& model)
      : model_(model), vertices_(sheet_vertices(model)), strength_(model.vertex_count, 0) {
    for (auto const& joint : model.joints) {
      std::vector<Vec2> line;
      for (int const v : joint.limb_vertices)
        line.push_back(model.layers[joint.limb].mesh.points[v]);
      for (auto const side : {Side::Front, Side::Back}) {
        add(joint.limb, side, line);
        if (joint.kind == Joint::Kind::Mouth || joint.side == side) add(joint.host, side, line);
      }
    }
  }

  std::vector<double> const& strength() const { return strength_; }

 private:
  void add(int layer, Side side, std::vector<Vec2> const& line) {
    double const reach_px = kReachShare * distance(line.front(), line.back());
    auto const& sheet = model_.layers[layer].sheets[static_cast<int>(side)];
    auto const& mesh = model_.layers[layer].mesh;
    // By triangles, not by points: both lips of a slit have to be found.
    for (std::size_t t = 0; t < sheet.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        auto const p = mesh.points[mesh.triangles[t][k]];
        double const away = nearest_on_seam(line, p).distance_px / reach_px;
        auto& strength = strength_[sheet[t][k]];
        strength = std::max(strength, fade(away));
      }
    }
  }

  FlatModel const& model_;
  std::vector<SheetVertices> vertices_;
  std::vector<double> strength_;
};

struct Neighbour {
  int vertex = 0;
  int next = 0;
};

}  // namespace

void shape_joints(FlatModel const& model, std::span<Triangle const> triangles,
                  std::vector<Vec3>& points) {
  if (model.joints.empty()) return;
  auto const strength = Zone(model).strength();
  // Every edge of a closed mesh comes once in each direction, so each neighbour is counted once.
  std::vector<std::pair<int, int>> edges;
  for (auto const& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      if (strength[t[k]] > 0) edges.emplace_back(t[k], t[(k + 1) % 3]);
    }
  }
  std::sort(edges.begin(), edges.end());
  for (int pass = 0; pass < kPasses; ++pass) {
    auto next = points;
    for (std::size_t first = 0; first < edges.size();) {
      int const v = edges[first].first;
      Vec3 sum;
      std::size_t end = first;
      for (; end < edges.size() && edges[end].first == v; ++end) sum += points[edges[end].second];
      auto const mean = sum / static_cast<double>(end - first);
      next[v] += (mean - points[v]) * (kStep * strength[v]);
      first = end;
    }
    points = std::move(next);
  }
}

}  // namespace inkflate
