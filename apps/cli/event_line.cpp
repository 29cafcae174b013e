// SPDX-License-Identifier: Apache-2.0
#include "cli/event_line.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace inkflate::cli {

using Json = nlohmann::json;

Json const* EventLine::take(char const* name) {
  taken_.emplace_back(name);
  auto const found = object_.find(name);
  return found == object_.end() ? nullptr : &*found;
}

bool EventLine::is_null(char const* name) {
  auto const* const value = take(name);
  return value != nullptr && value->is_null();
}

// JSON has no word for what is not finite, and just that has to be recorded where a driver sent it.
double EventLine::number_of(Json const& value, char const* name) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (value.is_number()) return value.get<double>();
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return infinity;
  if (value == "-inf") return -infinity;
  fail(std::string(name) + " is no number");
  return 0;
}

double EventLine::number(char const* name, double fallback) {
  auto const* const value = take(name);
  return value == nullptr ? fallback : number_of(*value, name);
}

int EventLine::whole_number(char const* name, int fallback) {
  double const value = number(name, fallback);
  constexpr double least = std::numeric_limits<int>::min();
  constexpr double most = std::numeric_limits<int>::max();
  if (value >= least && value <= most && value == std::floor(value)) {
    return static_cast<int>(value);
  }
  fail(std::string(name) + " is no whole number in its range");
  return fallback;
}

bool EventLine::flag(char const* name) {
  auto const* const value = take(name);
  if (value == nullptr) return false;
  if (!value->is_boolean()) fail(std::string(name) + " is neither true nor false");
  return *value == true;
}

std::string EventLine::text(char const* name) {
  auto const* const value = take(name);
  auto const* const found = value == nullptr ? nullptr : value->get_ptr<std::string const*>();
  if (found == nullptr) fail(std::string(name) + " is missing or no text");
  return found == nullptr ? std::string() : *found;
}

std::string EventLine::text(char const* name, std::string fallback) {
  return has(name) ? text(name) : std::move(fallback);
}

Vec2 EventLine::point(char const* name) {
  auto const* const value = take(name);
  if (value != nullptr && value->is_array() && value->size() == 2) {
    return {number_of((*value)[0], name), number_of((*value)[1], name)};
  }
  fail(std::string(name) + " is missing or no pair of numbers");
  return {};
}

std::vector<StrokePoint> EventLine::points(char const* name) {
  std::vector<StrokePoint> result;
  auto const* const value = take(name);
  if (value == nullptr || !value->is_array() || value->empty()) {
    fail(std::string(name) + " is no list of points");
    return result;
  }
  for (auto const& point : *value) {
    if (!point.is_array() || point.size() < 2 || point.size() > 3) {
      fail(std::string(name) + " has a point that is not two or three numbers");
      return result;
    }
    StrokePoint taken;
    taken.position = {number_of(point[0], name), number_of(point[1], name)};
    if (point.size() == 3) taken.pressure = number_of(point[2], name);
    result.push_back(taken);
  }
  return result;
}

std::string EventLine::file_name(char const* name) {
  auto found = text(name);
  std::filesystem::path const path(found);
  bool const leads_out = path.is_absolute() || !path.has_filename() ||
                         std::find(path.begin(), path.end(), "..") != path.end();
  if (leads_out || found.find('\0') != std::string::npos) {
    fail(std::string(name) + " has to name a file beside the recording");
  }
  return found;
}

void EventLine::fail(std::string const& what) {
  if (!fault_) fault_ = what;
}

std::optional<std::string> EventLine::fault() const {
  if (fault_) return fault_;
  for (auto const& member : object_.items()) {
    if (std::find(taken_.begin(), taken_.end(), member.key()) == taken_.end()) {
      return "\"" + member.key().substr(0, 20) + "\" means nothing here";
    }
  }
  return std::nullopt;
}

}  // namespace inkflate::cli
