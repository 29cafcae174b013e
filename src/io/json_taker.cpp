// SPDX-License-Identifier: Apache-2.0
#include "io/json_taker.h"

#include <cmath>

#include "io/svg_colour.h"

namespace inkflate {

void JsonTaker::enter(char const* kind, std::ptrdiff_t index) {
  place_ = std::string(kind) + " " + std::to_string(index);
  index_ = index;
}

void JsonTaker::fail(std::string const& what, ErrorCode code) {
  if (fault_) return;
  fault_ = Error{code, source_ + ": " + (place_.empty() ? "" : place_ + ": ") + what, index_};
}

JsonTaker::Json const* JsonTaker::find(Json const& object, char const* name) const {
  if (!object.is_object()) return nullptr;
  auto const found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

JsonTaker::Json::array_t const& JsonTaker::list(Json const& object, char const* name) {
  auto const* const value = find(object, name);
  if (value == nullptr) return none_;
  auto const* const elements = value->get_ptr<Json::array_t const*>();
  if (elements == nullptr) fail(std::string(name) + " is no list");
  return elements == nullptr ? none_ : *elements;
}

JsonTaker::Json::array_t const* JsonTaker::tuple(Json const* value, char const* name,
                                                 std::size_t count) {
  auto const* const elements = value == nullptr ? nullptr : value->get_ptr<Json::array_t const*>();
  if (elements != nullptr && elements->size() == count) return elements;
  fail(std::string(name) + " is missing or no list of " + std::to_string(count));
  return nullptr;
}

double JsonTaker::number(Json const* value, char const* name, double least, double most) {
  double const result = value != nullptr && value->is_number() ? value->get<double>() : NAN;
  if (result >= least && result <= most) return result;
  fail(std::string(name) + " is missing or no number in its range");
  return least;
}

int JsonTaker::index(Json const* value, char const* name, int least, std::ptrdiff_t count) {
  double const result = number(value, name, least, static_cast<double>(count) - 1);
  if (result == std::floor(result)) return static_cast<int>(result);
  fail(std::string(name) + " is no whole number");
  return least;
}

std::vector<int> JsonTaker::indices(Json const& object, char const* name, int least,
                                    std::ptrdiff_t count) {
  std::vector<int> result;
  for (auto const& value : list(object, name)) result.push_back(index(&value, name, least, count));
  return result;
}

bool JsonTaker::flag(Json const& object, char const* name) {
  auto const* const value = find(object, name);
  if (value == nullptr) return false;
  if (!value->is_boolean()) fail(std::string(name) + " is neither true nor false");
  return *value == true;
}

std::string JsonTaker::text(Json const* value, char const* name) {
  auto const* const found = value == nullptr ? nullptr : value->get_ptr<std::string const*>();
  if (found == nullptr) fail(std::string(name) + " is missing or no text");
  return found == nullptr ? std::string() : *found;
}

Colour JsonTaker::colour(Json const* value, char const* name) {
  auto const parsed = parse_colour(text(value, name));
  if (!parsed) fail(std::string(name) + " is no colour");
  return parsed.value_or(Colour{});
}

Vec2 JsonTaker::point(Json const* value, char const* name, double most) {
  auto const* const pair = tuple(value, name, 2);
  if (pair == nullptr) return {};
  double const x = number(pair->data(), name, -most, most);
  return {x, number(&(*pair)[1], name, -most, most)};
}

std::vector<Vec2> JsonTaker::points(Json const& object, char const* name, double most) {
  auto const& numbers = list(object, name);
  if (numbers.size() % 2 != 0) fail(std::string(name) + " are no pairs of numbers");
  std::vector<Vec2> result;
  result.reserve(numbers.size() / 2);
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    double const x = number(&numbers[i], name, -most, most);
    result.push_back({x, number(&numbers[i + 1], name, -most, most)});
  }
  return result;
}

}  // namespace inkflate
