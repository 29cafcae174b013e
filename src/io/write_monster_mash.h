// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "base/result.h"
#include "model/project.h"

namespace inkflate {

/// A project as Monster Mash reads it: a zip archive with two pictures of 1000 x 800 for each layer. All that the pictures cannot hold is
/// kept in files which that program passes over, so read_monster_mash gives back exactly the same.
///
/// in      as write_inkflate; a canvas of another size, or layers that leave it, are scaled as a whole and centred
/// out     help lines are open; so is a closing whose two ends lie on or in another layer, where the parts join
/// errors  NothingThere (no layer encloses anything); TooLarge (more than 255 layers; a file larger than we read)
/// cost    O(layers x canvas)
/// source  docs/FORMATS.md
Result<std::vector<std::byte>> write_monster_mash(Project const& project);

}  // namespace inkflate
