// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simplify/rim.h"

namespace inkflate {

/// Rims made by hand, each corner a sample of its own. Positions are those of the lattice.
struct HandMadeRims {
  StrokeSamples samples;
  std::vector<Rim> rims;

  /// kinds: of the edges; all ink when there are none.
  void add(Contour const& contour, std::vector<RunKind> const& kinds = {}) {
    Rim rim;
    int const stroke = static_cast<int>(std::ssize(rims));
    for (std::size_t i = 0; i < contour.size(); ++i) {
      rim.push_back(
          {static_cast<int>(std::ssize(samples.points)), kinds.empty() ? RunKind::Ink : kinds[i]});
      auto const lattice = WorkSpace::lattice_point(contour[i]);
      auto const next = contour[(i + 1) % contour.size()];
      samples.points.push_back({WorkSpace::lattice_position(lattice), normalized(next - contour[i]),
                                static_cast<double>(i), stroke});
      samples.lattice.push_back(lattice);
    }
    rims.push_back(std::move(rim));
  }

  Contour contour(int r) const { return positions(rims[r], samples); }
};

/// Points at most spacing_px apart on the sides of a polygon.
inline Contour resampled(Contour const& corners, double spacing_px = 2.2) {
  Contour result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    auto const a = corners[i];
    auto const b = corners[(i + 1) % corners.size()];
    int const steps = static_cast<int>(distance(a, b) / spacing_px) + 1;
    for (int k = 0; k < steps; ++k) result.push_back(lerp(a, b, static_cast<double>(k) / steps));
  }
  return result;
}

}  // namespace inkflate
