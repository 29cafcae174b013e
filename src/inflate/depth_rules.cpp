// SPDX-License-Identifier: Apache-2.0
#include "inflate/depth_rules.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "geometry/polyline.h"

namespace inkflate {
namespace {

/// Twice the distance from which rounding could swap two sheets on the screen or in a file of single precision.
constexpr double kMarginPx = 0.5;

/// Rims are looked at this often.
constexpr double kRimSpacingPx = 4;

/// How much softer the middle of a run is held than its ends. The ends are points of the limb's rim and of the host's sheet at once; between
/// them the limb may rise from the sheet where it would otherwise sink into the host's rim.
constexpr double kSoftMiddle = 0.01;

/// Where hundreds of layers lie on one another, only so many points are looked at, evenly.
constexpr double kMostLookups = 5e5;

/// Steeper than about 27 degrees a part looks torn off, and the more so the longer it is.
constexpr double kSteepest = 0.5;

/// Where a layer is held by a joint: the straight line between its run's ends.
struct Root {
  Vec2 from;
  Vec2 to;
};

/// Two layers that may overlap, and all joints that hold them somewhere.
struct Pair {
  int behind = 0;
  int before = 0;
  bool is_mouth = false;  // they meet at one
  std::vector<Root> roots;
  int group = 0;
};

Pair describe(FlatModel const& model, std::vector<std::vector<int>> const& joints, int behind,
              int before) {
  Pair pair = {behind, before, false, {}, 0};
  for (int const layer : {behind, before}) {
    for (int const i : joints[layer]) {
      auto const& joint = model.joints[i];
      bool const is_slit = joint.kind == Joint::Kind::Slit;
      auto const& points = model.layers[joint.limb].mesh.points;
      if (joint.limb == layer || !is_slit) {
        pair.roots.push_back(
            {points[joint.limb_vertices.front()], points[joint.limb_vertices.back()]});
      }
      if (std::minmax(joint.limb, joint.host) != std::minmax(behind, before)) continue;
      pair.is_mouth = pair.is_mouth || !is_slit;
      if (!is_slit) continue;
      // The sheet that a limb is joined to tells which of the two is before the other.
      pair.before = joint.side == Side::Front ? joint.limb : joint.host;
      pair.behind = joint.side == Side::Front ? joint.host : joint.limb;
    }
  }
  return pair;
}

/// 0 on the run of a joint, where a limb is held, and 1 from a run's length away from it.
double freedom(Pair const& pair, Vec2 p) {
  double least = 1;
  for (auto const& root : pair.roots) {
    double const reach = std::max(distance(root.from, root.to), 1e-9);
    least = std::min(least, std::sqrt(squared_distance_to_segment(p, root.from, root.to)) / reach);
  }
  return least;
}

/// The rule at p, which lies in both layers.
void add_rule_at(Pair const& pair, std::span<LayerShape const> shapes, Vec2 p, double behind_height,
                 double before_height, double weight, std::vector<DepthRule>& rules) {
  double const free = freedom(pair, p);
  // Two mouths that meet are at one depth: neither can be before the other.
  if (pair.is_mouth && free < 1) return;
  rules.push_back({shapes[pair.before].plate.depth(p), shapes[pair.behind].plate.depth(p),
                   std::abs(behind_height - before_height) + kMarginPx * free, weight, false,
                   pair.group});
}

/// How many points there are to look up in all pairs of layers.
double count_lookups(std::span<LayerShape const> shapes) {
  double count = 0;
  for (std::size_t j = 0; j < shapes.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (!touch(shapes[i].grid.box(), shapes[j].grid.box())) continue;
      count += static_cast<double>(shapes[i].mesh.points.size() + shapes[j].mesh.points.size());
    }
  }
  return count;
}

/// Looks up a layer's points and its drawn edges in another, one in `stride`. visit(p, own height, other's height)
template <typename Visit>
void for_each_common_point(LayerShape const& own, LayerShape const& other, int stride,
                           Visit visit) {
  int turn = 0;
  auto const look = [&](Vec2 p, double height) {
    if (++turn % stride != 0) return;
    if (auto const place = other.grid.find(p)) {
      visit(p, height, interpolate(other.mesh, other.heights, *place));
    }
  };
  for (std::size_t i = 0; i < own.mesh.points.size(); ++i) {
    if (own.kinds[i] != VertexKind::Open) look(own.mesh.points[i], own.heights[i]);
  }
  for (auto const& t : own.mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      int const a = t[k];
      int const b = t[(k + 1) % 3];
      if (own.kinds[a] != VertexKind::Drawn || own.kinds[b] != VertexKind::Drawn) continue;
      Vec2 const from = own.mesh.points[a];
      Vec2 const to = own.mesh.points[b];
      // A mesh much coarser than ours still gets a few points on each edge.
      int const pieces =
          static_cast<int>(std::ceil(std::min(distance(from, to) / kRimSpacingPx, 16.0)));
      for (int n = 1; n < pieces; ++n) look(lerp(from, to, static_cast<double>(n) / pieces), 0);
    }
  }
}

