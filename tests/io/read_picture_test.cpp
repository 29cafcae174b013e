// SPDX-License-Identifier: Apache-2.0
#include "io/read_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/rng.h"
#include "io/write_png.h"
#include "support/files.h"
#include "support/png_bytes.h"

namespace inkflate {
namespace {

using test::Bytes;
using test::chunk;
using test::data_file;
using test::png;
using test::png_header;
using test::png_of_rows;
using test::put;

constexpr Colour kRed = {220, 30, 30};
constexpr Colour kGreen = {30, 200, 30};
constexpr Colour kBlue = {30, 30, 220};
constexpr Colour kWhite = {255, 255, 255};

Bytes bytes(std::initializer_list<int> values) {
  Bytes result;
  put(result, values);
  return result;
}

Colour only_pixel(Bytes const& file) {
  auto const picture = read_picture(file);
  EXPECT_TRUE(picture.has_value()) << picture.error().message;
  return picture ? picture->values[0] : Colour{};
}

bool is_near(Colour a, Colour b, int tolerance) {
  return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance &&
         std::abs(a.b - b.b) <= tolerance && a.a == b.a;
}

/// The colours in the middle of the four quarters: top left, top right, bottom left, bottom right.
std::vector<Colour> corners(Picture const& picture) {
  int const x0 = picture.width / 4;
  int const x1 = picture.width * 3 / 4;
  int const y0 = picture.height / 4;
  int const y1 = picture.height * 3 / 4;
  return {picture.at(x0, y0), picture.at(x1, y0), picture.at(x0, y1), picture.at(x1, y1)};
}

void expect_corners(Result<Picture> const& picture, std::vector<Colour> const& expected) {
  ASSERT_TRUE(picture.has_value()) << picture.error().message;
  auto const seen = corners(*picture);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(is_near(seen[i], expected[i], 8)) << i;
}

/// The JPEG with an EXIF segment that says how the camera was held; the tag lies behind another one.
Bytes with_orientation(Bytes const& jpeg, int orientation, bool is_little) {
  Bytes payload = bytes({'E', 'x', 'i', 'f', 0, 0});
  if (is_little) {
    put(payload, {'I', 'I', 42, 0, 8, 0, 0, 0, 2, 0});
    put(payload, {0x0f, 0x01, 2, 0, 1, 0, 0, 0, 65, 0, 0, 0});
    put(payload, {0x12, 0x01, 3, 0, 1, 0, 0, 0, orientation, 0, 0, 0, 0, 0, 0, 0});
  } else {
    put(payload, {'M', 'M', 0, 42, 0, 0, 0, 8, 0, 2});
    put(payload, {0x01, 0x0f, 0, 2, 0, 0, 0, 1, 65, 0, 0, 0});
    put(payload, {0x01, 0x12, 0, 3, 0, 0, 0, 1, 0, orientation, 0, 0, 0, 0, 0, 0});
  }
  Bytes file(jpeg.begin(), jpeg.begin() + 2);
  int const length = static_cast<int>(payload.size()) + 2;
  put(file, {0xff, 0xe1, length >> 8, length & 255});
  put(file, payload);
  file.insert(file.end(), jpeg.begin() + 2, jpeg.end());
  return file;
}

TEST(ReadPicture, ReadsEveryKindOfFixture) {
  for (auto const* const name :
       {"corners.jpg", "corners_progressive.jpg", "corners_interlaced.png", "corners_16bit.png"}) {
    SCOPED_TRACE(name);
    auto const picture = read_picture(data_file(std::string("pictures/") + name));
    expect_corners(picture, {kRed, kGreen, kBlue, kWhite});
    EXPECT_EQ(picture->width, 24);
    EXPECT_EQ(picture->height, 16);
  }
}

TEST(ReadPicture, TurnsPhotosUpright) {
  auto const jpeg = data_file("pictures/corners.jpg");
  std::vector<std::vector<Colour>> const expected = {
      {kRed, kGreen, kBlue, kWhite},  // 1: as it is
      {kGreen, kRed, kWhite, kBlue},  // 2: mirrored
      {kWhite, kBlue, kGreen, kRed},  // 3: half a turn
      {kBlue, kWhite, kRed, kGreen},  // 4: upside down in a mirror
      {kRed, kBlue, kGreen, kWhite},  // 5: rows become columns
      {kBlue, kRed, kWhite, kGreen},  // 6: a quarter turn clockwise
      {kWhite, kGreen, kBlue, kRed},  // 7: rows become columns from the other corner
      {kGreen, kWhite, kRed, kBlue},  // 8: a quarter turn back
  };
  for (int orientation = 1; orientation <= 8; ++orientation) {
    for (bool const is_little : {true, false}) {
      SCOPED_TRACE(orientation);
      auto const picture = read_picture(with_orientation(jpeg, orientation, is_little));
      expect_corners(picture, expected[static_cast<std::size_t>(orientation) - 1]);
      EXPECT_EQ(picture->width, orientation >= 5 ? 16 : 24);
    }
  }
  expect_corners(read_picture(with_orientation(jpeg, 77, true)), expected[0]);
}

TEST(ReadPicture, RefusesEveryTruncation) {
  for (auto const* const name :
       {"corners.jpg", "corners_progressive.jpg", "corners_interlaced.png", "corners_16bit.png"}) {
    auto const file = data_file(std::string("pictures/") + name);
    for (std::size_t size = 0; size < file.size(); ++size) {
      // A copy of the exact size, so that a sanitizer sees every byte read past its end.
      Bytes const part(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
      ASSERT_FALSE(read_picture(part).has_value()) << name << ' ' << size;
    }
  }
}

TEST(ReadPicture, DamageEndsInAPictureOrAnError) {
  Rng rng(3);
  for (auto const* const name :
       {"corners.jpg", "corners_progressive.jpg", "corners_interlaced.png"}) {
    auto const file = data_file(std::string("pictures/") + name);
    for (int i = 0; i < 300; ++i) {
      auto damaged = file;
      damaged[static_cast<std::size_t>(rng.below(static_cast<int>(file.size())))] =
          static_cast<std::byte>(rng.below(256));
      auto const picture = read_picture(damaged);
      EXPECT_TRUE(picture.has_value() || !picture.error().message.empty());
    }
  }
}

TEST(ReadPicture, RefusesAWrongChecksumOfPixelsButNotOfText) {
  Bytes text = chunk("tEXt", bytes({'a', 0, 'b'}));
  text.back() ^= std::byte{1};
  Bytes pixels = chunk("IDAT", test::stored_zlib(bytes({0, 90})));
  Bytes chunks = text;
  put(chunks, pixels);
  EXPECT_EQ(only_pixel(png(png_header(1, 1, 8, 0), chunks)), (Colour{90, 90, 90}));
  pixels.back() ^= std::byte{1};
  auto const refused = read_picture(png(png_header(1, 1, 8, 0), pixels));
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::BadInput);
}

TEST(ReadPicture, ReadsEveryPixelFormatOfPng) {
  EXPECT_EQ(only_pixel(png_of_rows(png_header(1, 1, 1, 0), bytes({0, 0x80}))), kWhite);
  EXPECT_EQ(only_pixel(png_of_rows(png_header(1, 1, 2, 0), bytes({0, 0x40}))),
            (Colour{85, 85, 85}));
  EXPECT_EQ(only_pixel(png_of_rows(png_header(1, 1, 4, 0), bytes({0, 0x20}))),
            (Colour{34, 34, 34}));
  EXPECT_EQ(only_pixel(png_of_rows(png_header(1, 1, 16, 0), bytes({0, 7, 9}))), (Colour{7, 7, 7}));
  EXPECT_EQ(only_pixel(png_of_rows(png_header(1, 1, 8, 2), bytes({0, 1, 2, 3}))),
            (Colour{1, 2, 3}));
  EXPECT_EQ(only_pixel(png_of_rows(png_header(1, 1, 8, 4), bytes({0, 9, 128}))),
            (Colour{9, 9, 9, 128}));
  EXPECT_EQ(only_pixel(png_of_rows(png_header(1, 1, 16, 6), bytes({0, 1, 0, 2, 0, 3, 0, 4, 0}))),
            (Colour{1, 2, 3, 4}));
}

TEST(ReadPicture, ReadsPalettesAndClearColours) {
  Bytes chunks = chunk("PLTE", bytes({1, 2, 3, 40, 50, 60}));
  put(chunks, chunk("tRNS", bytes({255, 77})));
  put(chunks, chunk("IDAT", test::stored_zlib(bytes({0, 0x40}))));
  EXPECT_EQ(only_pixel(png(png_header(1, 1, 2, 3), chunks)), (Colour{40, 50, 60, 77}));
  Bytes grey = chunk("tRNS", bytes({0, 9}));
  put(grey, chunk("IDAT", test::stored_zlib(bytes({0, 9}))));
  EXPECT_EQ(only_pixel(png(png_header(1, 1, 8, 0), grey)).a, 0);
  Bytes beyond = chunk("PLTE", bytes({1, 2, 3}));
  put(beyond, chunk("IDAT", test::stored_zlib(bytes({0, 0x40}))));
  EXPECT_FALSE(read_picture(png(png_header(1, 1, 2, 3), beyond)).has_value());
}

TEST(ReadPicture, UndoesEveryRowFilter) {
  // Each row holds 10 20 30 after unfiltering: none, left, above, average, Paeth.
  auto const rows = bytes({0, 10, 20, 30, 1, 10, 10, 10, 2, 0, 0, 0, 3, 5, 5, 5, 4, 0, 0, 0});
  auto const picture = read_picture(png_of_rows(png_header(3, 5, 8, 0), rows));
  ASSERT_TRUE(picture.has_value()) << picture.error().message;
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 3; ++x) EXPECT_EQ(picture->at(x, y).r, 10 * (x + 1)) << x << ' ' << y;
  }
}

