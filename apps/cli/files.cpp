// SPDX-License-Identifier: Apache-2.0
#include "cli/files.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "cli/descriptor.h"

namespace inkflate::cli {
namespace {

Error system_error(std::string const& what, int number) {
  return {ErrorCode::FileSystem, what + ": " + std::generic_category().message(number)};
}

Error too_large() {
  return {ErrorCode::TooLarge, "the file is larger than 64 MB, which is the most we read"};
}

Result<std::vector<std::byte>> read_all(int descriptor) {
  struct stat status = {};
  if (::fstat(descriptor, &status) != 0) return system_error("cannot read", errno);
  if (S_ISDIR(status.st_mode)) return system_error("cannot read", EISDIR);
  if (S_ISREG(status.st_mode) && status.st_size > kMaxFileBytes) return too_large();
  std::vector<std::byte> content;
  std::vector<std::byte> chunk(std::size_t{1} << 16U);
  while (true) {
    auto const count = ::read(descriptor, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return system_error("cannot read", errno);
    if (count == 0) return content;
    if (std::ssize(content) + count > kMaxFileBytes) return too_large();
    content.insert(content.end(), chunk.begin(), chunk.begin() + count);
  }
}

std::string folder_of(std::string const& path) {
  auto const folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

struct TemporaryFile {
  std::string path;
  Descriptor descriptor;
};

// Never opens a file that exists: someone may have put a link there. The name does not grow with the target's.
Result<TemporaryFile> make_temporary(std::string const& folder) {
  constexpr int max_tries = 1000;
  for (int i = 0; i < max_tries; ++i) {
    std::string const path =
        folder + "/.inkflate-" + std::to_string(::getpid()) + "-" + std::to_string(i) + ".tmp";
    Descriptor descriptor(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (descriptor.is_open()) return TemporaryFile{path, std::move(descriptor)};
    if (errno != EEXIST) return system_error("cannot write into " + folder, errno);
  }
  return system_error("cannot write into " + folder, EEXIST);
}

enum class LastVersion { Drop, Keep };

/// Gives the file a second name, by renaming a third one, so that the last version before it stays until then. The file system's
/// reasons why not (no links there, too long a name) are no reason to stop a save.
void keep_last_version(std::string const& path, std::string const& temporary_path) {
  std::string const link = temporary_path + "~";
  if (::link(path.c_str(), link.c_str()) != 0) return;
  if (std::rename(link.c_str(), (path + "~").c_str()) != 0) errno = 0;
  // Renaming one name of a file to another name of the same file does nothing.
  ::unlink(link.c_str());
}

std::optional<Error> replace_file(std::string const& path, std::span<std::byte const> content,
                                  LastVersion last_version) {
  struct stat old = {};
  bool const keeps_mode = ::lstat(path.c_str(), &old) == 0 && S_ISREG(old.st_mode);
  auto temporary = make_temporary(folder_of(path));
  if (!temporary) return temporary.error();
  auto& descriptor = temporary->descriptor;
  // Rights that cannot be kept are no reason to lose the work.
  if (keeps_mode && ::fchmod(descriptor.number(), old.st_mode & 07777U) != 0) errno = 0;
  bool is_done = write_all(descriptor.number(), content) && ::fsync(descriptor.number()) == 0 &&
                 descriptor.close();
  if (is_done && keeps_mode && last_version == LastVersion::Keep) {
    keep_last_version(path, temporary->path);
  }
  is_done = is_done && std::rename(temporary->path.c_str(), path.c_str()) == 0;
  if (!is_done) {
    int const number = errno;
    ::unlink(temporary->path.c_str());
    return system_error("cannot write " + path, number);
  }
  // The new name has to reach the disk too; where a folder cannot be synced there is nothing more to do.
  Descriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open() && ::fsync(folder.number()) != 0) errno = 0;
  return std::nullopt;
}

}  // namespace

Result<std::vector<std::byte>> read_file(std::string const& path) {
  if (path == kStandardStream) return read_all(STDIN_FILENO);
  Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor.is_open()) return system_error("cannot read", errno);
  return read_all(descriptor.number());
}

namespace {

std::optional<Error> put_file(std::string const& path, std::span<std::byte const> content,
                              LastVersion last_version) {
  if (path == kStandardStream) {
    if (write_all(STDOUT_FILENO, content)) return std::nullopt;
    return system_error("cannot write to standard output", errno);
  }
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode)) {
    return replace_file(path, content, last_version);
  }
  if (S_ISDIR(status.st_mode)) return system_error("cannot write " + path, EISDIR);
  Descriptor descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (descriptor.is_open() && write_all(descriptor.number(), content)) return std::nullopt;
  return system_error("cannot write " + path, errno);
}

}  // namespace

std::optional<Error> write_file(std::string const& path, std::span<std::byte const> content) {
  return put_file(path, content, LastVersion::Drop);
}

std::optional<Error> save_file(std::string const& path, std::span<std::byte const> content) {
  return put_file(path, content, LastVersion::Keep);
}

std::optional<Error> write_file(std::string const& path, std::string_view content) {
  return write_file(path, std::as_bytes(std::span(content.data(), content.size())));
}

}  // namespace inkflate::cli