/// Along a slit: the middle of the limb lies on the host's sheet.
void add_slit_rules(Joint const& joint, std::span<LayerShape const> shapes, double weight,
                    std::vector<DepthRule>& rules) {
  auto const& limb = shapes[joint.limb];
  auto const& host = shapes[joint.host];
  double const sign = joint.side == Side::Front ? 1 : -1;
  for (std::size_t i = 0; i < joint.limb_vertices.size(); ++i) {
    Vec2 const p = limb.mesh.points[joint.limb_vertices[i]];
    Vec2 const q = host.mesh.points[joint.host_vertices[i]];  // the same place
    bool const is_end = i == 0 || i + 1 == joint.limb_vertices.size();
    rules.push_back({limb.plate.depth(p), host.plate.depth(q),
                     sign * host.heights[joint.host_vertices[i]],
                     is_end ? weight : weight * kSoftMiddle, true, 0});
  }
}

/// Along two mouths that meet: one depth, and one slope across the run.
void add_mouth_rules(Joint const& joint, std::span<LayerShape const> shapes, double weight,
                     std::vector<DepthRule>& rules) {
  auto const& limb = shapes[joint.limb];
  auto const& host = shapes[joint.host];
  auto const& points = limb.mesh.points;
  Vec2 const along = points[joint.limb_vertices.back()] - points[joint.limb_vertices.front()];
  Vec2 const across = perpendicular(normalized(along));
  for (std::size_t i = 0; i < joint.limb_vertices.size(); ++i) {
    Vec2 const p = points[joint.limb_vertices[i]];
    Vec2 const q = host.mesh.points[joint.host_vertices[i]];  // the same place
    rules.push_back({limb.plate.depth(p), host.plate.depth(q), 0, weight, true, 0});
    rules.push_back({limb.plate.slope(p, across), host.plate.slope(q, across), 0,
                     weight * squared_norm(along), true, 0});
  }
}

}  // namespace

void add_order_rules(FlatModel const& model, std::span<LayerShape const> shapes, double weight,
                     std::vector<DepthRule>& rules) {
  std::vector<std::vector<int>> joints(shapes.size());  // of each layer
  for (int i = 0; i < std::ssize(model.joints); ++i) {
    if (model.joints[i].limb_vertices.size() < 2) continue;
    joints[model.joints[i].limb].push_back(i);
    joints[model.joints[i].host].push_back(i);
  }
  int const stride = 1 + static_cast<int>(count_lookups(shapes) / kMostLookups);
  int group = 0;
  for (int j = 0; j < std::ssize(shapes); ++j) {
    for (int i = 0; i < j; ++i) {
      if (!touch(shapes[i].grid.box(), shapes[j].grid.box())) continue;
      auto pair = describe(model, joints, i, j);
      pair.group = group++;
      auto const& behind = shapes[pair.behind];
      auto const& before = shapes[pair.before];
      for_each_common_point(before, behind, stride, [&](Vec2 p, double own, double other) {
        add_rule_at(pair, shapes, p, other, own, weight, rules);
      });
      for_each_common_point(behind, before, stride, [&](Vec2 p, double own, double other) {
        add_rule_at(pair, shapes, p, own, other, weight, rules);
      });
    }
  }
}

void add_joint_rules(FlatModel const& model, std::span<LayerShape const> shapes, double weight,
                     std::vector<DepthRule>& rules) {
  for (auto const& joint : model.joints) {
    CHECK(joint.limb_vertices.size() == joint.host_vertices.size(), "a joint's points in pairs");
    if (joint.limb_vertices.size() < 2) continue;
    if (joint.kind == Joint::Kind::Slit) {
      add_slit_rules(joint, shapes, weight, rules);
    } else {
      add_mouth_rules(joint, shapes, weight, rules);
    }
  }
}

void add_slope_rules(std::span<LayerShape const> shapes, double weight,
                     std::vector<DepthRule>& rules) {
  int group = -1;  // apart from those of pairs
  for (auto const& shape : shapes) {
    double const reach = shape.plate.cell_px();
    for (auto const p : shape.plate.cell_centres()) {
      for (Vec2 const direction : {Vec2{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        auto const slope = shape.plate.slope(p, direction);
        auto zero = slope;
        zero.weights = {};
        rules.push_back({zero, slope, -kSteepest, weight * reach * reach, false, group});
      }
    }
    --group;
  }
}

}  // namespace inkflate
