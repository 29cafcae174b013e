// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "cli/descriptor.h"

namespace inkflate::cli {

/// The file that a journal is appended to. What append() and start_anew() were given is on the disk when they return.
class JournalFile {
 public:
  explicit JournalFile(std::string path) : path_(std::move(path)) {}

  /// The file holds these bytes and nothing else; until then it holds what it did before.
  ///
  /// out     nothing: done; else FileSystem
  std::optional<Error> start_anew(std::string_view content);

  /// out     nothing: done; else FileSystem
  std::optional<Error> append(std::string_view content);

 private:
  Error failure(int number) const;

  std::string path_;
  Descriptor file_{-1};
};

}  // namespace inkflate::cli
