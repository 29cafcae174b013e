// SPDX-License-Identifier: Apache-2.0
#include "assemble/stitch.h"

#include <algorithm>
#include <map>
#include <utility>

#include "mesh/triangles_at.h"

namespace inkflate {
namespace {

Side other(Side side) { return side == Side::Front ? Side::Back : Side::Front; }
int index_of(Side side) { return static_cast<int>(side); }

/// Sets of names that turn out to mean the same vertex.
class Names {
 public:
  int fresh() {
    parents_.push_back(static_cast<int>(std::ssize(parents_)));
    return parents_.back();
  }
  int find(int name) {
    while (parents_[name] != name) name = parents_[name] = parents_[parents_[name]];
    return name;
  }
  void unite(int a, int b) {
    a = find(a);
    b = find(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parents_;
};

/// A layer while its vertices are being named.
struct NamedLayer {
  std::array<std::vector<int>, 2> of_point;  // per side: point -> name
  std::array<std::map<std::pair<int, int>, int>, 2>
      cut;  // per side: (triangle, point) -> name of the lip under a limb
};

/// The triangles around each point of a mesh.
class Fans {
 public:
  explicit Fans(FlatMesh const& mesh) : mesh_(mesh), triangles_(mesh) {}

  /// The triangle in which `to` follows `from`; -1: none.
  int with_edge(int from, int to) const {
    for (int const t : triangles_[from]) {
      if (after(t, from) == to) return t;
    }
    return -1;
  }
  int after(int triangle, int v) const { return corner(triangle, v, 1); }
  int before(int triangle, int v) const { return corner(triangle, v, 2); }

 private:
  int corner(int triangle, int v, int step) const {
    auto const& corners = mesh_.triangles[triangle];
    int const k = static_cast<int>(std::find(corners.begin(), corners.end(), v) - corners.begin());
    return corners[(k + step) % 3];
  }

  FlatMesh const& mesh_;
  TrianglesAt triangles_;
};

class Stitcher {
 public:
  Stitcher(MeshedLayers layers, OpenRuns open) : input_(std::move(layers)), open_(open) {}

  FlatModel run() && {
    for (auto const& layer : input_.layers) name_points(layer);
    for (auto const& joint : input_.joints) {
      if (joint.kind == Joint::Kind::Slit) {
        join_slit(joint);
      } else {
        join_mouth(joint);
      }
    }
    FlatModel model;
    number_sheets();
    if (open_ != OpenRuns::Holes) {
      for (auto const& rim : input_.open_rims) add_cap(rim, model);
    }
    model.layers = std::move(input_.layers);
    model.joints = std::move(input_.joints);
    model.vertex_count = vertex_count_;
    return model;
  }

 private:
  void name_points(FlatLayer const& layer) {
    NamedLayer named;
    for (auto const kind : layer.kinds) {
      int const front = names_.fresh();
      named.of_point[0].push_back(front);
      named.of_point[1].push_back(kind == VertexKind::Drawn ? front : names_.fresh());
    }
    named_.push_back(std::move(named));
  }

  int name(int layer, Side side, int point) const {
    return named_[layer].of_point[index_of(side)][point];
  }

  void join_mouth(Joint const& joint) {
    for (std::size_t k = 0; k < joint.limb_vertices.size(); ++k) {
      for (auto const side : {Side::Front, Side::Back}) {
        names_.unite(name(joint.limb, side, joint.limb_vertices[k]),
                     name(joint.host, side, joint.host_vertices[k]));
      }
    }
  }

  void join_slit(Joint const& joint) {
    Fans const fans(input_.layers[joint.host].mesh);
    auto const& seam = joint.host_vertices;
    for (std::size_t k = 0; k < seam.size(); ++k) {
      int const limb = joint.limb_vertices[k];
      names_.unite(name(joint.limb, joint.side, limb), name(joint.host, joint.side, seam[k]));
      if (k == 0 || k + 1 == seam.size()) continue;
      int const under = names_.fresh();
      names_.unite(name(joint.limb, other(joint.side), limb), under);
      // The limb lies on the side where triangles follow the seam's direction.
      auto& cut = named_[joint.host].cut[index_of(joint.side)];
      int triangle = fans.with_edge(seam[k], seam[k + 1]);
      while (triangle >= 0) {
        cut[{triangle, seam[k]}] = under;
        int const next = fans.before(triangle, seam[k]);
        if (next == seam[k - 1]) break;
        triangle = fans.with_edge(seam[k], next);
      }
    }
  }

  int number(int a_name) {
    int const root = names_.find(a_name);
    auto const [entry, is_new] = numbers_.try_emplace(root, vertex_count_);
    if (is_new) ++vertex_count_;
    return entry->second;
  }

  void number_sheets() {
    for (std::size_t i = 0; i < input_.layers.size(); ++i) {
      auto& layer = input_.layers[i];
      for (int side = 0; side < 2; ++side) {
        auto& sheet = layer.sheets[side];
        auto const& cut = named_[i].cut[side];
        for (int t = 0; t < static_cast<int>(std::ssize(layer.mesh.triangles)); ++t) {
          Triangle corners = layer.mesh.triangles[t];
          for (int& v : corners) {
            auto const lip = cut.empty() ? cut.end() : cut.find({t, v});
            v = number(lip != cut.end() ? lip->second : named_[i].of_point[side][v]);
          }
          sheet.push_back(corners);
        }
      }
    }
  }

  bool is_joined(OpenRim const& rim) const {
    return std::any_of(input_.joints.begin(), input_.joints.end(), [&](Joint const& joint) {
      auto const is_run = [&](int layer, std::vector<int> const& vertices) {
        return layer == rim.layer && vertices[1] == rim.vertices[1];
      };
      bool const is_host = joint.kind == Joint::Kind::Mouth && joint.host == rim.layer &&
                           joint.host_vertices[joint.host_vertices.size() - 2] == rim.vertices[1];
      return is_run(joint.limb, joint.limb_vertices) || is_host;
    });
  }

  void add_cap(OpenRim const& rim, FlatModel& model) {
    if (is_joined(rim)) return;
    auto const front = [&](std::size_t k) {
      return number(name(rim.layer, Side::Front, rim.vertices[k]));
    };
    auto const back = [&](std::size_t k) {
      return number(name(rim.layer, Side::Back, rim.vertices[k]));
    };
    Face const face = {rim.layer, Side::Front};
    for (std::size_t k = 0; k + 1 < rim.vertices.size(); ++k) {
      // At the run's ends front and back are one vertex and one triangle is enough.
      if (k + 2 < rim.vertices.size()) {
        model.caps.push_back({{front(k), front(k + 1), back(k + 1)}, face});
      }
      if (k > 0) model.caps.push_back({{front(k), back(k + 1), back(k)}, face});
    }
  }

  MeshedLayers input_;
  OpenRuns open_;
  Names names_;
  std::vector<NamedLayer> named_;
  std::map<int, int> numbers_;
  int vertex_count_ = 0;
};

}  // namespace

FlatModel stitch(MeshedLayers layers, OpenRuns open) {
  return Stitcher(std::move(layers), open).run();
}

}  // namespace inkflate