TEST(ReadPicture, ChecksLimitsBeforeTakingMemory) {
  for (auto const& header :
       {png_header(16385, 1, 8, 6), png_header(1, 16385, 8, 6), png_header(9000, 9000, 8, 6),
        png_header(2000000000, 2000000000, 8, 6)}) {
    auto const picture = read_picture(png_of_rows(header, bytes({0})));
    ASSERT_FALSE(picture.has_value());
    EXPECT_EQ(picture.error().code, ErrorCode::TooLarge);
  }
  EXPECT_FALSE(read_picture(png_of_rows(png_header(0, 5, 8, 6), {})).has_value());
  auto jpeg = data_file("pictures/corners.jpg");
  auto const frame =
      std::search(jpeg.begin(), jpeg.end(), test::kFrameMarker.begin(), test::kFrameMarker.end());
  ASSERT_NE(frame, jpeg.end());
  for (int i = 5; i < 9; ++i) *(frame + i) = std::byte{0xff};
  auto const picture = read_picture(jpeg);
  ASSERT_FALSE(picture.has_value());
  EXPECT_EQ(picture.error().code, ErrorCode::TooLarge);
}

TEST(ReadPicture, RefusesMoreFilesBytesThanTheLimit) {
  Bytes const file(static_cast<std::size_t>(PictureLimits::kFileBytes) + 1);
  EXPECT_EQ(read_picture(file).error().code, ErrorCode::TooLarge);
}

TEST(ReadPicture, PixelsBeyondTheSizeAreRefusedUnread) {
  // One pixel is announced; the stream holds a million.
  Bytes const flood = write_png(Mask(1000, 1000, 0));
  Bytes bomb = flood;
  auto const header = png_header(1, 1, 8, 0);
  std::copy(header.begin(), header.end(), bomb.begin() + 8);
  EXPECT_FALSE(read_picture(bomb).has_value());
}

TEST(ReadPicture, RefusesTablesWithMoreCodesThanTheDecoderHolds) {
  auto const picture = read_picture(data_file("pictures/too_many_codes.jpg"));
  ASSERT_FALSE(picture.has_value());
  EXPECT_EQ(picture.error().code, ErrorCode::BadInput);
}

TEST(ReadPicture, OtherFilesAreUnsupported) {
  EXPECT_EQ(read_picture(bytes({'G', 'I', 'F', '8', '9', 'a'})).error().code,
            ErrorCode::Unsupported);
  EXPECT_EQ(read_picture({}).error().code, ErrorCode::Unsupported);
}

}  // namespace
}  // namespace inkflate
