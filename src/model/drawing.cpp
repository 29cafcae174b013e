// SPDX-License-Identifier: Apache-2.0
#include "model/drawing.h"

#include <iterator>

namespace inkflate {

Contour flatten(Outline const& outline, double tolerance_px) {
  Contour contour;
  for (auto const& piece : outline.pieces) flatten_into(piece.curve, tolerance_px, contour);
  return contour;
}

std::vector<Run> runs(Outline const& outline, double tolerance_px) {
  auto const& pieces = outline.pieces;
  int const count = static_cast<int>(std::ssize(pieces));
  // Start where the kind changes, so that no run is cut in two by the outline's first point.
  int first = 0;
  for (int i = 0; i < count && first == 0; ++i) {
    if (pieces[i].kind != pieces[(i + count - 1) % count].kind) first = i;
  }
  std::vector<Run> result;
  for (int i = 0; i < count; ++i) {
    auto const& piece = pieces[(first + i) % count];
    if (result.empty() || result.back().kind != piece.kind) {
      result.push_back({piece.kind, {piece.curve.start()}});
    }
    flatten_into(piece.curve, tolerance_px, result.back().points);
  }
  return result;
}

}  // namespace inkflate
