// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace inkflate {

/// One file in an archive.
struct ZipFile {
  std::string name;  // UTF-8, '/' between folders, such as "3D/3dmodel.model"
  std::vector<std::byte> content;

  friend bool operator==(ZipFile const&, ZipFile const&) = default;
};

/// A zip archive with these files in this order; the same bytes on every machine and at any time.
///
/// in      at most 1024 files with distinct names, each and all of them below 1.5 GB
/// out     PNG files are stored, as they are packed already, and so is what deflate does not make smaller
/// cost    O(bytes)
/// source  PKWARE APPNOTE 6.3.3
std::vector<std::byte> write_zip(std::span<ZipFile const> files);

}  // namespace inkflate
