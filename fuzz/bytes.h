// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace inkflate {

/// A fuzzer's input, byte by byte; zeros after its end.
class Bytes {
 public:
  Bytes(std::uint8_t const* data, std::size_t size) : data_(data), size_(size) {}

  bool is_empty() const { return next_ >= size_; }
  std::uint8_t byte() { return is_empty() ? std::uint8_t{0} : data_[next_++]; }
  int below(int count) { return byte() % count; }
  double share() { return byte() / 255.0; }

  /// Any float at all.
  double number() {
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits = bits << 8U | byte();
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return static_cast<double>(value);
  }

 private:
  std::uint8_t const* data_;
  std::size_t size_;
  std::size_t next_ = 0;
};

}  // namespace inkflate
