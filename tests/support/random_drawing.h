// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/rng.h"
#include "model/drawing.h"

namespace inkflate::test {

/// A drawing with all that a file can hold: numbers of every form, names of every sign, groups, layers with outlines of every kind.
/// The strokes make no sense.
Drawing random_drawing(Rng& rng);

}  // namespace inkflate::test
