// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/stroke.h"

namespace inkflate {

/// Where a sketch that could not be closed is most open: the middle between two loose ends that lie next to each other, farther apart
/// than all others; without loose ends the middle of the strokes.
///
/// in      any strokes
/// out     canvas px, finite where the strokes are; (0, 0) when there is nothing
/// cost    O(samples); of very many loose ends those of the longest strokes are looked at
Vec2 widest_opening(Sketch const& sketch);

}  // namespace inkflate
