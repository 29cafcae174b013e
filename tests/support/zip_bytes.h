// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/png_crc.h"
#include "support/png_bytes.h"

namespace inkflate::test {

/// An entry of an archive that may lie about itself. Stored, unless told otherwise.
struct RawZipEntry {
  std::string name;
  Bytes data;  // as it lies in the archive
  int method = 0;
  int flags = 0;
  std::optional<std::uint32_t> size = {};  // unpacked; none: that of the data
  std::optional<std::uint32_t> crc = {};
  std::optional<std::uint32_t> offset = {};       // of the header; none: the truth
  std::optional<std::string> local_name = {};     // in the header before the data
  std::optional<std::uint32_t> packed_size = {};  // in the directory
};

inline Bytes bytes_of(std::string_view text) {
  Bytes bytes;
  for (char const sign : text) bytes.push_back(static_cast<std::byte>(sign));
  return bytes;
}

inline void put_little(Bytes& bytes, int count, std::uint32_t value) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::byte>(value >> (8 * i)));
}

/// An archive made by hand, without the writer under test. claimed_count: as the end of the directory says it.
inline Bytes raw_zip(std::vector<RawZipEntry> const& entries,
                     std::optional<std::uint32_t> claimed_count = {}) {
  Bytes archive;
  Bytes directory;
  for (auto const& entry : entries) {
    auto const true_size = static_cast<std::uint32_t>(entry.data.size());
    auto const start = static_cast<std::uint32_t>(archive.size());
    auto const put_common = [&](Bytes& bytes, std::string const& name) {
      put_little(bytes, 2, 20);
      put_little(bytes, 2, static_cast<std::uint32_t>(entry.flags));
      put_little(bytes, 2, static_cast<std::uint32_t>(entry.method));
      put_little(bytes, 4, 0);
      put_little(bytes, 4, entry.crc.value_or(png_crc(entry.data)));
      put_little(bytes, 4, entry.packed_size.value_or(true_size));
      put_little(bytes, 4, entry.size.value_or(true_size));
      put_little(bytes, 2, static_cast<std::uint32_t>(name.size()));
      put_little(bytes, 2, 0);
    };
    auto const local_name = entry.local_name.value_or(entry.name);
    put_little(archive, 4, 0x04034b50);
    put_common(archive, local_name);
    put(archive, bytes_of(local_name));
    put(archive, entry.data);
    put_little(directory, 4, 0x02014b50);
    put_little(directory, 2, 20);
    put_common(directory, entry.name);
    for (int i = 0; i < 10; ++i) directory.push_back(std::byte{0});
    put_little(directory, 4, entry.offset.value_or(start));
    put(directory, bytes_of(entry.name));
  }
  auto const count = claimed_count.value_or(static_cast<std::uint32_t>(entries.size()));
  auto const offset = static_cast<std::uint32_t>(archive.size());
  put(archive, directory);
  put_little(archive, 4, 0x06054b50);
  put_little(archive, 4, 0);
  put_little(archive, 2, count);
  put_little(archive, 2, count);
  put_little(archive, 4, static_cast<std::uint32_t>(directory.size()));
  put_little(archive, 4, offset);
  put_little(archive, 2, 0);
  return archive;
}

}  // namespace inkflate::test
