// SPDX-License-Identifier: Apache-2.0
#include "inflate/raise_sheets.h"

#include <algorithm>

#include "inflate/fade.h"
#include "inflate/seam_distance.h"

namespace inkflate {
namespace {

// The host's sheet follows a limb over this share of the limb's width.
constexpr double kReachShare = 0.7;

double sign_of(Side side) { return side == Side::Front ? 1 : -1; }
int index_of(Side side) { return static_cast<int>(side); }
Side other(Side side) { return side == Side::Front ? Side::Back : Side::Front; }

class Raiser {
 public:
  Raiser(FlatModel const& model, std::span<std::vector<double> const> heights,
         std::span<std::vector<double> const> depths)
      : model_(model), heights_(heights), depths_(depths), vertices_(sheet_vertices(model)) {}

  std::vector<Vec3> run() && {
    points_.resize(model_.vertex_count);
    for (int i = 0; i < static_cast<int>(std::ssize(model_.layers)); ++i) {
      raise(i, Side::Front);
      raise(i, Side::Back);
    }
    // What a joint does to its host is seen from the host as it was, so that the order of joints does not matter.
    for (auto const& joint : model_.joints) {
      if (joint.kind == Joint::Kind::Slit) pull_host(joint);
    }
    for (auto const& joint : model_.joints) set_lips(joint);
    return std::move(points_);
  }

 private:
  double z(int layer, Side side, int point) const {
    return depths_[layer][point] + sign_of(side) * heights_[layer][point];
  }

  void raise(int i, Side side) {
    auto const& layer = model_.layers[i];
    auto const& sheet = layer.sheets[index_of(side)];
    for (std::size_t t = 0; t < sheet.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        int const point = layer.mesh.triangles[t][k];
        auto const p = layer.mesh.points[point];
        points_[sheet[t][k]] = {p.x, p.y, z(i, side, point)};
      }
    }
  }

  void pull_host(Joint const& joint) {
    auto const& host = model_.layers[joint.host];
    auto const& limb = model_.layers[joint.limb];
    std::vector<Vec2> line;
    std::array<std::vector<double>, 2> pulls;  // away from the limb, under the limb
    for (std::size_t k = 0; k < joint.limb_vertices.size(); ++k) {
      line.push_back(limb.mesh.points[joint.limb_vertices[k]]);
      double const at_host = z(joint.host, joint.side, joint.host_vertices[k]);
      pulls[0].push_back(z(joint.limb, joint.side, joint.limb_vertices[k]) - at_host);
      pulls[1].push_back(z(joint.limb, other(joint.side), joint.limb_vertices[k]) - at_host);
    }
    double const reach_px = kReachShare * distance(line.front(), line.back());
    auto const& of_point = vertices_[joint.host].of_point[index_of(joint.side)];
    for (std::size_t v = 0; v < host.mesh.points.size(); ++v) {
      if (host.kinds[v] != VertexKind::Inside || of_point[v] < 0) continue;
      auto const place = nearest_on_seam(line, host.mesh.points[v]);
      if (place.distance_px >= reach_px || place.distance_px == 0) continue;
      auto const& pull = pulls[place.side > 0 ? 1 : 0];
      double const full =
          pull[place.edge] + (pull[place.edge + 1] - pull[place.edge]) * place.share;
      points_[of_point[v]].z += full * fade(place.distance_px / reach_px);
    }
  }

  void set_lips(Joint const& joint) {
    int const last = static_cast<int>(std::ssize(joint.limb_vertices)) - 1;
    for (int k = 0; k <= last; ++k) {
      int const point = joint.limb_vertices[k];
      for (auto const side : {Side::Front, Side::Back}) {
        double const own = z(joint.limb, side, point);
        // A mouth lies half-way between its two limbs, and so does the end of a slit between limb and host.
        auto const host_side = joint.kind == Joint::Kind::Slit ? joint.side : side;
        bool const is_shared = joint.kind == Joint::Kind::Mouth || k == 0 || k == last;
        double const met = z(joint.host, host_side, joint.host_vertices[k]);
        points_[vertices_[joint.limb].of_point[index_of(side)][point]].z =
            is_shared ? (own + met) / 2 : own;
      }
    }
  }

  FlatModel const& model_;
  std::span<std::vector<double> const> heights_;
  std::span<std::vector<double> const> depths_;
  std::vector<SheetVertices> vertices_;
  std::vector<Vec3> points_;
};

}  // namespace

std::vector<SheetVertices> sheet_vertices(FlatModel const& model) {
  std::vector<SheetVertices> result;
  for (auto const& layer : model.layers) {
    SheetVertices vertices;
    for (int side = 0; side < 2; ++side) {
      auto& of_point = vertices.of_point[side];
      of_point.assign(layer.mesh.points.size(), -1);
      for (std::size_t t = 0; t < layer.sheets[side].size(); ++t) {
        for (int k = 0; k < 3; ++k) of_point[layer.mesh.triangles[t][k]] = layer.sheets[side][t][k];
      }
    }
    result.push_back(std::move(vertices));
  }
  return result;
}

std::vector<Vec3> raise_sheets(FlatModel const& model, std::span<std::vector<double> const> heights,
                               std::span<std::vector<double> const> depths) {
  return Raiser(model, heights, depths).run();
}

}  // namespace inkflate
