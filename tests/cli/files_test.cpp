// SPDX-License-Identifier: Apache-2.0
#include "cli/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "cli/program.h"

namespace inkflate::cli {
namespace {

namespace fs = std::filesystem;

std::string text_of(Result<std::vector<std::byte>> const& content) {
  std::string text;
  for (auto const byte : *content) text.push_back(static_cast<char>(byte));
  return text;
}

TEST(Files, WrittenIsReadBack) {
  ScratchFolder const folder;
  ASSERT_FALSE(write_file(folder / "a.svg", "<svg/>"));
  EXPECT_EQ(text_of(read_file(folder / "a.svg")), "<svg/>");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.svg"});
}

TEST(Files, OverwritingKeepsTheRightsOfTheOldFile) {
  ScratchFolder const folder;
  folder.write("a", "old");
  ASSERT_EQ(::chmod((folder / "a").c_str(), 0640), 0);
  ASSERT_FALSE(write_file(folder / "a", "new"));
  struct stat status = {};
  ASSERT_EQ(::stat((folder / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  EXPECT_EQ(folder.read("a"), "new");
}

TEST(Files, LinkIsReplacedAndWhatItPointsToStays) {
  ScratchFolder const folder;
  folder.write("precious", "old");
  fs::create_symlink(folder / "precious", folder / "link");
  ASSERT_FALSE(write_file(folder / "link", "new"));
  EXPECT_EQ(folder.read("precious"), "old");
  EXPECT_FALSE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(folder.read("link"), "new");
}

// Somebody may put links where a temporary file could go.
TEST(Files, TemporaryNamesThatExistAreNotWrittenThrough) {
  ScratchFolder const folder;
  folder.write("precious", "old");
  std::string const first_name = ".inkflate-" + std::to_string(::getpid()) + "-0.tmp";
  fs::create_symlink(folder / "precious", folder / first_name);
  ASSERT_FALSE(write_file(folder / "a", "new"));
  EXPECT_EQ(folder.read("precious"), "old");
  EXPECT_EQ(folder.read("a"), "new");
}

TEST(Files, FailedWriteLeavesEverythingAsItWas) {
  ScratchFolder const folder;
  fs::create_directory(folder / "taken");
  auto const error = write_file(folder / "taken", "new");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::FileSystem);
  EXPECT_TRUE(write_file(folder / "no/such/folder", "new"));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"taken"});
}

TEST(Files, NameAsLongAsTheSystemAllowsCanBeWritten) {
  ScratchFolder const folder;
  ASSERT_FALSE(write_file(folder / std::string(255, 'x'), "new"));
  EXPECT_TRUE(write_file(folder / std::string(4000, 'x'), "new"));
}

TEST(Files, DeviceIsWrittenToAndStaysADevice) {
  ASSERT_FALSE(write_file("/dev/null", "new"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(write_file("/dev/full", "new"));
}

TEST(Files, MissingFilesAndFoldersCannotBeRead) {
  ScratchFolder const folder;
  for (auto const& path : {folder / "none", folder.path()}) {
    auto const content = read_file(path);
    ASSERT_FALSE(content.has_value());
    EXPECT_EQ(content.error().code, ErrorCode::FileSystem);
  }
}

TEST(Files, TooLargeOnesAreRefusedWithoutReadingThem) {
  ScratchFolder const folder;
  folder.write("huge", "");
  fs::resize_file(folder / "huge", static_cast<std::uintmax_t>(kMaxFileBytes) + 1);  // sparse
  auto const content = read_file(folder / "huge");
  ASSERT_FALSE(content.has_value());
  EXPECT_EQ(content.error().code, ErrorCode::TooLarge);
  EXPECT_EQ(read_file("/dev/zero").error().code, ErrorCode::TooLarge);
}

}  // namespace
}  // namespace inkflate::cli
