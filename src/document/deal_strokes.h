// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "document/document.h"

namespace inkflate {

/// Layers with strokes of their own.
struct DealtStrokes {
  std::vector<DocumentLayer> layers;
  std::vector<int> rest;  // strokes that no layer names; ascending
};

/// Gives every stroke to the first layer that names it, in one list or another; what other layers say of it is forgotten: their
/// lists lose it, the sources of their outlines lose their stroke.
///
/// in      the layers' indices are within strokes
DealtStrokes deal_strokes(std::vector<Layer> layers, std::span<Shared<KeptStroke> const> strokes);

/// Adds what to every index of a stroke that the layer names.
void shift_strokes(Layer& layer, int what);

}  // namespace inkflate
