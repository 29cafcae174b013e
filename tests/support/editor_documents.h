// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "document/document.h"

namespace inkflate {

/// Documents for tests, built in code: each function gives the document with one thing more. Lengths in px.

enum class Turn { Outer, Hole };
/// Four cubics, the first starting to the right of the centre.
Outline circle_outline(Vec2 centre, double radius, Turn turn = Turn::Outer);

Document with_loose(Document const& document, Stroke stroke);

/// A layer before all others; its id is next_id. All strokes are those of its outline.
Document with_layer(Document const& document, Layer layer, std::vector<Stroke> strokes);
/// A closed layer that one circle has drawn.
Document with_disc(Document const& document, Vec2 centre, double radius, std::string name = "disc");
/// The same with a hole.
Document with_ring(Document const& document, Vec2 centre, double outer, double inner);
/// An open layer that has no outlines yet.
Document with_open(Document const& document, std::vector<Stroke> strokes);

/// With something changed in one layer: hidden, locked.
Document with_changed(Document const& document, LayerId layer,
                      std::function<void(Layer&)> const& change);

/// Ids from back to front.
std::vector<LayerId> layer_order(Document const& document);

}  // namespace inkflate
