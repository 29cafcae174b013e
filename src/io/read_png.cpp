// SPDX-License-Identifier: Apache-2.0
#include "io/read_png.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "io/byte_order.h"
#include "io/png_crc.h"
#include "io/png_rows.h"
#include "io/zlib_reader.h"

namespace inkflate::detail {
namespace {

constexpr std::size_t kSignatureBytes = 8;

struct Chunk {
  std::string_view type;
  std::span<std::byte const> data;
  std::size_t offset = 0;  // of its length field
  bool is_checksum_right = false;

  bool is_critical() const { return (static_cast<unsigned char>(type[0]) & 32U) == 0; }
};

Error damaged(char const* message, std::size_t offset) {
  return {ErrorCode::BadInput,
          "damaged PNG: " + std::string(message) + " at byte " + std::to_string(offset),
          static_cast<long long>(offset)};
}

Error cut_off(std::size_t size) {
  return {ErrorCode::BadInput,
          "the PNG is cut off after " + std::to_string(size) + " bytes: copy or download it again",
          static_cast<long long>(size)};
}

Result<Chunk> read_chunk(std::span<std::byte const> file, std::size_t offset) {
  auto const rest = file.subspan(offset);
  if (rest.size() < 12) return cut_off(file.size());
  auto const length = big_endian32(rest);
  if (length > 0x7fffffffU) return damaged("impossible chunk length", offset);
  if (rest.size() - 12 < length) return cut_off(file.size());
  Chunk chunk;
  chunk.type = {reinterpret_cast<char const*>(rest.data()) + 4, 4};
  chunk.data = rest.subspan(8, length);
  chunk.offset = offset;
  chunk.is_checksum_right =
      png_crc(rest.subspan(4, length + 4)) == big_endian32(rest.subspan(8 + length));
  if (chunk.is_critical() && !chunk.is_checksum_right) {
    return damaged("wrong checksum of a chunk", offset);
  }
  return chunk;
}

bool is_legal_depth(int depth, std::uint32_t colour) {
  switch (colour) {
    case 0:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
    case 3:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8;
    case 2:
    case 4:
    case 6:
      return depth == 8 || depth == 16;
    default:
      return false;
  }
}

Result<PngHeader> read_header(Chunk const& chunk) {
  auto const data = chunk.data;
  if (chunk.type != "IHDR" || data.size() != 13) return damaged("no header", chunk.offset);
  auto const size = check_picture_size(big_endian32(data), big_endian32(data.subspan(4)));
  if (!size) return size.error();
  PngHeader header;
  header.width = static_cast<int>(big_endian32(data));
  header.height = static_cast<int>(big_endian32(data.subspan(4)));
  header.depth = static_cast<int>(data[8]);
  auto const colour = static_cast<std::uint32_t>(data[9]);
  bool const is_known =
      data[10] == std::byte{0} && data[11] == std::byte{0} && data[12] <= std::byte{1};
  if (!is_known || !is_legal_depth(header.depth, colour)) {
    return damaged("unknown pixel format", chunk.offset);
  }
  header.colour = static_cast<PngColour>(colour);
  header.is_interlaced = data[12] == std::byte{1};
  return header;
}

void read_palette(std::span<std::byte const> data, PngHeader& header) {
  for (std::size_t i = 0; i + 3 <= data.size(); i += 3) {
    header.palette.push_back({static_cast<std::uint8_t>(data[i]),
                              static_cast<std::uint8_t>(data[i + 1]),
                              static_cast<std::uint8_t>(data[i + 2]), 255});
  }
}

/// An ancillary chunk: where it does not fit, the picture is read without it.
void read_transparency(std::span<std::byte const> data, PngHeader& header) {
  if (header.colour == PngColour::Palette) {
    for (std::size_t i = 0; i < data.size() && i < header.palette.size(); ++i) {
      header.palette[i].a = static_cast<std::uint8_t>(data[i]);
    }
  } else if (header.colour == PngColour::Grey && data.size() >= 2) {
    header.transparent = {big_endian16(data), 0, 0};
  } else if (header.colour == PngColour::Rgb && data.size() >= 6) {
    header.transparent = {big_endian16(data), big_endian16(data.subspan(2)),
                          big_endian16(data.subspan(4))};
  }
}

struct PngFile {
  PngHeader header;
  std::vector<std::span<std::byte const>> pixels;  // the zlib stream, piece by piece
};

/// Puts one chunk after the header in its place.
std::optional<Error> take_chunk(Chunk const& chunk, PngFile& png) {
  if (chunk.type == "IDAT") {
    png.pixels.push_back(chunk.data);
  } else if (chunk.type == "PLTE") {
    bool const is_legal = png.header.palette.empty() && png.pixels.empty() && !chunk.data.empty() &&
                          chunk.data.size() % 3 == 0 && chunk.data.size() <= 768;
    if (!is_legal) return damaged("wrong palette", chunk.offset);
    read_palette(chunk.data, png.header);
  } else if (chunk.type == "tRNS" && chunk.is_checksum_right) {
    read_transparency(chunk.data, png.header);
  } else if (chunk.is_critical()) {
    return damaged("unknown critical chunk", chunk.offset);
  }
  return std::nullopt;
}

Result<PngFile> read_chunks(std::span<std::byte const> file) {
  auto chunk = read_chunk(file, kSignatureBytes);
  if (!chunk) return chunk.error();
  auto header = read_header(*chunk);
  if (!header) return header.error();
  PngFile png{*header, {}};
  while (true) {
    chunk = read_chunk(file, chunk->offset + chunk->data.size() + 12);
    if (!chunk) return chunk.error();
    if (chunk->type == "IEND") break;
    if (auto error = take_chunk(*chunk, png)) return *error;
  }
  if (png.pixels.empty()) return damaged("no pixels", chunk->offset);
  if (png.header.colour == PngColour::Palette && png.header.palette.empty()) {
    return damaged("no palette", chunk->offset);
  }
  return png;
}

/// The pixels x0 + i dx, y0 + j dy of one of Adam7's passes.
struct Pass {
  int x0 = 0;
  int y0 = 0;
  int dx = 1;
  int dy = 1;
};
constexpr std::array<Pass, 7> kAdam7 = {Pass{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                        {0, 2, 2, 4},     {1, 0, 2, 2}, {0, 1, 1, 2}};
constexpr std::array<Pass, 1> kWhole = {Pass{}};

[[nodiscard]] bool read_pass(PngHeader const& header, Pass const& pass, ZlibReader& stream,
                             Picture& picture) {
  int const count = (header.width - pass.x0 + pass.dx - 1) / pass.dx;
  if (count <= 0) return true;
  auto const bytes = header.row_bytes(count);
  auto const pixel_bytes = std::max<std::size_t>(1, header.row_bytes(1));
  std::vector<std::uint8_t> row(bytes + 1);
  std::vector<std::uint8_t> above(bytes + 1);
  for (int y = pass.y0; y < header.height; y += pass.dy) {
    if (!stream.read(row)) return false;
    auto const values = std::span(row).subspan(1);
    if (!unfilter(row[0], values, std::span(above).subspan(1), pixel_bytes)) return false;
    if (!unpack_row(header, values, count, pass.x0, pass.dx, y, picture)) return false;
    row.swap(above);
  }
  return true;
}

}  // namespace

Result<bool> check_picture_size(long long width, long long height) {
  auto const size = std::to_string(width) + " x " + std::to_string(height);
  if (width <= 0 || height <= 0)
    return Error{ErrorCode::BadInput, "a picture without pixels: " + size};
  if (width > PictureLimits::kSidePx || height > PictureLimits::kSidePx) {
    return Error{
        ErrorCode::TooLarge,
        "the picture is " + size + " px, over the limit of 16384 px for a side: make it smaller"};
  }
  if (width * height > PictureLimits::kPixels) {
    return Error{ErrorCode::TooLarge, "the picture is " + size +
                                          " px, over the limit of 64 megapixels: make it smaller"};
  }
  return true;
}

Result<Picture> read_png(std::span<std::byte const> file) {
  auto const png = read_chunks(file);
  if (!png) return png.error();
  auto const& header = png->header;
  Picture picture(header.width, header.height);
  ZlibReader stream(png->pixels);
  auto const passes =
      header.is_interlaced ? std::span<Pass const>(kAdam7) : std::span<Pass const>(kWhole);
  for (auto const& pass : passes) {
    if (!read_pass(header, pass, stream, picture)) {
      return Error{ErrorCode::BadInput, "damaged PNG: its pixels cannot be unpacked"};
    }
  }
  if (!stream.finish()) {
    return Error{ErrorCode::BadInput,
                 "damaged PNG: its pixels are longer than the picture, or altered"};
  }
  return picture;
}

}  // namespace inkflate::detail
