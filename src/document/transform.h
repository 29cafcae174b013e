// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "document/document.h"
#include "geometry/affine.h"

namespace inkflate {

/// The map at work on what a document holds. Lengths (widths, gaps) grow with its mean scale. Points that were equal stay equal, so
/// pieces that joined still join.
Stroke transformed(Stroke stroke, Affine const& map);
StrokeList transformed(StrokeList const& strokes, Affine const& map);
CloseChoice transformed(CloseChoice choice, Affine const& map);

/// A map that mirrors turns outlines around, so that outer ones keep their positive area, and negates the turns of pins. Any other map
/// leaves turns alone: they are counted from the shape, which turns with it.
Outline transformed(Outline outline, Affine const& map);
Layer transformed(Layer layer, Affine const& map);

}  // namespace inkflate
