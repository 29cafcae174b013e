// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "io/byte_order.h"

namespace inkflate {

/// A GLB taken apart without our reader.
struct GlbParts {
  nlohmann::json json;
  std::span<std::byte const> binary;

  std::span<std::byte const> view(int index) const {
    auto const& view = json.at("bufferViews").at(static_cast<std::size_t>(index));
    return binary.subspan(view.at("byteOffset"), view.at("byteLength"));
  }
  nlohmann::json const& accessor(std::string const& attribute) const {
    auto const& primitive = json.at("meshes").at(0).at("primitives").at(0);
    int const index = attribute == "indices" ? primitive.at("indices").get<int>()
                                             : primitive.at("attributes").at(attribute).get<int>();
    return json.at("accessors").at(static_cast<std::size_t>(index));
  }
  std::vector<float> floats(std::string const& attribute) const {
    auto const bytes = view(accessor(attribute).at("bufferView"));
    std::vector<float> values(bytes.size() / 4);
    std::memcpy(values.data(), bytes.data(), values.size() * 4);
    return values;
  }
};

inline GlbParts glb_parts(std::span<std::byte const> file) {
  auto const json_bytes = little_endian32(file.subspan(12));
  auto const text = file.subspan(20, json_bytes);
  std::string_view const json(reinterpret_cast<char const*>(text.data()), text.size());
  return {nlohmann::json::parse(json), file.subspan(20 + json_bytes + 8)};
}

}  // namespace inkflate
