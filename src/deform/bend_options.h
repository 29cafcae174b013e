// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace inkflate {

enum class BendMode {
  Body,  // the filled shape resists: what is near follows, nothing folds over
  Wire,  // the thesis' strip along the line: soft, for comparison
};

struct BendOptions {
  BendMode mode = BendMode::Body;
  /// Of mode Body, kLeastBody .. 1: how stiff the inside is beside the line. 1 bends a body, less a wire.
  double body = 1;
  /// Of mode Wire, >= 0; 0: as wide as the spacing of the line's vertices.
  double strip_half_width_px = 0;
  /// Of mode Body, >= 0: a shape that is small in its drawing need not be bent more finely than this.
  double least_edge_px = 0;

  static constexpr double kLeastBody = 0.003;  // docs/algorithms/deform.md

  friend bool operator==(BendOptions const&, BendOptions const&) = default;
};

}  // namespace inkflate
