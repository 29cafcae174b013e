// SPDX-License-Identifier: Apache-2.0
#include "io/xml_text.h"

#include <utility>

#include "io/numbers.h"

namespace inkflate {
namespace {

// The code point of a reference's body (between '&' and ';'), or -1.
long reference_value(std::string_view body) {
  constexpr std::pair<std::string_view, char> named[] = {
      {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
  for (auto const& [name, value] : named) {
    if (body == name) return value;
  }
  if (body.size() < 2 || body[0] != '#') return -1;
  bool const is_hex = body[1] == 'x';
  body.remove_prefix(is_hex ? 2 : 1);
  long value = 0;
  for (char const c : body) {
    char const lower = lower_ascii(c);
    bool const is_letter = is_hex && lower >= 'a' && lower <= 'f';
    if (!is_digit(c) && !is_letter) return -1;
    value = value * (is_hex ? 16 : 10) + (is_letter ? lower - 'a' + 10 : c - '0');
    if (value > 0x10ffff) return -1;
  }
  bool const is_surrogate = value >= 0xd800 && value <= 0xdfff;
  return body.empty() || value == 0 || is_surrogate ? -1 : value;
}

constexpr std::size_t kLongestReference = 16;

void append_utf8(std::string& text, long code) {
  auto const byte = [&](long lead, unsigned shift, long mask) {
    text += static_cast<char>(lead | ((code >> shift) & mask));
  };
  if (code < 0x80) return byte(0, 0, 0x7f);
  if (code < 0x800) {
    byte(0xc0, 6, 0x1f);
  } else if (code < 0x10000) {
    byte(0xe0, 12, 0x0f);
    byte(0x80, 6, 0x3f);
  } else {
    byte(0xf0, 18, 0x07);
    byte(0x80, 12, 0x3f);
    byte(0x80, 6, 0x3f);
  }
  byte(0x80, 0, 0x3f);
}

// The character at the front of the text: its code and bytes; a code of -1 where it is not valid.
std::pair<long, std::size_t> first_character(std::string_view text) {
  auto const byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  unsigned const lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  std::size_t const size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < size) return {-1, 1};
  long code = static_cast<long>(lead & (0x7fU >> size));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return {-1, 1};
    code = (code << 6U) | static_cast<long>(byte(i) & 0x3fU);
  }
  constexpr long smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  bool const is_surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < smallest[size] || code > 0x10ffff || is_surrogate) return {-1, 1};
  return {code, size};
}

bool is_xml_character(long code) {
  return code >= 0x20 ? code != 0xfffe && code != 0xffff
                      : code == '\t' || code == '\n' || code == '\r';
}

}  // namespace

std::size_t bad_reference(std::string_view raw) {
  for (auto at = raw.find('&'); at != std::string_view::npos; at = raw.find('&', at + 1)) {
    auto const size = raw.substr(at + 1, kLongestReference).find(';');
    if (size == std::string_view::npos || reference_value(raw.substr(at + 1, size)) < 0) return at;
  }
  return std::string_view::npos;
}

std::string decode_xml(std::string_view raw) {
  std::string text;
  text.reserve(raw.size());
  for (std::size_t at = 0; at < raw.size(); ++at) {
    auto const size = raw[at] == '&' ? raw.substr(at + 1, kLongestReference).find(';') : raw.npos;
    long const value = size == raw.npos ? -1 : reference_value(raw.substr(at + 1, size));
    if (value >= 0) {
      append_utf8(text, value);
      at += size + 1;
    } else {
      text += is_blank(raw[at]) ? ' ' : raw[at];
    }
  }
  return text;
}

std::string clean_utf8(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    auto const [code, size] = first_character(text);
    append_utf8(clean, code >= 0 && is_xml_character(code) ? code : 0xfffd);
    text.remove_prefix(size);
  }
  return clean;
}

std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (char const c : clean_utf8(text)) {
    bool const is_special = c == '&' || c == '<' || c == '>' || c == '"' || c == '\'' ||
                            c == '\t' || c == '\n' || c == '\r';
    if (is_special) {
      escaped += "&#" + std::to_string(static_cast<int>(c)) + ';';
    } else {
      escaped += c;
    }
  }
  return escaped;
}

}  // namespace inkflate
