// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "base/check.h"

namespace inkflate {

enum class ErrorCode {
  BadInput,      // the data is not what it claims to be
  BadOption,     // an option is outside its legal range
  TooLarge,      // a limit of docs/LIMITS.md would be passed
  Unsupported,   // a valid file that uses something we do not read
  NothingThere,  // valid, but there is nothing to work on
  Cancelled,     // the caller asked to stop
  FileSystem,    // cannot read or write
};

/// The name used in JSON reports, such as "bad_input".
char const* error_code_name(ErrorCode code);

/// An expected failure. The message is for the user: what failed, where, what would help.
struct Error {
  ErrorCode code = ErrorCode::BadInput;
  std::string message;
  long long index =
      -1;  // the offending byte, line, stroke or vertex, as the message says; -1: none
};

/// A value or an Error: a subset of C++23's std::expected<T, Error>.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value)
      : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: implicit as in std::expected
  Result(Error error)
      : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: so is the failure

  bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  T const& value() const& {
    CHECK(has_value(), "value() of a failed Result");
    return *std::get_if<0>(&state_);
  }
  T& value() & {
    CHECK(has_value(), "value() of a failed Result");
    return *std::get_if<0>(&state_);
  }
  T&& value() && { return std::move(value()); }

  T const& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(value()); }
  T const* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  Error const& error() const {
    CHECK(!has_value(), "error() of a Result that holds a value");
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

}  // namespace inkflate
