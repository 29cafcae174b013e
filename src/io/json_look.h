// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace inkflate {

/// Looking into JSON that came from outside: whatever is not there, or is of another kind, is nothing. To be included by .cpp files
/// only, for it costs two seconds each.

using JsonPlace = nlohmann::json const*;  // null: nothing

inline JsonPlace member(JsonPlace object, char const* name) {
  if (object == nullptr || !object->is_object()) return nullptr;
  auto const found = object->find(name);
  return found == object->end() ? nullptr : &*found;
}

inline std::int64_t count_of(JsonPlace array) {
  return array != nullptr && array->is_array() ? static_cast<std::int64_t>(array->size()) : 0;
}

inline JsonPlace element(JsonPlace array, std::int64_t index) {
  return index >= 0 && index < count_of(array) ? &(*array)[static_cast<std::size_t>(index)]
                                               : nullptr;
}

/// A whole number in 0 .. 2^53.
inline std::optional<std::int64_t> whole_number(JsonPlace place) {
  if (place == nullptr || !place->is_number_integer()) return std::nullopt;
  if (place->is_number_unsigned() && place->get<std::uint64_t>() > (1ULL << 53U)) {
    return std::nullopt;
  }
  auto const value = place->get<std::int64_t>();
  return value >= 0 ? std::optional(value) : std::nullopt;
}

/// The same for a member that may be left out: then it is the fallback.
inline std::optional<std::int64_t> whole_number_or(JsonPlace place, std::int64_t fallback) {
  return place == nullptr ? fallback : whole_number(place);
}

inline std::optional<std::string_view> text_of(JsonPlace place) {
  if (place == nullptr || !place->is_string()) return std::nullopt;
  return std::string_view(*place->get_ptr<std::string const*>());
}

}  // namespace inkflate
