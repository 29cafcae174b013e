// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "io/read_mesh.h"

namespace inkflate {

/// The two kinds of STL, told apart by content; what they hold is described in read_mesh.h.

bool is_binary_stl(std::span<std::byte const> file);
Result<MeshReading> read_binary_stl(std::span<std::byte const> file);

bool is_text_stl(std::string_view text);
Result<MeshReading> read_text_stl(std::string_view text);

}  // namespace inkflate
