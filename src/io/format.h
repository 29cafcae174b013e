// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace inkflate {

enum class FileFormat {
  Svg,
  Scap,
  Png,
  Jpeg,
  Inkflate,     // a zip archive with document.json
  MonsterMash,  // a zip archive with _org_000.png or _seg_000.png
  ThreeMf,      // a zip archive with 3D/3dmodel.model
  Zip,          // any other zip archive
  Journal,
  Glb,
  Obj,
  Stl,
  Unknown
};

/// What the bytes look like, by their content and never by a name. Says nothing about whether they can be read.
FileFormat sniff_format(std::span<std::byte const> bytes);

/// "SVG", ".scap", "Monster Mash": for messages.
char const* file_format_name(FileFormat format);

}  // namespace inkflate
