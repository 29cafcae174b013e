// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/vec2.h"
#include "image/colour.h"

namespace inkflate {

inline constexpr double kAnyNumber = std::numeric_limits<double>::max();
/// For indices and ids whose list is not at hand.
inline constexpr int kAnyCount = std::numeric_limits<int>::max();

/// Takes values out of JSON. After the first one that is missing or wrong all that is taken is of no use, but harmless; the
/// caller looks at fault() at the end.
class JsonTaker {
 public:
  using Json = nlohmann::json;

  /// source: what is read, for messages, such as "document.json".
  explicit JsonTaker(std::string source) : source_(std::move(source)) {}

  std::optional<Error> const& fault() const { return fault_; }

  /// What of it is being read, for the message: "layer 3".
  void enter(char const* kind, std::ptrdiff_t index);

  void fail(std::string const& what, ErrorCode code = ErrorCode::BadInput);

  /// A member of an object; null where there is none.
  Json const* find(Json const& object, char const* name) const;

  /// The elements of a member that is an array; without any where it is missing.
  Json::array_t const& list(Json const& object, char const* name);

  /// The elements of a value that has to be an array of so many.
  Json::array_t const* tuple(Json const* value, char const* name, std::size_t count);

  double number(Json const* value, char const* name, double least, double most);

  /// An integer in least .. count - 1.
  int index(Json const* value, char const* name, int least, std::ptrdiff_t count);

  /// Without such a member: an empty list.
  std::vector<int> indices(Json const& object, char const* name, int least, std::ptrdiff_t count);

  /// False where it is missing.
  bool flag(Json const& object, char const* name);

  std::string text(Json const* value, char const* name);

  Colour colour(Json const* value, char const* name);

  /// [x, y], each within most.
  Vec2 point(Json const* value, char const* name, double most);

  /// A member [x0, y0, x1, y1, ...]; without any where it is missing.
  std::vector<Vec2> points(Json const& object, char const* name, double most);

  /// The kind that the text names, by its word().
  template <typename Kind>
  Kind kind(Json const* value, char const* name, std::initializer_list<Kind> kinds) {
    auto const found = text(value, name);
    for (auto const each : kinds) {
      if (word(each) == found) return each;
    }
    fail("there is no " + std::string(name) + " \"" + found.substr(0, 20) + "\"");
    return *kinds.begin();
  }

 private:
  std::string source_;
  std::optional<Error> fault_;
  Json::array_t const none_ = {};
  std::string place_;
  long long index_ = -1;
};

}  // namespace inkflate
