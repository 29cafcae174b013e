// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec2.h"
#include "image/grid2.h"

namespace inkflate {

/// Reads a picture between its pixels. Where it is shown small, it is made smaller first, so that no pixel is skipped.
class PictureSampler {
 public:
  /// in      picture: at least one pixel; has to outlive the sampler
  ///         step_px: > 0; how many px of the picture lie between two samples
  PictureSampler(Picture const& picture, double step_px);
  PictureSampler(PictureSampler const&) = delete;
  PictureSampler& operator=(PictureSampler const&) = delete;

  /// The colour at a place of the picture, px: a mixture of the four nearest pixels by how much they cover. Beyond the picture: clear.
  Colour operator()(Vec2 place) const;

 private:
  Picture small_;  // empty: not needed
  Picture const& picture_;
  Vec2 scale_;
};

}  // namespace inkflate
