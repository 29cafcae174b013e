// SPDX-License-Identifier: Apache-2.0
#include "model/stroke.h"

#include <string_view>

namespace inkflate {

bool is_candidate_layer(StrokeGroup const& group) {
  std::string name = group.name;
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  auto const first = name.find_first_not_of(" \t\r\n");
  auto const last = name.find_last_not_of(" \t\r\n");
  if (first == std::string::npos) return true;
  auto const word = std::string_view(name).substr(first, last - first + 1);
  return word != "construction" && word != "noise" && word.substr(0, 4) != "help";
}

}  // namespace inkflate
