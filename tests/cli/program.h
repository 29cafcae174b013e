// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace inkflate {

/// What a call of the command line program left behind.
struct ProgramRun {
  int status = -1;  // exit status; 128 + n after signal n
  std::string out;
  std::string err;
};

/// Runs a program with these arguments and standard input, in this folder.
ProgramRun run_program(std::string const& program, std::string const& folder,
                       std::vector<std::string> const& arguments,
                       std::string const& standard_input = "");

/// Runs inkflate with these arguments and standard input, in this folder.
ProgramRun run_inkflate(std::string const& folder, std::vector<std::string> const& arguments,
                        std::string const& standard_input = "");

/// A new empty folder that is removed with all its content at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(ScratchFolder const&) = delete;
  ScratchFolder& operator=(ScratchFolder const&) = delete;

  std::string const& path() const { return path_; }
  std::string operator/(std::string const& name) const { return path_ + "/" + name; }

  void write(std::string const& name, std::string const& content) const;
  std::string read(std::string const& name) const;
  /// Names of what lies in it, sorted.
  std::vector<std::string> names() const;

 private:
  std::string path_;
};

}  // namespace inkflate
