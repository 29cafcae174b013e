// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/project.h"

namespace inkflate {

/// The project on a canvas that holds all that is drawn. In a window one draws where there is room; a file would cut off what has left
/// the sheet. So the canvas grows as far as the lines reach, and what lies on it moves along.
///
/// in      as make_document takes it
/// out     the same, when all lies on the canvas already, or when there is a template: it lies as the canvas does
/// cost    O(samples)
Project give_room(Project project);

}  // namespace inkflate
