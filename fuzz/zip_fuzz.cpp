// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <span>

#include "base/check.h"
#include "io/format.h"
#include "io/read_zip.h"
#include "io/write_zip.h"

// Any bytes end in a directory or an error; what unpacks within the limits survives being packed again.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  auto const bytes = std::as_bytes(std::span(data, size));
  static_cast<void>(inkflate::sniff_format(bytes));
  auto const entries = inkflate::read_zip_directory(bytes);
  if (!entries) return 0;
  std::vector<inkflate::ZipFile> files;
  long long unpacked = 0;
  for (auto const& entry : *entries) {
    CHECK(entry.name.find("..") == entry.name.npos || entry.name.find("../") != 0,
          "names stay in their folder");
    auto content = inkflate::unpack(entry);
    if (!content) continue;
    CHECK(content->size() == entry.size, "an entry has the size that it tells");
    unpacked += std::ssize(*content);
    files.push_back({entry.name, std::move(*content)});
  }
  CHECK(unpacked <= inkflate::ZipLimits::kUnpackedBytes, "no archive unpacks to more");
  auto const archive = inkflate::write_zip(files);
  auto const again = inkflate::read_zip_directory(archive);
  CHECK(again.has_value() && again->size() == files.size(), "a written archive reads");
  for (std::size_t i = 0; i < files.size(); ++i) {
    auto const content = inkflate::unpack((*again)[i]);
    CHECK(content.has_value() && *content == files[i].content, "a written file reads as the same");
  }
  return 0;
}
