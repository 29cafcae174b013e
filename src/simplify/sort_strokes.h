// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "model/drawing.h"
#include "simplify/stroke_samples.h"

namespace inkflate {

/// Gives every stroke its place: in the layer whose outline it draws, as a detail of the layer on which it lies or which it touches
/// (the largest share counts), or stray.
///
/// in      layers: with outlines in canvas px; samples: of the strokes to sort
/// out     fills strokes and details of the layers, in drawing order; returns the stray strokes
/// cost    O((samples + outline points) + strokes * outline points) with a small factor
std::vector<int> sort_strokes(StrokeSamples const& samples, WorkSpace const& space,
                              std::vector<Layer>& layers);

}  // namespace inkflate
