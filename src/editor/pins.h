// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "document/document.h"
#include "editor/view.h"

namespace inkflate {

/// Pins that can be taken hold of: of parts that are seen and not locked.

/// Null: there is no such pin, or it cannot be taken hold of.
BendPin const* find_pin(Document const& document, BendPinRef const& pin);

/// All of them, front to back.
std::vector<BendPinRef> pins_of(Document const& document);

/// Front to back, as a person goes through them: those of the selected parts, or of all when the selected have none.
std::vector<BendPinRef> pins_in_turn(Document const& document, View const& view);

/// The pin before or after another one, in a circle; the first or last when there is no other.
std::optional<BendPinRef> pin_after(std::vector<BendPinRef> const& pins,
                                    std::optional<BendPinRef> const& pin, int step);

/// The part that is meant where none is named: the one that is selected, that of the selected pin, or the only one that can be taken hold
/// of. Null: there is none.
DocumentLayer const* meant_layer(Document const& document, View const& view);

/// Where the next pin of a layer holds best: the place of its outer line that is farthest from its pins; from the middle of its box
/// as long as there is none. Nothing: it has no outline.
std::optional<Vec2> place_for_pin(Layer const& layer);

}  // namespace inkflate
