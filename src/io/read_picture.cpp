// SPDX-License-Identifier: Apache-2.0
#include "io/read_picture.h"

#include <cstring>

#include "io/jpeg_headers.h"
#include "io/read_png.h"
#include "io/stb.h"

namespace inkflate {
namespace {

constexpr unsigned char kPngSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr unsigned char kJpegStart[] = {0xff, 0xd8, 0xff};

template <std::size_t count>
bool starts_with(std::span<std::byte const> file, unsigned char const (&start)[count]) {
  return file.size() >= count && std::memcmp(file.data(), start, count) == 0;
}

/// A decoder keeps planes of bytes, for progressive files the coefficients (2 bytes) too, and the RGB result.
long long decoder_bytes(detail::JpegHeaders const& headers) {
  long long const per_pixel = headers.components * (headers.is_progressive ? 3 : 1) + 3;
  return per_pixel * headers.width * headers.height;
}

Result<bool> check_jpeg(detail::JpegHeaders const& headers) {
  auto size = detail::check_picture_size(headers.width, headers.height);
  if (!size) return size;
  if (decoder_bytes(headers) > PictureLimits::kDecoderBytes) {
    return Error{ErrorCode::TooLarge,
                 "this progressive JPEG needs more than 512 MB to read: make it smaller or save it "
                 "as a PNG"};
  }
  long long const work = static_cast<long long>(headers.scans) * headers.width * headers.height;
  if (work > PictureLimits::kJpegScanPixels) {
    return Error{ErrorCode::TooLarge, "the JPEG has " + std::to_string(headers.scans) +
                                          " scans, too many for its size: save it again"};
  }
  return true;
}

/// Where pixel (x, y) of the file belongs in the upright picture of the given size.
struct Place {
  int x = 0;
  int y = 0;
};
Place upright_place(detail::Orientation orientation, int x, int y, int width, int height) {
  using enum detail::Orientation;
  switch (orientation) {
    case Upright:
      return {x, y};
    case Mirrored:
      return {width - 1 - x, y};
    case UpsideDown:
      return {width - 1 - x, height - 1 - y};
    case MirroredUpsideDown:
      return {x, height - 1 - y};
    case Transposed:
      return {y, x};
    case TurnedLeft:
      return {width - 1 - y, x};
    case Transversed:
      return {width - 1 - y, height - 1 - x};
    case TurnedRight:
      return {y, height - 1 - x};
  }
  return {x, y};
}

Picture upright(detail::DecodedJpeg const& decoded, detail::Orientation orientation) {
  bool const swaps_sides = orientation >= detail::Orientation::Transposed;
  Picture picture(swaps_sides ? decoded.height : decoded.width,
                  swaps_sides ? decoded.width : decoded.height);
  auto const* rgb = decoded.rgb.get();
  for (int y = 0; y < decoded.height; ++y) {
    for (int x = 0; x < decoded.width; ++x, rgb += 3) {
      auto const place = upright_place(orientation, x, y, picture.width, picture.height);
      picture.at(place.x, place.y) = {rgb[0], rgb[1], rgb[2], 255};
    }
  }
  return picture;
}

Result<Picture> read_jpeg(std::span<std::byte const> file) {
  auto const headers = detail::read_jpeg_headers(file);
  if (!headers) return headers.error();
  auto const check = check_jpeg(*headers);
  if (!check) return check.error();
  auto const decoded = detail::decode_jpeg(file);
  if (!decoded.rgb || decoded.width != headers->width || decoded.height != headers->height) {
    return Error{ErrorCode::BadInput, "damaged JPEG: its pixels cannot be unpacked"};
  }
  return upright(decoded, headers->orientation);
}

}  // namespace

bool is_picture(std::span<std::byte const> file) {
  return starts_with(file, kPngSignature) || starts_with(file, kJpegStart);
}

Result<Picture> read_picture(std::span<std::byte const> file) {
  if (std::ssize(file) > PictureLimits::kFileBytes) {
    return Error{ErrorCode::TooLarge, "the file is over the limit of 64 MB"};
  }
  if (starts_with(file, kPngSignature)) return detail::read_png(file);
  if (starts_with(file, kJpegStart)) return read_jpeg(file);
  return Error{ErrorCode::Unsupported, "not a PNG or JPEG picture"};
}

}  // namespace inkflate
