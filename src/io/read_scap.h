// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "base/result.h"
#include "model/stroke.h"

namespace inkflate {

/// Reads a .scap file, the sketch format of StrokeAggregator and StrokeStrip.
///
///     #W H            canvas, px
///     @thickness      of all strokes that have none of their own
///     {
///       #id cluster   passed over: clusters are what we find ourselves
///       @width        may be missing
///       x y pressure  one line per sample; pressure may be missing
///     }
///
/// out     strokes in the file's order, those without samples left out; a stroke whose pressures are all 0 was recorded
///         without and gets 1. Without a canvas line the canvas is as large as the strokes need.
/// errors  BadInput (index: the line, from 1), TooLarge, Unsupported (UTF-16)
/// cost    O(bytes)
Result<Sketch> read_scap(std::span<std::byte const> bytes);

}  // namespace inkflate
