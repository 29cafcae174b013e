// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "document/document.h"

namespace inkflate {

/// Both documents in one: the layers of `upper` before those of `lower`, their ids new; loose strokes of both. Canvas, choice for
/// loose strokes and clip are those of `lower`; so is the template picture, unless only `upper` has one. Pins of `upper` come
/// without their tracks.
///
/// cost    O(strokes of upper + layers)
Document merged(Document const& lower, Document const& upper);

}  // namespace inkflate
