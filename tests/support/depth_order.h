// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/flat_model.h"
#include "model/rest_model.h"

namespace inkflate::support {

/// A layer as two surfaces over the canvas.
struct Sheets {
  std::array<FlatMesh, 2> meshes;        // per Side
  std::array<std::vector<double>, 2> z;  // per Side and point
  std::vector<std::array<Vec3, 2>> rim;  // edges that both sheets share: canvas x, y and z
};

std::vector<Sheets> sheets_of(FlatModel const& model, std::span<std::vector<double> const> heights,
                              std::span<std::vector<double> const> depths);
std::vector<Sheets> sheets_of(RestModel const& model);

/// How well layers lie one before the other.
struct DepthOrder {
  int samples = 0;      // of rims that lie over or under another layer
  int wrong = 0;        // more than 1 px on the wrong side of it
  double worst_px = 0;  // the farthest on the wrong side
  Vec2 worst_at;
  std::array<int, 2> worst_layers = {-1, -1};  // whose rim, in which layer

  double wrong_share() const { return samples == 0 ? 0 : static_cast<double>(wrong) / samples; }
};

/// Samples every 2 px along each layer's rim against the front sheets of layers behind it and the back sheets of layers before it.
DepthOrder measure_depth_order(std::span<Sheets const> layers);

}  // namespace inkflate::support
