// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "base/rng.h"
#include "io/read_zip.h"
#include "io/write_zip.h"
#include "support/zip_bytes.h"

namespace inkflate {
namespace {

using test::Bytes;
using test::bytes_of;
using test::raw_zip;
using test::RawZipEntry;

Result<std::vector<ZipFile>> unpacked(std::span<std::byte const> archive) {
  auto const entries = read_zip_directory(archive);
  if (!entries) return entries.error();
  std::vector<ZipFile> files;
  for (auto const& entry : *entries) {
    auto content = unpack(entry);
    if (!content) return content.error();
    files.push_back({entry.name, std::move(*content)});
  }
  return files;
}

ErrorCode verdict(std::span<std::byte const> archive) {
  auto const files = unpacked(archive);
  EXPECT_FALSE(files.has_value());
  return files ? ErrorCode::Cancelled : files.error().code;
}

Bytes random_content(Rng& rng) {
  Bytes content;
  int const kind = rng.below(3);
  for (int i = rng.below(5000); i > 0; --i) {
    content.push_back(static_cast<std::byte>(kind == 0 ? 7 : rng.below(kind == 1 ? 4 : 256)));
  }
  return content;
}

TEST(Zip, WrittenIsReadBack) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Rng rng(seed);
    std::vector<ZipFile> files;
    for (int i = rng.below(5); i > 0; --i) {
      files.push_back({"f/\xc4\x8d" + std::to_string(i), random_content(rng)});
    }
    auto const archive = write_zip(files);
    auto const again = unpacked(archive);
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_EQ(*again, files);
    EXPECT_EQ(write_zip(files), archive);
  }
}

TEST(Zip, PacksWhatGetsSmaller) {
  std::vector<ZipFile> const files = {{"a", Bytes(10'000, std::byte{'x'})}};
  EXPECT_LT(write_zip(files).size(), 300U);
}

TEST(Zip, OthersMayLeaveFoldersCommentsAndRubbish) {
  auto archive = raw_zip({{"folder/", {}}, {"folder\\a.txt", bytes_of("hi")}});
  test::put(archive, bytes_of("PK\5\6 and whatever else was in that buffer"));
  auto const files = unpacked(archive);
  ASSERT_TRUE(files.has_value()) << files.error().message;
  EXPECT_EQ(*files, (std::vector<ZipFile>{{"folder/a.txt", bytes_of("hi")}}));
}

TEST(Zip, NamesThatLeadOutOfTheFolderAreRefused) {
  for (std::string const name : {"../a", "a/../../b", "a/..", "..", "/etc/passwd", "C:\\a", "c:a",
                                 "\\\\host\\a", "..\\a", "a\nb", "", "\x7f"}) {
    EXPECT_EQ(verdict(raw_zip({{name, bytes_of("x")}})), ErrorCode::BadInput) << name;
  }
  EXPECT_TRUE(unpacked(raw_zip({{"a..b/...", bytes_of("x")}})).has_value());
}

TEST(Zip, LiesAboutSizeAndChecksumAreFound) {
  auto const text = bytes_of("some text");
  auto const packed = write_zip(std::vector<ZipFile>{{"a", Bytes(3000, std::byte{'x'})}});
  auto const entry = read_zip_directory(packed)->at(0);
  Bytes const deflated(entry.packed.begin(), entry.packed.end());
  auto const deflated_entry = [&](std::uint32_t size) {
    return RawZipEntry{"a", deflated, 8, 0, size, entry.crc};
  };
  ASSERT_TRUE(unpacked(raw_zip({deflated_entry(3000)})).has_value());
  for (auto const& wrong :
       {RawZipEntry{"a", text, 0, 0, 8}, RawZipEntry{"a", text, 0, 0, 10},
        RawZipEntry{"a", text, 0, 0, {}, 1}, RawZipEntry{"a", text, 8}, deflated_entry(2999),
        deflated_entry(3001), deflated_entry(400'000'000), RawZipEntry{"a", text, 0, 0, {}, {}, 1},
        RawZipEntry{"a", text, 0, 0, {}, {}, 5000}, RawZipEntry{"a", text, 0, 0, {}, {}, {}, "b"},
        RawZipEntry{"a", text, 0, 0, 500, {}, {}, {}, 500}}) {
    EXPECT_EQ(verdict(raw_zip({wrong})), ErrorCode::BadInput);
  }
}

TEST(Zip, EntriesThatShareBytesOrNamesAreRefused) {
  auto const text = bytes_of("some text");
  EXPECT_EQ(verdict(raw_zip({{"a", text}, {"a", text}})), ErrorCode::BadInput);
  RawZipEntry second = {"b", text};
  second.offset = 0;
  second.local_name = "b";
  auto archive = raw_zip({{"b", text}, second});
  EXPECT_EQ(verdict(archive), ErrorCode::BadInput);
}

TEST(Zip, LimitsHoldBeforeAnythingIsUnpacked) {
  std::vector<RawZipEntry> many(1024, RawZipEntry{"", {}});
  for (std::size_t i = 0; i < many.size(); ++i) many[i].name = std::to_string(i);
  EXPECT_TRUE(unpacked(raw_zip(many)).has_value());
  many.push_back({"one more", {}});
  EXPECT_EQ(verdict(raw_zip(many)), ErrorCode::TooLarge);
  RawZipEntry const bomb = {"a", bytes_of("x"), 8, 0, 300U << 20U};
  auto other = bomb;
  other.name = "b";
  EXPECT_EQ(verdict(raw_zip({bomb, other})), ErrorCode::TooLarge);
  EXPECT_EQ(verdict(raw_zip({bomb})), ErrorCode::BadInput);  // no byte can hold so much
}

TEST(Zip, KindsThatWeDoNotReadAreNamed) {
  EXPECT_EQ(verdict(raw_zip({{"a", bytes_of("x"), 0, 1}})), ErrorCode::Unsupported);
  EXPECT_EQ(verdict(raw_zip({{"a", bytes_of("x"), 12}})), ErrorCode::Unsupported);
  EXPECT_EQ(verdict(raw_zip({}, 0xffff)), ErrorCode::Unsupported);
  EXPECT_EQ(verdict(raw_zip({{"a", bytes_of("x"), 8, 0, 0xffffffff}})), ErrorCode::Unsupported);
}

TEST(Zip, CutOffAnywhereIsAnError) {
  auto const archive = raw_zip({{"a", bytes_of("x")}, {"b", bytes_of("yz")}});
  for (std::size_t size = 0; size < archive.size(); ++size) {
    EXPECT_EQ(verdict(std::span(archive).first(size)), ErrorCode::BadInput) << size;
  }
  EXPECT_EQ(verdict(raw_zip({{"a", bytes_of("x")}}, 2)), ErrorCode::BadInput);
}

TEST(Zip, AnyChangedByteEndsInAVerdict) {
  auto const archive =
      write_zip(std::vector<ZipFile>{{"a", Bytes(300, std::byte{'x'})}, {"b", bytes_of("yz")}});
  for (std::size_t i = 0; i < archive.size(); ++i) {
    for (int const change : {1, 0x80, 0xff}) {
      auto damaged = archive;
      damaged[i] ^= static_cast<std::byte>(change);
      static_cast<void>(unpacked(damaged).has_value());
    }
  }
}

}  // namespace
}  // namespace inkflate
