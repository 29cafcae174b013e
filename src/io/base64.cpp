// SPDX-License-Identifier: Apache-2.0
#include "io/base64.h"

#include <algorithm>
#include <cstdint>

namespace inkflate {
namespace {

constexpr std::string_view kSigns =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// Three bytes, four signs.
constexpr std::size_t kBytes = 3;
constexpr std::size_t kDigits = 4;

}  // namespace

std::string base64_of(std::span<std::byte const> bytes) {
  std::string text;
  text.reserve((bytes.size() + kBytes - 1) / kBytes * kDigits);
  for (std::size_t i = 0; i < bytes.size(); i += kBytes) {
    std::size_t const count = std::min(kBytes, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < kBytes; ++k) {
      bits = bits << 8U | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < kDigits; ++k) {
      text += k <= count ? kSigns[bits >> 18U & 63U] : '=';
      bits <<= 6U;
    }
  }
  return text;
}

std::optional<std::vector<std::byte>> parse_base64(std::string_view text) {
  if (text.size() % kDigits != 0) return std::nullopt;
  std::size_t const padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / kDigits * kBytes);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool const is_padding = i + padding >= text.size();
    auto const digit = is_padding ? 0 : kSigns.find(text[i]);
    if (digit == kSigns.npos) return std::nullopt;
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    if (i % kDigits != kDigits - 1) continue;
    for (unsigned const shift : {16U, 8U, 0U}) {
      bytes.push_back(static_cast<std::byte>(bits >> shift));
    }
    bits = 0;
  }
  for (std::size_t i = 0; i < padding; ++i) {
    if (bytes.back() != std::byte{0}) return std::nullopt;  // bits that nothing wrote
    bytes.pop_back();
  }
  return bytes;
}

}  // namespace inkflate
