// SPDX-License-Identifier: Apache-2.0
#include "assemble/drawing_rims.h"

#include "geometry/rect.h"

namespace inkflate {
namespace {

constexpr double kUnitsAcross = 1000;
constexpr double kRimStep = 1.5;  // in units; finer than any edge of the meshes

}  // namespace

double drawing_unit(Drawing const& drawing) {
  Rect box;
  for (auto const& layer : drawing.layers) {
    for (auto const& piece : layer.outlines.front().pieces) box.include(piece.curve.start());
  }
  return box.longer_side() / kUnitsAcross;
}

std::vector<LayerRim> drawing_rims(Drawing const& drawing, double unit_px) {
  std::vector<LayerRim> rims;
  for (auto const& layer : drawing.layers) rims.push_back(layer_rim(layer, kRimStep * unit_px));
  return rims;
}

}  // namespace inkflate
