// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

namespace inkflate {

inline std::span<std::byte const> as_bytes(std::string_view text) {
  return {reinterpret_cast<std::byte const*>(text.data()), text.size()};
}

/// The contents of a file below tests/data; empty where there is none.
inline std::string test_data(std::string const& path) {
  std::string text;
  auto* file = std::fopen((INKFLATE_SOURCE_DIR "/tests/data/" + path).c_str(), "rb");
  if (file == nullptr) return text;
  char buffer[4096];
  for (std::size_t n = 1; n > 0;) {
    n = std::fread(buffer, 1, sizeof buffer, file);
    text.append(buffer, n);
  }
  std::fclose(file);
  return text;
}

}  // namespace inkflate
