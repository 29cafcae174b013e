// SPDX-License-Identifier: Apache-2.0
#include "assemble/mesh_layers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "assemble/sample_rims.h"
#include "mesh/mesh_region.h"

namespace inkflate {
namespace {

// Edges deep inside a layer, in units.
constexpr double kLongestInside = 18;

/// The seams of one host: duplicates on its two sides share one.
struct HostSeams {
  std::vector<Polyline> lines;
  std::vector<int> of_joint;  // per planned joint its line; -1: on another host

  int add(Polyline const& line) {
    auto const found = std::find(lines.begin(), lines.end(), line);
    int const index = static_cast<int>(found - lines.begin());
    if (found == lines.end()) lines.push_back(line);
    return index;
  }
};

class Mesher {
 public:
  Mesher(std::span<LayerRim const> rims, std::span<PlannedJoint const> plan, double unit_px,
         double density)
      : rims_(rims), plan_(plan), sampled_(sample_rims(rims, plan, unit_px, density)) {
    options_.longest_px = kLongestInside * unit_px / std::sqrt(density);
  }

  Result<MeshedLayers> run() && {
    std::vector<HostSeams> seams(rims_.size());
    for (auto& each : seams) each.of_joint.assign(plan_.size(), -1);
    for (std::size_t j = 0; j < plan_.size(); ++j) {
      auto const& joint = plan_[j];
      if (joint.host_run >= 0) continue;
      auto& own = seams[joint.host];
      own.of_joint[j] = own.add(sampled_[joint.limb].runs[joint.run]);
    }
    for (std::size_t i = 0; i < rims_.size(); ++i) {
      auto meshed = mesh_region({sampled_[i].contours(), seams[i].lines}, options_);
      if (!meshed) {
        auto error = meshed.error();
        error.index = static_cast<long long>(i);
        return error;
      }
      meshes_.push_back(std::move(*meshed));
      add_layer(static_cast<int>(i));
    }
    for (std::size_t j = 0; j < plan_.size(); ++j)
      add_joint(plan_[j], seams[plan_[j].host].of_joint[j]);
    return std::move(result_);
  }

 private:
  void add_layer(int i) {
    auto const& meshed = meshes_[i];
    FlatLayer layer;
    layer.mesh = meshed.mesh;
    layer.kinds.assign(layer.mesh.points.size(), VertexKind::Inside);
    for (auto const& contour : meshed.contours) {
      for (int const v : contour) layer.kinds[v] = VertexKind::Drawn;
    }
    for (int r = 0; r < static_cast<int>(std::ssize(rims_[i].runs)); ++r) {
      if (rims_[i].runs[r].opening == Opening::None) continue;
      auto const vertices = run_vertices(i, r);
      for (std::size_t k = 1; k + 1 < vertices.size(); ++k)
        layer.kinds[vertices[k]] = VertexKind::Open;
      result_.open_rims.push_back({i, r, vertices});
    }
    result_.layers.push_back(std::move(layer));
  }

  std::vector<int> run_vertices(int layer, int run) const {
    auto const& contour = meshes_[layer].contours.front();
    auto const& runs = sampled_[layer].runs;
    std::size_t first = 0;
    for (int r = 0; r < run; ++r) first += runs[r].size() - 1;
    std::vector<int> vertices;
    for (std::size_t k = 0; k < runs[run].size(); ++k) {
      vertices.push_back(contour[(first + k) % contour.size()]);
    }
    return vertices;
  }

  void add_joint(PlannedJoint const& planned, int seam) {
    Joint joint = {planned.limb,
                   planned.host,
                   Joint::Kind::Slit,
                   planned.side,
                   run_vertices(planned.limb, planned.run),
                   {}};
    if (planned.host_run >= 0) {
      joint.kind = Joint::Kind::Mouth;
      joint.host_vertices = run_vertices(planned.host, planned.host_run);
      std::reverse(joint.host_vertices.begin(), joint.host_vertices.end());
    } else {
      joint.host_vertices = meshes_[planned.host].seams[seam];
    }
    result_.joints.push_back(std::move(joint));
  }

  std::span<LayerRim const> rims_;
  std::span<PlannedJoint const> plan_;
  std::vector<SampledRim> sampled_;
  MeshRegionOptions options_;
  std::vector<RegionMesh> meshes_;
  MeshedLayers result_;
};

}  // namespace

Result<MeshedLayers> mesh_layers(std::span<LayerRim const> rims, std::span<PlannedJoint const> plan,
                                 double unit_px, double density) {
  return Mesher(rims, plan, unit_px, density).run();
}

}  // namespace inkflate
