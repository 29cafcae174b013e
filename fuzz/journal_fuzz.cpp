// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <string>

#include "base/check.h"
#include "base/hash.h"
#include "io/document_hash.h"
#include "io/journal.h"
#include "io/numbers.h"

namespace {

std::span<std::byte const> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

/// The lines of the text as a journal's, each with the sum that it should have: else no fuzzer would ever get past the sums.
std::string with_sums(std::string_view text) {
  std::string journal = inkflate::journal_start();
  while (!text.empty()) {
    auto const line = text.substr(0, text.find('\n'));
    inkflate::Hash hash;
    hash.add(bytes_of(line));
    journal += inkflate::hex_digits(hash.value()) + " " + std::string(line) + "\n";
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return journal;
}

void check(std::string_view text) {
  auto const read = inkflate::read_journal(bytes_of(text));
  if (!read) return;
  CHECK(read->bytes <= text.size() && text[read->bytes - 1] == '\n', "it is read by lines");
  auto const again = inkflate::read_journal(bytes_of(text.substr(0, read->bytes)));
  CHECK(again.has_value() && !again->is_damaged, "what was read is whole");
  CHECK(again->entries == read->entries && again->bytes == read->bytes, "and tells as much");
  CHECK(inkflate::document_hash(to_project(again->history.document())) ==
            inkflate::document_hash(to_project(read->history.document())),
        "and the same");
}

}  // namespace

// Any bytes, as a journal or as its lines, end in a history or an error, and the part that was read reads the same alone.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const text(reinterpret_cast<char const*>(data), size);
  check(text);
  check(with_sums(text));
  return 0;
}
