// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <string>

#include "base/check.h"
#include "document/apply.h"
#include "io/command_json.h"

// Any text, a command on each line, ends in commands or errors; a command survives being written and read, and a document takes it
// or refuses it. What a document takes, it can be written with.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view text(reinterpret_cast<char const*>(data), size);
  auto document = inkflate::empty_document();
  while (!text.empty()) {
    auto const end = std::min(text.find('\n'), text.size());
    auto const command = inkflate::read_command(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!command) continue;
    auto const written = inkflate::write_command(*command);
    auto const again = inkflate::read_command(written);
    CHECK(again.has_value(), "a written command reads");
    CHECK(inkflate::write_command(*again) == written, "a written command reads as the same");
    auto next = inkflate::apply(document, *command);
    if (!next) continue;
    document = *std::move(next);
    auto const whole = inkflate::read_command(inkflate::write_command(inkflate::Replace{document}));
    CHECK(whole.has_value(), "a document that a command made can be written and read");
    CHECK(inkflate::to_project(std::get<inkflate::Replace>(*whole).document) ==
              inkflate::to_project(document),
          "as the same");
  }
  return 0;
}
