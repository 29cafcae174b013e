// SPDX-License-Identifier: Apache-2.0
#include "io/write_zip.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>

#include "base/check.h"
#include "io/png_crc.h"
#include "io/stb.h"
#include "io/zip_format.h"

namespace inkflate {
namespace {

constexpr std::size_t kMostFiles = 1024;
constexpr std::size_t kMostBytes = std::size_t{1500} << 20U;
constexpr std::uint32_t kVersion = 20;       // deflate and folders
constexpr std::uint32_t kFirstDay = 0x21;    // 1 January 1980, so that no clock gets into the bytes
constexpr std::size_t kZlibHeaderBytes = 2;  // around the deflate stream
constexpr std::size_t kZlibTrailerBytes = 4;  // its checksum; zip has one of its own

struct Field {
  int bytes;
  std::uint32_t value;
};

void put(std::vector<std::byte>& archive, std::initializer_list<Field> fields) {
  for (auto const& [bytes, value] : fields) {
    for (int i = 0; i < bytes; ++i) archive.push_back(static_cast<std::byte>(value >> (8 * i)));
  }
}

void put(std::vector<std::byte>& archive, std::span<std::byte const> bytes) {
  archive.insert(archive.end(), bytes.begin(), bytes.end());
}

std::span<std::byte const> bytes_of(std::string const& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

bool is_png(std::span<std::byte const> content) {
  return content.size() > 8 && content[0] == std::byte{0x89} && content[1] == std::byte{'P'} &&
         content[2] == std::byte{'N'} && content[3] == std::byte{'G'};
}

struct Packed {
  std::uint32_t method = zip::kStored;
  std::vector<std::byte> bytes;  // empty where stored
};

Packed pack(std::span<std::byte const> content) {
  if (content.empty() || is_png(content)) return {};
  auto const stream = detail::compress_zlib(content);
  auto const deflated = std::span(stream).subspan(
      kZlibHeaderBytes, stream.size() - kZlibHeaderBytes - kZlibTrailerBytes);
  if (deflated.size() >= content.size()) return {};
  return {zip::kDeflated, {deflated.begin(), deflated.end()}};
}

std::uint32_t size32(std::size_t size) { return static_cast<std::uint32_t>(size); }

}  // namespace

std::vector<std::byte> write_zip(std::span<ZipFile const> files) {
  CHECK(files.size() <= kMostFiles, "an archive has at most 1024 files");
  std::vector<std::byte> archive;
  std::vector<std::byte> directory;
  for (auto const& file : files) {
    auto const offset = size32(archive.size());
    auto const packed = pack(file.content);
    bool const is_stored = packed.method == zip::kStored;
    std::span<std::byte const> const data = is_stored ? file.content : packed.bytes;
    bool const is_ascii = std::all_of(file.name.begin(), file.name.end(),
                                      [](char c) { return static_cast<unsigned char>(c) < 128; });
    auto const put_common = [&](std::vector<std::byte>& out) {
      put(out, {{2, kVersion}, {2, is_ascii ? 0 : zip::kUtf8Flag}, {2, packed.method}});
      put(out, {{2, 0}, {2, kFirstDay}, {4, png_crc(file.content)}, {4, size32(data.size())}});
      put(out, {{4, size32(file.content.size())}, {2, size32(file.name.size())}, {2, 0}});
    };
    put(archive, {{4, zip::kFileHeader}});
    put_common(archive);
    put(archive, bytes_of(file.name));
    put(archive, data);
    CHECK(archive.size() <= kMostBytes, "an archive has at most 1.5 GB");
    put(directory, {{4, zip::kDirectoryHeader}, {2, kVersion}});
    put_common(directory);
    put(directory, {{2, 0}, {2, 0}, {2, 0}, {4, 0}, {4, offset}});
    put(directory, bytes_of(file.name));
  }
  auto const directory_offset = size32(archive.size());
  auto const count = size32(files.size());
  put(archive, directory);
  put(archive, {{4, zip::kDirectoryEnd}, {2, 0}, {2, 0}, {2, count}, {2, count}});
  put(archive, {{4, size32(directory.size())}, {4, directory_offset}, {2, 0}});
  return archive;
}

}  // namespace inkflate
