// SPDX-License-Identifier: Apache-2.0
#include "io/read_zip.h"

#include <algorithm>
#include <optional>

#include "io/byte_order.h"
#include "io/numbers.h"
#include "io/png_crc.h"
#include "io/zip_format.h"
#include "io/zlib_reader.h"

namespace inkflate {
namespace {

using Bytes = std::span<std::byte const>;

constexpr std::uint32_t kIsInZip64 = 0xffffffff;
// A match of 258 bytes takes two bits at least, so deflate makes nothing smaller than by this factor.
constexpr std::uint64_t kMostExpansion = 1032;

struct Directory {
  std::uint32_t count = 0;
  Bytes headers;
};

/// Where an entry's header and data lie, bytes.
struct Extent {
  std::size_t from = 0;
  std::size_t to = 0;
};

Error damaged(std::string const& what, std::size_t at) {
  return {ErrorCode::BadInput, "the zip archive is damaged: " + what, static_cast<long long>(at)};
}

/// The directory's end lies behind everything but a comment, so the last one that makes sense is it.
Result<Directory> find_directory(Bytes archive) {
  std::string_view const text(reinterpret_cast<char const*>(archive.data()), archive.size());
  for (auto at = text.rfind("PK\5\6"); at != text.npos;
       at = at == 0 ? text.npos : text.rfind("PK\5\6", at - 1)) {
    if (archive.size() - at < zip::kDirectoryEndBytes) continue;
    auto const end = archive.subspan(at);
    auto const disk = little_endian16(end.subspan(4));
    auto const count_here = little_endian16(end.subspan(8));
    auto const count = little_endian16(end.subspan(10));
    std::size_t const size = little_endian32(end.subspan(12));
    std::size_t const offset = little_endian32(end.subspan(16));
    bool const is_zip64 = count == 0xffff || size == kIsInZip64 || offset == kIsInZip64;
    if (is_zip64) return Error{ErrorCode::Unsupported, "zip64 archives are not read"};
    if (offset > at || size > at - offset) continue;
    if (disk != 0 || count_here != count) {
      return Error{ErrorCode::Unsupported, "archives on several disks are not read"};
    }
    if (count > ZipLimits::kEntries) {
      return Error{ErrorCode::TooLarge, "the zip archive has more than 1024 entries"};
    }
    return Directory{count, archive.subspan(offset, size)};
  }
  return Error{ErrorCode::BadInput, "the zip archive has no directory; it may be cut off"};
}

bool is_letter(char c) { return lower_ascii(c) >= 'a' && lower_ascii(c) <= 'z'; }

/// Whether the name stays in the folder where the archive would be unpacked, on every system.
bool is_safe(std::string_view name) {
  bool const is_absolute = name.substr(0, 1) == "/";
  bool const has_drive = name.size() > 1 && name[1] == ':' && is_letter(name[0]);
  bool const has_control = std::any_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) < 32 || c == 127;
  });
  if (name.empty() || is_absolute || has_drive || has_control) return false;
  while (!name.empty()) {
    auto const part = name.substr(0, name.find('/'));
    if (part == "..") return false;
    name.remove_prefix(std::min(part.size() + 1, name.size()));
  }
  return true;
}

/// Some programs write the separator of Windows.
std::string with_slashes(std::string_view name) {
  std::string result(name);
  std::replace(result.begin(), result.end(), '\\', '/');
  return result;
}

std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
}

/// Reads the entries of a directory one by one.
class DirectoryReader {
 public:
  DirectoryReader(Bytes archive, Directory const& directory)
      : archive_(archive),
        count_(directory.count),
        rest_(directory.headers),
        directory_start_(position()) {}

  Result<std::vector<ZipEntry>> read() && {
    for (std::uint32_t i = 0; i < count_; ++i) {
      if (auto const error = read_entry()) return *error;
    }
    if (auto const error = check_together()) return *error;
    // Folders hold nothing.
    std::erase_if(entries_, [](ZipEntry const& entry) { return entry.name.back() == '/'; });
    return std::move(entries_);
  }

 private:
  std::size_t position() const { return static_cast<std::size_t>(rest_.data() - archive_.data()); }

