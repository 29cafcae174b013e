// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace inkflate {

enum class FileFormat { Svg, Scap, Png, Jpeg, Zip, Unknown };

/// What the bytes look like, by their content and never by a name. Says nothing about whether they can be read.
FileFormat sniff_format(std::span<std::byte const> bytes);

/// "SVG", ".scap", "PNG", "JPEG", "zip", "unknown": for messages.
char const* file_format_name(FileFormat format);

}  // namespace inkflate
