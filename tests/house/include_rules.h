// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace inkflate::house {

/// The headers a source text includes, in its order: "model/stroke.h", <vector>, with their quotes or brackets.
std::vector<std::string> includes_of(std::string_view text);

/// What is wrong with the includes of one file of src/ or apps/: an edge to a higher floor or to a neighbour, a
/// third-party library outside of its folder, a path that does not start at src/ or apps/.
///
/// in      path: from the top of the tree, "src/model/drawing.h"
/// out     one sentence for each fault; empty: all is well
std::vector<std::string> include_faults(std::string_view path, std::string_view text);

}  // namespace inkflate::house
