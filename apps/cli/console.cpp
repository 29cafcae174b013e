// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"

#include <cstdio>

#include "cli/files.h"
#include "io/json_report.h"

namespace inkflate::cli {
namespace {

void print_line(std::string_view file, std::string_view message) {
  std::string line = "inkflate: ";
  if (!file.empty()) line += one_line(file) + ": ";
  line += one_line(message) + "\n";
  std::fputs(line.c_str(), stderr);
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20U || c == 0x7f) c = '?';
  }
  return line;
}

bool print(std::string_view text) { return !write_file(std::string(kStandardStream), text); }

void print_error(std::string_view file, Error const& error) { print_line(file, error.message); }

void print_note(std::string_view file, std::string_view message) { print_line(file, message); }

void print_warning(std::string_view file, std::string_view message) {
  print_line(file, "warning: " + std::string(message));
}

Json error_json(Error const& error) { return Json::parse(json_error(error)); }

std::string to_text(Json const& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace inkflate::cli
