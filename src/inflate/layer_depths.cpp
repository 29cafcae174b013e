// SPDX-License-Identifier: Apache-2.0
#include "inflate/layer_depths.h"

namespace inkflate {

std::vector<std::vector<double>> layer_depths(FlatModel const& model,
                                              std::span<std::vector<double> const> heights) {
  std::vector<std::vector<double>> depths;
  for (auto const& h : heights) depths.emplace_back(h.size(), 0.0);
  static_cast<void>(model);
  return depths;
}

}  // namespace inkflate
