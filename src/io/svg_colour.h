// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "image/colour.h"

namespace inkflate {

/// A CSS colour: a name, #rgb, #rgba, #rrggbb, #rrggbbaa, rgb() or rgba(). Nothing where it is none of these.
/// source  CSS Color Module Level 3, section 4
std::optional<Colour> parse_colour(std::string_view text);

/// "#rrggbbaa".
std::string colour_hex(Colour colour);

}  // namespace inkflate
