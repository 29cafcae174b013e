// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "simplify/centre_rim.h"
#include "simplify/cut_parts.h"
#include "simplify/fit_rims.h"

namespace inkflate {
namespace {

Error cancelled() { return {ErrorCode::Cancelled, "stopped on request"}; }

}  // namespace

Result<std::vector<Layer>> fit_parts(CutParts const& cut, WorkSpace const& space, double smooth,
                                     Progress const& progress) {
  if (!progress.enter("centre")) return cancelled();
  auto const& samples = cut.cells.samples;
  std::vector<Rim> rims;
  for (auto const& part : cut.parts) rims.insert(rims.end(), part.begin(), part.end());
  std::vector<Vec2> points;
  points.reserve(samples.points.size());
  for (int k = 0; k < samples.drawn_count(); ++k) points.push_back(samples.points[k].position);
  PointGrid const grid(points, CentreOptions{}.reach_px);
  std::vector<Contour> centred;
  for (auto const& rim : rims) centred.push_back(centre_rim(rim, samples, grid));

  if (!progress.enter("fit")) return cancelled();
  auto outlines = fit_rims(rims, centred, samples, space, smooth);
  std::vector<Layer> layers;
  for (std::size_t next = 0; auto const& part : cut.parts) {
    Layer layer;
    for (std::size_t k = 0; k < part.size(); ++k)
      layer.outlines.push_back(std::move(outlines[next++]));
    layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace inkflate
