// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/vec2.h"
#include "model/clip.h"
#include "model/drawing.h"

namespace inkflate {

/// What is wrong with values that come from outside, before they become part of a document; none: nothing. The errors are as
/// of apply(), without an index.
using Fault = std::optional<Error>;

/// Finite, and within the farthest coordinate to every side.
bool is_on_sheet(Vec2 p);
/// Within least .. most; not for NaN.
bool is_within(double value, double least, double most);
bool is_utf8(std::string_view text);

Fault stroke_fault(Stroke const& stroke, int group_count);
Fault choice_fault(CloseChoice const& choice);
Fault thickness_fault(double thickness);
Fault name_fault(std::string_view name);
Fault bend_pins_fault(std::vector<BendPin> const& pins);
/// Its values, and its indices into stroke_count strokes. Its name may be as long as a file has it.
Fault layer_fault(Layer const& layer, int stroke_count);
Fault pin_fault(Pin const& pin);
/// length_s: of the clip.
Fault track_fault(Track const& track, double length_s);
Fault clip_length_fault(double length_s);

}  // namespace inkflate
