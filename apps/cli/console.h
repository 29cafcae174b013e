// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace inkflate::cli {

using Json = nlohmann::ordered_json;

/// Puts text on standard output. False: it cannot be written.
bool print(std::string_view text);

/// Names and messages may hold anything; a line on the terminal must stay one line and steer nothing.
std::string one_line(std::string_view text);

/// One line on standard error: "inkflate: FILE: message"; an empty file name is left out.
void print_error(std::string_view file, Error const& error);
void print_note(std::string_view file, std::string_view message);
void print_warning(std::string_view file, std::string_view message);

/// {"error": {"code", "message", "where"}}, to be joined with more.
Json error_json(Error const& error);

/// The object on one line; bytes that are no UTF-8 become U+FFFD.
std::string to_text(Json const& json);

}  // namespace inkflate::cli
