// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace inkflate {

/// What an archive may ask for; see docs/LIMITS.md.
struct ZipLimits {
  static constexpr long long kEntries = 1024;
  static constexpr long long kUnpackedBytes = 512LL << 20U;  // of all entries together
};

/// One file of an archive, still packed.
struct ZipEntry {
  std::string name;  // relative, '/' between folders, without "..", without control characters
  std::uint32_t size = 0;  // unpacked, bytes
  std::uint32_t crc = 0;
  std::uint32_t method = 0;  // 0 stored, 8 deflated, or one that we do not unpack
  bool is_encrypted = false;
  std::span<std::byte const> packed;  // points into the archive
};

/// Lists an archive without unpacking anything.
///
/// in      archive: the whole file; it must outlive the entries
/// out     entries in the order of the directory, folders left out. Bytes after the archive are ignored
/// errors  BadInput (damaged; entries that overlap or have the same name; a name that leaves the folder), TooLarge
///         (ZipLimits), Unsupported (zip64, several disks)
/// cost    O(entries log entries + bytes after the archive)
/// source  PKWARE APPNOTE 6.3.3
Result<std::vector<ZipEntry>> read_zip_directory(std::span<std::byte const> archive);

/// The content of an entry; its size and checksum are checked.
///
/// errors  BadInput (damaged, or not of the size that it claims), Unsupported (encrypted, or another method)
/// cost    O(bytes)
Result<std::vector<std::byte>> unpack(ZipEntry const& entry);

/// The entry of this name; null: there is none.
ZipEntry const* find_entry(std::span<ZipEntry const> entries, std::string_view name);

}  // namespace inkflate