  std::optional<Error> read_entry() {
    std::size_t const at = position();
    if (rest_.size() < zip::kDirectoryHeaderBytes ||
        little_endian32(rest_) != zip::kDirectoryHeader) {
      return damaged("its directory is cut off", at);
    }
    std::size_t const name_size = little_endian16(rest_.subspan(28));
    std::size_t const whole = zip::kDirectoryHeaderBytes + name_size +
                              little_endian16(rest_.subspan(30)) +
                              little_endian16(rest_.subspan(32));
    if (rest_.size() < whole) return damaged("its directory is cut off", at);
    auto const raw_name = text_of(rest_.subspan(zip::kDirectoryHeaderBytes, name_size));
    ZipEntry entry;
    entry.name = with_slashes(raw_name);
    if (!is_safe(entry.name)) {
      return Error{ErrorCode::BadInput,
                   "the zip archive has a file whose name leads out of its folder",
                   static_cast<long long>(at)};
    }
    entry.is_encrypted = (little_endian16(rest_.subspan(8)) & zip::kEncryptedFlags) != 0;
    entry.method = little_endian16(rest_.subspan(10));
    entry.crc = little_endian32(rest_.subspan(16));
    entry.size = little_endian32(rest_.subspan(24));
    auto const packed_size = little_endian32(rest_.subspan(20));
    auto const offset = little_endian32(rest_.subspan(42));
    if (entry.size == kIsInZip64 || packed_size == kIsInZip64 || offset == kIsInZip64) {
      return Error{ErrorCode::Unsupported, "zip64 archives are not read"};
    }
    unpacked_bytes_ += entry.size;
    if (unpacked_bytes_ > ZipLimits::kUnpackedBytes) {
      return Error{ErrorCode::TooLarge, "the zip archive holds more than 512 MB"};
    }
    if (auto error = find_data(raw_name, offset, packed_size, entry)) return error;
    entries_.push_back(std::move(entry));
    rest_ = rest_.subspan(whole);
    return std::nullopt;
  }

  /// The header before the data says most things again; programs may leave sizes out there.
  std::optional<Error> find_data(std::string_view raw_name, std::size_t offset,
                                 std::size_t packed_size, ZipEntry& entry) {
    if (offset > archive_.size() || archive_.size() - offset < zip::kFileHeaderBytes) {
      return damaged("an entry lies outside of it", position());
    }
    auto const header = archive_.subspan(offset);
    std::size_t const name_size = little_endian16(header.subspan(26));
    std::size_t const start =
        zip::kFileHeaderBytes + name_size + little_endian16(header.subspan(28));
    if (little_endian32(header) != zip::kFileHeader || header.size() < start ||
        header.size() - start < packed_size) {
      return damaged("an entry lies outside of it", offset);
    }
    bool const is_same = text_of(header.subspan(zip::kFileHeaderBytes, name_size)) == raw_name &&
                         little_endian16(header.subspan(8)) == entry.method;
    if (!is_same) return damaged("an entry contradicts the directory", offset);
    if (offset + start + packed_size > directory_start_) {
      return damaged("an entry reaches into the directory", offset);
    }
    entry.packed = header.subspan(start, packed_size);
    extents_.push_back({offset, offset + start + packed_size});
    return std::nullopt;
  }

  /// Entries that share bytes are how small archives unpack to huge ones; equal names are how programs are made to
  /// see different content.
  std::optional<Error> check_together() {
    std::sort(extents_.begin(), extents_.end(),
              [](Extent const& a, Extent const& b) { return a.from < b.from; });
    for (std::size_t i = 1; i < extents_.size(); ++i) {
      if (extents_[i].from < extents_[i - 1].to) {
        return damaged("entries overlap", extents_[i].from);
      }
    }
    std::vector<std::string_view> names;
    for (auto const& entry : entries_) names.push_back(entry.name);
    std::sort(names.begin(), names.end());
    if (std::adjacent_find(names.begin(), names.end()) == names.end()) return std::nullopt;
    return damaged("two entries have the same name", 0);
  }

  Bytes archive_;
  std::uint32_t count_;
  Bytes rest_;  // of the directory
  std::size_t directory_start_;
  std::vector<ZipEntry> entries_;
  std::vector<Extent> extents_;
  long long unpacked_bytes_ = 0;
};

std::string quoted(ZipEntry const& entry) { return "\"" + entry.name + "\" in the zip archive"; }

}  // namespace

Result<std::vector<ZipEntry>> read_zip_directory(std::span<std::byte const> archive) {
  auto const directory = find_directory(archive);
  if (!directory) return directory.error();
  return DirectoryReader(archive, *directory).read();
}

Result<std::vector<std::byte>> unpack(ZipEntry const& entry) {
  if (entry.is_encrypted) return Error{ErrorCode::Unsupported, quoted(entry) + " is encrypted"};
  bool const is_deflated = entry.method == zip::kDeflated;
  if (!is_deflated && entry.method != zip::kStored) {
    return Error{ErrorCode::Unsupported, quoted(entry) + " is packed in a way that we do not read"};
  }
  Error const wrong = {ErrorCode::BadInput, quoted(entry) + " is damaged"};
  bool const is_possible = is_deflated ? entry.size <= entry.packed.size() * kMostExpansion
                                       : entry.size == entry.packed.size();
  if (!is_possible) return wrong;
  std::vector<std::byte> content(entry.packed.begin(), entry.packed.end());
  if (is_deflated) {
    content.assign(entry.size, std::byte{0});
    ZlibReader reader({entry.packed}, DeflateFrame::None);
    auto* const first = reinterpret_cast<std::uint8_t*>(content.data());
    if (!reader.read({first, content.size()}) || !reader.finish()) return wrong;
  }
  if (png_crc(content) != entry.crc) return wrong;
  return content;
}

ZipEntry const* find_entry(std::span<ZipEntry const> entries, std::string_view name) {
  auto const found = std::find_if(entries.begin(), entries.end(),
                                  [&](ZipEntry const& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace inkflate
