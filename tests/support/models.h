// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/rest_model.h"

namespace inkflate {

/// Inflated models for tests, built in code on a canvas of 400 x 400 px: closed, both sheets sharing the rim in z = 0.

/// A ball: 2 + 4 rings (2 rings - 1) vertices, on circles around the z axis; front and back have `rings` circles each.
RestModel ball_model(Vec3 centre, double radius, int rings = 8);

/// A ring around the z axis: genus 1.
RestModel torus_model(double major_radius, double minor_radius, int segments = 16);

/// A large ball called "body" and a small one called "nose" in front of it that reaches into it.
RestModel two_layer_model();

/// Puts `part` into the model as one more layer.
void add_layer(RestModel& model, RestModel const& part, std::string const& name);

/// The picture on the left half is worn in front, the one on the right half at the back, each stretched over the canvas.
Texture sheet_texture(RestModel const& model, Picture const& picture);

/// Its upper half is red, its lower half blue.
Picture red_over_blue(int size);

}  // namespace inkflate
