// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "base/result.h"
#include "io/svg_tree.h"
#include "model/drawing.h"

namespace inkflate {

/// The names by which a file of write_svg is known again.
inline constexpr std::string_view kOwnNamespace = "https://inkflate.app/ns/1";
inline constexpr std::string_view kRoughClass = "inkflate-rough";
inline constexpr std::string_view kLayerClass = "inkflate-layer";

/// Was the document written by write_svg? Other programs may have changed or added elements since.
bool is_own_svg(SvgTree const& tree);

/// What write_svg was given. What is drawn for viewers is passed over, and so is anything another program added.
/// errors  BadInput where our data is damaged (index: the byte of its element); TooLarge
Result<Drawing> read_own_svg(SvgTree const& tree);

}  // namespace inkflate
