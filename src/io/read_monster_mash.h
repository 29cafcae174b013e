// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "base/result.h"
#include "model/project.h"

namespace inkflate {

/// What a Monster Mash project may ask for, beyond what ZipLimits and PictureLimits bound.
struct MonsterMashLimits {
  static constexpr long long kCanvasPixels = 16'000'000;
  static constexpr long long kAllPixels = 512'000'000;  // of the canvas, once for each picture
  static constexpr std::size_t kLayers = 1024;
};

/// Reads a Monster Mash project. Where it holds our document, that is what is read; else layers are traced from its pictures.
///
/// in      file: a zip archive with pictures _org_NNN.png (outline) and _seg_NNN.png (region), in any one folder; layers.txt, settings.txt
///         and template.png may be missing, and so may one picture of each pair. Pins and the background picture are passed over
/// out     traced: a canvas as large as the first outline's picture, a layer for each area of a region, back to front, runs
///         through the middle of the lines; each run is also a stroke, so that it can be drawn and edited
/// errors  BadInput (damaged), TooLarge (limits of archive, pictures and MonsterMashLimits), NothingThere (no area)
/// cost    O(pixels of all pictures)
/// source  docs/FORMATS.md
Result<Project> read_monster_mash(std::span<std::byte const> file);

}  // namespace inkflate
