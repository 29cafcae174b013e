// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace inkflate::test {

/// The bytes of a file under tests/data; empty when there is none.
inline std::vector<std::byte> data_file(std::string const& name) {
  std::ifstream file(std::string(INKFLATE_SOURCE_DIR) + "/tests/data/" + name, std::ios::binary);
  std::vector<char> const chars((std::istreambuf_iterator<char>(file)),
                                std::istreambuf_iterator<char>());
  std::vector<std::byte> bytes;
  bytes.reserve(chars.size());
  for (char const sign : chars) bytes.push_back(static_cast<std::byte>(sign));
  return bytes;
}

}  // namespace inkflate::test
