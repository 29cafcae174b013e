// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "image/grid2.h"

namespace inkflate {

/// A mask from rows of equal length; '.' is background.
inline Mask mask_of(std::vector<std::string> const& rows) {
  Mask mask(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      mask.at(x, y) = rows[y][static_cast<std::size_t>(x)] == '.' ? 0 : 255;
    }
  }
  return mask;
}

/// The rows of a mask, with '#' and '.': comparisons that fail can be read.
inline std::vector<std::string> text_of(Mask const& mask) {
  std::vector<std::string> rows;
  for (int y = 0; y < mask.height; ++y) {
    std::string row;
    for (int x = 0; x < mask.width; ++x) row += mask.at(x, y) == 0 ? '.' : '#';
    rows.push_back(row);
  }
  return rows;
}

}  // namespace inkflate
