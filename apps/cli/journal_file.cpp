// SPDX-License-Identifier: Apache-2.0
#include "cli/journal_file.h"

#include <fcntl.h>

#include <system_error>

#include "cli/files.h"

namespace inkflate::cli {

Error JournalFile::failure(int number) const {
  return {ErrorCode::FileSystem,
          "cannot write " + path_ + ": " + std::generic_category().message(number)};
}

std::optional<Error> JournalFile::start_anew(std::string_view content) {
  if (auto error = write_file(path_, content)) return error;
  // The name belongs to another file now.
  file_.reset(::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (!file_.is_open()) return failure(errno);
  return std::nullopt;
}

std::optional<Error> JournalFile::append(std::string_view content) {
  if (content.empty()) return std::nullopt;
  if (!file_.is_open()) return start_anew(content);
  auto const bytes = std::as_bytes(std::span(content.data(), content.size()));
  if (!write_all(file_.number(), bytes) || ::fsync(file_.number()) != 0) return failure(errno);
  return std::nullopt;
}

}  // namespace inkflate::cli
