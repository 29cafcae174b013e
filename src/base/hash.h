// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace inkflate {

/// FNV-1a, 64 bit: equal on every machine for equal bytes. Not for security.
class Hash {
 public:
  void add(std::span<std::byte const> bytes) {
    for (auto const byte : bytes) {
      value_ = (value_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3U;
    }
  }

  void add(std::int64_t number) {
    auto const bits = static_cast<std::uint64_t>(number);
    for (unsigned shift = 0; shift < 64U; shift += 8U) {  // by shifts: byte order does not matter
      value_ = (value_ ^ ((bits >> shift) & 0xffU)) * 0x100000001b3U;
    }
  }

  /// The exact bits of the number; -0 counts as 0.
  void add(double number) {
    double const clean = number + 0.0;
    std::int64_t bits = 0;
    std::memcpy(&bits, &clean, sizeof bits);
    add(bits);
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace inkflate
