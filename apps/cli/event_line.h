// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "geometry/vec2.h"

namespace inkflate::cli {

/// Where a pen was, [x, y] or [x, y, pressure].
struct StrokePoint {
  Vec2 position;
  double pressure = 0.5;
};

/// Takes members out of one JSON object that a person wrote: a line of a recording, a pin. After the first one that is missing or wrong all that is taken is of no use, but
/// harmless; the caller looks at fault() at the end.
class EventLine {
 public:
  explicit EventLine(nlohmann::json const& object) : object_(object) {}

  bool has(char const* name) const { return object_.contains(name); }

  /// Takes a member that says "none".
  bool is_null(char const* name);

  /// Values of members. Those that may be missing have a fallback.
  double number(char const* name, double fallback);
  int whole_number(char const* name, int fallback);
  bool flag(char const* name);
  std::string text(char const* name);
  std::string text(char const* name, std::string fallback);
  Vec2 point(char const* name);
  std::vector<StrokePoint> points(char const* name);

  /// A name within a folder: not absolute, no way out of it.
  std::string file_name(char const* name);

  template <typename Choice>
  Choice choice(char const* name, Choice fallback,
                std::initializer_list<std::pair<char const*, Choice>> choices) {
    if (!has(name)) return fallback;
    auto const found = text(name);
    for (auto const& [word, value] : choices) {
      if (found == word) return value;
    }
    fail("there is no " + std::string(name) + " \"" + found.substr(0, 20) + "\"");
    return fallback;
  }

  void fail(std::string const& what);

  /// Also fails on a member that nobody has taken: what has a slip of the pen would do something else than it says.
  std::optional<std::string> fault() const;

 private:
  nlohmann::json const* take(char const* name);
  double number_of(nlohmann::json const& value, char const* name);

  nlohmann::json const& object_;
  std::vector<std::string> taken_;
  std::optional<std::string> fault_;
};

}  // namespace inkflate::cli
