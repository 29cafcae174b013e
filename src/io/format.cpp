// SPDX-License-Identifier: Apache-2.0
#include "io/format.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/check.h"
#include "io/byte_order.h"
#include "io/journal.h"
#include "io/numbers.h"
#include "io/project_files.h"
#include "io/read_zip.h"

namespace inkflate {
namespace {

// Comments and a document type may stand before the root element, but not a whole file of them.
constexpr std::size_t kLookedAt = 65'536;

bool is_utf16(std::string_view text) {
  auto const mark = text.substr(0, 2);
  return mark == "\xff\xfe" || mark == "\xfe\xff";
}

std::string without_zeros(std::string_view text) {
  std::string clean;
  for (char const c : text) {
    if (c != '\0') clean += c;
  }
  return clean;
}

bool looks_like_svg(std::string_view text) {
  if (text.substr(0, 1) != "<") return false;
  return text.find("<svg") != std::string_view::npos || text.find(":svg") != std::string_view::npos;
}

bool looks_like_scap(std::string_view text) {
  if (text.empty()) return false;
  char const first = text.front();
  auto const rest = trimmed(text.substr(1, 100));
  if (rest.empty()) return false;
  if (first == '#' || first == '@') return is_digit(rest.front());
  return first == '{' && (rest.front() == '#' || rest.front() == '@');
}

/// The name of an archive's file without its folders, in small letters.
std::string file_name(std::string_view path) {
  auto const slash = path.rfind('/');
  return lower_ascii(slash == path.npos ? path : path.substr(slash + 1));
}

FileFormat sniff_zip(std::span<std::byte const> bytes) {
  auto const entries = read_zip_directory(bytes);
  if (!entries) return FileFormat::Zip;
  auto const has = [&](auto const& is_wanted) {
    return std::any_of(entries->begin(), entries->end(),
                       [&](ZipEntry const& entry) { return is_wanted(entry.name); });
  };
  // One that has our document beside it is still a Monster Mash project.
  if (has([](std::string_view name) {
        return file_name(name) == "_org_000.png" || file_name(name) == "_seg_000.png";
      })) {
    return FileFormat::MonsterMash;
  }
  if (find_entry(*entries, kDocumentFile) != nullptr) return FileFormat::Inkflate;
  bool const is_3mf =
      has([](std::string_view name) { return lower_ascii(name) == "3d/3dmodel.model"; });
  return is_3mf ? FileFormat::ThreeMf : FileFormat::Zip;
}

// Its first 80 bytes may be anything; then comes the number of triangles, of 50 bytes each.
bool is_binary_stl(std::span<std::byte const> bytes) {
  if (bytes.size() < 84) return false;
  return bytes.size() - 84 == std::uint64_t{50} * little_endian32(bytes.subspan(80));
}

bool looks_like_text_stl(std::string_view text) {
  return text.substr(0, 5) == "solid" && text.size() > 5 && is_blank(text[5]);
}

bool looks_like_obj(std::string_view text) {
  while (!text.empty()) {
    auto const line = trimmed(text.substr(0, text.find('\n')));
    auto const word = line.substr(0, line.find_first_of(" \t"));
    for (std::string_view const known : {"v", "vt", "vn", "o", "g", "mtllib", "usemtl"}) {
      if (word == known && word.size() < line.size()) return true;
    }
    if (!line.empty() && line.front() != '#') return false;
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  return false;
}

}  // namespace

FileFormat sniff_format(std::span<std::byte const> bytes) {
  std::string_view text(reinterpret_cast<char const*>(bytes.data()), bytes.size());
  text = text.substr(0, kLookedAt);
  if (text.substr(0, 8) == "\x89PNG\r\n\x1a\n") return FileFormat::Png;
  if (text.substr(0, 3) == "\xff\xd8\xff") return FileFormat::Jpeg;
  auto const magic = text.substr(0, 4);
  if (magic == "PK\x03\x04" || magic == "PK\x05\x06") return sniff_zip(bytes);
  if (magic == "glTF") return FileFormat::Glb;
  if (is_journal(bytes)) return FileFormat::Journal;
  // UTF-16 is told apart too, so that the SVG reader can say what is wrong with it.
  auto const plain = is_utf16(text) ? without_zeros(text.substr(2)) : std::string();
  if (!plain.empty()) text = plain;
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  text = trimmed(text);
  if (looks_like_svg(text)) return FileFormat::Svg;
  if (looks_like_scap(text)) return FileFormat::Scap;
  if (is_binary_stl(bytes) || looks_like_text_stl(text)) return FileFormat::Stl;
  return looks_like_obj(text) ? FileFormat::Obj : FileFormat::Unknown;
}

char const* file_format_name(FileFormat format) {
  switch (format) {
    case FileFormat::Svg:
      return "SVG";
    case FileFormat::Scap:
      return ".scap";
    case FileFormat::Png:
      return "PNG";
    case FileFormat::Jpeg:
      return "JPEG";
    case FileFormat::Inkflate:
      return ".inkflate";
    case FileFormat::MonsterMash:
      return "Monster Mash";
    case FileFormat::ThreeMf:
      return "3MF";
    case FileFormat::Zip:
      return "zip";
    case FileFormat::Journal:
      return "journal";
    case FileFormat::Glb:
      return "GLB";
    case FileFormat::Obj:
      return "OBJ";
    case FileFormat::Stl:
      return "STL";
    case FileFormat::Unknown:
      return "unknown";
  }
  CHECK(false, "unknown file format");
}

}  // namespace inkflate
