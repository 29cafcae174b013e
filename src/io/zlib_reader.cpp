// SPDX-License-Identifier: Apache-2.0
#include "io/zlib_reader.h"

#include <algorithm>

namespace inkflate {
namespace {

constexpr std::uint32_t kAdlerBase = 65521;
constexpr std::uint32_t kWindowMask = 32767;
constexpr int kEndOfBlock = 256;

// Length and distance codes: base value and number of extra bits (RFC 1951, section 3.2.5).
constexpr std::array<int, 29> kLengthBase = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                             15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                             67, 83, 99, 115, 131, 163, 195, 227, 258};
constexpr std::array<int, 29> kLengthExtra = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                              2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
constexpr std::array<std::uint32_t, 30> kDistanceBase = {
    1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
    193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
constexpr std::array<int, 30> kDistanceExtra = {0, 0, 0,  0,  1,  1,  2,  2,  3,  3,
                                                4, 4, 5,  5,  6,  6,  7,  7,  8,  8,
                                                9, 9, 10, 10, 11, 11, 12, 12, 13, 13};
// The order in which a dynamic block lists the lengths of its length codes (section 3.2.7).
constexpr std::array<std::size_t, 19> kLengthOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                      11, 4,  12, 3, 13, 2, 14, 1, 15};

std::uint32_t reversed(std::uint32_t code, int length) {
  std::uint32_t result = 0;
  for (int i = 0; i < length; ++i) result |= ((code >> i) & 1U) << (length - 1 - i);
  return result;
}

}  // namespace

void BitReader::refill() {
  while (piece_ < pieces_.size() && offset_ == pieces_[piece_].size()) {
    ++piece_;
    offset_ = 0;
  }
  if (piece_ < pieces_.size()) {
    bits_ |= static_cast<std::uint64_t>(pieces_[piece_][offset_++]) << held_;
  } else {
    // Held zeros cannot grow beyond the 64 bits, and taken ones stop the caller.
    missing_bytes_ = std::min(missing_bytes_ + 1, 1000);
  }
  held_ += 8;
}

bool PrefixCode::build(std::span<std::uint8_t const> lengths) {
  fast_.fill({});
  count_.fill(0);
  for (auto const length : lengths) ++count_[length];
  count_[0] = 0;
  std::array<std::uint32_t, kLongestCode + 2> next_code{};
  std::array<int, kLongestCode + 2> offset{};
  int used = 0;
  std::uint32_t code = 0;
  for (std::size_t length = 1; length <= kLongestCode; ++length) {
    code = (code + static_cast<std::uint32_t>(count_[length - 1])) << 1U;
    next_code[length] = code;
    offset[length] = used;
    used += count_[length];
    if (code + static_cast<std::uint32_t>(count_[length]) > (1U << length)) return false;
  }
  // One code alone may be incomplete: a block with a single distance (section 3.2.7).
  if (used > 1 && code + static_cast<std::uint32_t>(count_[kLongestCode]) != 1U << kLongestCode) {
    return false;
  }
  for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
    auto const length = lengths[symbol];
    if (length == 0) continue;
    symbols_[static_cast<std::size_t>(offset[length]++)] = static_cast<std::int16_t>(symbol);
    auto const bits = reversed(next_code[length]++, length);
    if (length > kFastBits) continue;
    for (std::uint32_t i = bits; i < fast_.size(); i += 1U << length) {
      fast_[i] = {static_cast<std::int16_t>(symbol), static_cast<std::int16_t>(length)};
    }
  }
  return true;
}

int PrefixCode::next(BitReader& bits) const {
  auto const ahead = bits.peek(kLongestCode);
  auto const entry = fast_[ahead & ((1U << kFastBits) - 1)];
  if (entry.length > 0) {
    bits.drop(entry.length);
    return entry.symbol;
  }
  int code = 0;
  int first = 0;
  int index = 0;
  for (int length = 1; length <= kLongestCode; ++length) {
    int const count = count_[static_cast<std::size_t>(length)];
    code |= static_cast<int>((ahead >> (length - 1)) & 1U);
    if (code - first < count) {
      bits.drop(length);
      return symbols_[static_cast<std::size_t>(index + code - first)];
    }
    index += count;
    first = (first + count) << 1;
    code <<= 1;
  }
  return -1;
}

bool ZlibReader::read(std::span<std::uint8_t> out) {
  while (!out.empty() && state_ != State::End && state_ != State::Bad) step(out);
  return out.empty();
}

bool ZlibReader::finish() {
  std::uint8_t extra = 0;
  if (read(std::span(&extra, 1)) || state_ != State::End) return false;
  if (frame_ == DeflateFrame::None) return !bits_.is_past_end();
  bits_.align_to_byte();
  std::uint32_t checksum = 0;
  for (int i = 0; i < 4; ++i) checksum = checksum << 8U | bits_.take(8);
  return !bits_.is_past_end() && checksum == (adler_high_ << 16U | adler_low_);
}

void ZlibReader::step(std::span<std::uint8_t>& out) {
  switch (state_) {
    case State::Header:
      read_header();
      break;
    case State::BlockStart:
      start_block();
      break;
    case State::Stored:
      copy_stored(out);
      break;
    case State::Codes:
      read_symbols(out);
      break;
    case State::End:
    case State::Bad:
      break;
  }
  if (bits_.is_past_end()) state_ = State::Bad;
}

