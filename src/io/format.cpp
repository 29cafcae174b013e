// SPDX-License-Identifier: Apache-2.0
#include "io/format.h"

#include <string>
#include <string_view>

#include "base/check.h"
#include "io/numbers.h"

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

}  // namespace

FileFormat sniff_format(std::span<std::byte const> bytes) {
  std::string_view text(reinterpret_cast<char const*>(bytes.data()), bytes.size());
  text = text.substr(0, kLookedAt);
  if (text.substr(0, 8) == "\x89PNG\r\n\x1a\n") return FileFormat::Png;
  if (text.substr(0, 3) == "\xff\xd8\xff") return FileFormat::Jpeg;
  auto const magic = text.substr(0, 4);
  if (magic == "PK\x03\x04" || magic == "PK\x05\x06") return FileFormat::Zip;
  // UTF-16 is told apart too, so that the SVG reader can say what is wrong with it.
  auto const plain = is_utf16(text) ? without_zeros(text.substr(2)) : std::string();
  if (!plain.empty()) text = plain;
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  text = trimmed(text);
  if (looks_like_svg(text)) return FileFormat::Svg;
  return looks_like_scap(text) ? FileFormat::Scap : FileFormat::Unknown;
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
    case FileFormat::Zip:
      return "zip";
    case FileFormat::Unknown:
      return "unknown";
  }
  CHECK(false, "unknown file format");
}

}  // namespace inkflate
