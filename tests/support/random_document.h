// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/rng.h"
#include "document/document.h"

namespace inkflate::test {

/// The side of the square in which random points lie.
inline constexpr double kSheetPx = 300;

Vec2 point_on_sheet(Rng& rng);
CloseChoice random_choice(Rng& rng);

/// A document with all that a file can hold: open, locked and hidden layers, loose strokes, pins, tracks, a template.
Document random_document(Rng& rng);

}  // namespace inkflate::test