void ZlibReader::read_header() {
  auto const method = bits_.take(8);
  auto const flags = bits_.take(8);
  bool const is_deflate = (method & 15U) == 8 && (method >> 4U) <= 7;
  bool const is_whole = (method * 256 + flags) % 31 == 0 && (flags & 32U) == 0;
  state_ = is_deflate && is_whole ? State::BlockStart : State::Bad;
}

void ZlibReader::start_block() {
  is_last_block_ = bits_.take(1) != 0;
  left_ = 0;
  bool is_good = false;
  switch (bits_.take(2)) {
    case 0:
      start_stored();
      return;
    case 1:
      is_good = read_fixed_codes();
      break;
    case 2:
      is_good = read_dynamic_codes();
      break;
    default:
      break;
  }
  state_ = is_good ? State::Codes : State::Bad;
}

void ZlibReader::start_stored() {
  bits_.align_to_byte();
  auto const length = bits_.take(16);
  auto const complement = bits_.take(16);
  left_ = static_cast<int>(length);
  state_ = (length ^ 0xffffU) == complement ? State::Stored : State::Bad;
}

bool ZlibReader::read_fixed_codes() {
  std::array<std::uint8_t, 288> lengths{};
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
  }
  std::array<std::uint8_t, 32> distance_lengths{};
  distance_lengths.fill(5);
  return literals_.build(lengths) && distances_.build(distance_lengths);
}

bool ZlibReader::read_dynamic_codes() {
  auto const literal_count = bits_.take(5) + 257;
  auto const distance_count = bits_.take(5) + 1;
  auto const length_count = bits_.take(4) + 4;
  if (literal_count > 286 || distance_count > 30) return false;
  std::array<std::uint8_t, 320> lengths{};
  for (std::uint32_t i = 0; i < length_count; ++i) {
    lengths[kLengthOrder[i]] = static_cast<std::uint8_t>(bits_.take(3));
  }
  PrefixCode length_code;
  if (!length_code.build(std::span(lengths).first(19))) return false;
  lengths.fill(0);
  std::uint32_t const count = literal_count + distance_count;
  for (std::uint32_t i = 0; i < count;) {
    int const symbol = length_code.next(bits_);
    if (symbol < 0 || bits_.is_past_end() || (symbol == 16 && i == 0)) return false;
    std::uint8_t value = symbol == 16 ? lengths[i - 1] : 0;
    std::uint32_t repeat = 1;
    if (symbol < 16) value = static_cast<std::uint8_t>(symbol);
    if (symbol == 16) repeat = 3 + bits_.take(2);
    if (symbol == 17) repeat = 3 + bits_.take(3);
    if (symbol == 18) repeat = 11 + bits_.take(7);
    if (i + repeat > count) return false;
    for (; repeat > 0; --repeat) lengths[i++] = value;
  }
  auto const all = std::span<std::uint8_t const>(lengths);
  return lengths[kEndOfBlock] != 0 && literals_.build(all.first(literal_count)) &&
         distances_.build(all.subspan(literal_count, distance_count));
}

void ZlibReader::put(std::span<std::uint8_t>& out, std::uint8_t byte) {
  window_[total_++ & kWindowMask] = byte;
  adler_low_ += byte;
  if (adler_low_ >= kAdlerBase) adler_low_ -= kAdlerBase;
  adler_high_ += adler_low_;
  if (adler_high_ >= kAdlerBase) adler_high_ -= kAdlerBase;
  out[0] = byte;
  out = out.subspan(1);
}

void ZlibReader::copy_stored(std::span<std::uint8_t>& out) {
  while (left_ > 0 && !out.empty()) {
    auto const byte = static_cast<std::uint8_t>(bits_.take(8));
    if (bits_.is_past_end()) return;
    put(out, byte);
    --left_;
  }
  if (left_ == 0) end_block();
}

void ZlibReader::read_symbols(std::span<std::uint8_t>& out) {
  copy_match(out);
  while (!out.empty()) {
    int const symbol = literals_.next(bits_);
    if (symbol < 0 || bits_.is_past_end()) {
      state_ = State::Bad;
      return;
    }
    if (symbol < kEndOfBlock) {
      put(out, static_cast<std::uint8_t>(symbol));
      continue;
    }
    if (symbol == kEndOfBlock) {
      end_block();
      return;
    }
    start_match(symbol - kEndOfBlock - 1);
    if (state_ == State::Bad) return;
    copy_match(out);
  }
}

void ZlibReader::start_match(int length_symbol) {
  auto const length_index = static_cast<std::size_t>(length_symbol);
  if (length_index >= kLengthBase.size()) {
    state_ = State::Bad;
    return;
  }
  left_ = kLengthBase[length_index] + static_cast<int>(bits_.take(kLengthExtra[length_index]));
  int const distance_symbol = distances_.next(bits_);
  auto const distance_index = static_cast<std::size_t>(distance_symbol);
  if (distance_symbol < 0 || distance_index >= kDistanceBase.size()) {
    state_ = State::Bad;
    return;
  }
  distance_ = kDistanceBase[distance_index] + bits_.take(kDistanceExtra[distance_index]);
  if (distance_ > total_) state_ = State::Bad;
}

void ZlibReader::copy_match(std::span<std::uint8_t>& out) {
  while (left_ > 0 && !out.empty()) {
    put(out, window_[(total_ - distance_) & kWindowMask]);
    --left_;
  }
}

}  // namespace inkflate
