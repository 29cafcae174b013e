// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "io/write_3mf.h"
#include "model/rest_model.h"

namespace inkflate {

/// A model as objects to print, in its print pose (io/print_pose.h): layers that are joined are one closed object in several colours,
/// the others are objects of their own. Objects that overlap stay so: for one clean shell see solidify/solidify.h.
///
/// in      model: finite
/// out     objects named by their layers, in the order of the lowest layer of each; colours index the model's layers
std::vector<PrintObject> print_objects(RestModel const& model, double longest_mm = 100);

}  // namespace inkflate
