// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace inkflate {

/// Reads the bits of a byte string that lies in several pieces, lowest bit first. Past the end it gives zeros and
/// remembers that it did.
class BitReader {
 public:
  explicit BitReader(std::vector<std::span<std::byte const>> pieces) : pieces_(std::move(pieces)) {}

  /// The next count bits (0 .. 32), without taking them.
  std::uint32_t peek(int count) {
    while (held_ < count) refill();
    return static_cast<std::uint32_t>(bits_ & ((std::uint64_t{1} << count) - 1));
  }
  void drop(int count) {
    bits_ >>= count;
    held_ -= count;
  }
  std::uint32_t take(int count) {
    auto const value = peek(count);
    drop(count);
    return value;
  }
  void align_to_byte() { drop(held_ % 8); }
  /// Whether bits were taken that are not there.
  bool is_past_end() const { return held_ < 8 * missing_bytes_; }

 private:
  void refill();

  std::vector<std::span<std::byte const>> pieces_;
  std::size_t piece_ = 0;
  std::size_t offset_ = 0;
  std::uint64_t bits_ = 0;
  int held_ = 0;
  int missing_bytes_ = 0;  // zero bytes made up at the end that are still held or were taken
};

/// A canonical prefix code (RFC 1951, section 3.2.2).
class PrefixCode {
 public:
  static constexpr int kLongestCode = 15;

  /// lengths: bits of each symbol's code, 0: unused. False: more codes than there is room for, or gaps in a code of
  /// more than one symbol.
  [[nodiscard]] bool build(std::span<std::uint8_t const> lengths);
  /// The next symbol; -1: no such code.
  int next(BitReader& bits) const;

 private:
  static constexpr int kFastBits = 10;
  struct Entry {
    std::int16_t symbol = -1;
    std::int16_t length = 0;
  };

  std::array<Entry, 1 << kFastBits> fast_;  // by the next bits, for codes that are short enough
  std::array<int, kLongestCode + 1> count_;
  std::array<std::int16_t, 288> symbols_;  // by code
};

/// What is around the packed data.
enum class DeflateFrame {
  Zlib,  // a header and a checksum (RFC 1950), as in PNG
  None,  // nothing (RFC 1951), as in zip archives
};

/// Unpacks a zlib or deflate stream (RFC 1950, 1951) step by step into memory that the caller gives: however far a stream would
/// expand, nothing but its 32 kB window is held.
class ZlibReader {
 public:
  explicit ZlibReader(std::vector<std::span<std::byte const>> pieces,
                      DeflateFrame frame = DeflateFrame::Zlib)
      : bits_(std::move(pieces)),
        frame_(frame),
        state_(frame == DeflateFrame::Zlib ? State::Header : State::BlockStart) {}

  /// Fills out with the next bytes. False: the stream is damaged or ends too early; then it stays so.
  [[nodiscard]] bool read(std::span<std::uint8_t> out);

  /// Whether the stream ends here and its checksum, where it has one, is right.
  [[nodiscard]] bool finish();

 private:
  enum class State { Header, BlockStart, Stored, Codes, End, Bad };

  void step(std::span<std::uint8_t>& out);
  void read_header();
  void start_block();
  void start_stored();
  [[nodiscard]] bool read_fixed_codes();
  [[nodiscard]] bool read_dynamic_codes();
  void end_block() { state_ = is_last_block_ ? State::End : State::BlockStart; }
  void copy_stored(std::span<std::uint8_t>& out);
  void read_symbols(std::span<std::uint8_t>& out);
  void start_match(int length_symbol);
  void copy_match(std::span<std::uint8_t>& out);
  void put(std::span<std::uint8_t>& out, std::uint8_t byte);

  BitReader bits_;
  DeflateFrame frame_;
  State state_;
  bool is_last_block_ = false;
  int left_ = 0;  // bytes of the stored block, or of the match
  std::uint32_t distance_ = 0;
  PrefixCode literals_;
  PrefixCode distances_;
  std::array<std::uint8_t, 32768> window_{};
  std::uint64_t total_ = 0;
  std::uint32_t adler_low_ = 1;
  std::uint32_t adler_high_ = 0;
};

}  // namespace inkflate
