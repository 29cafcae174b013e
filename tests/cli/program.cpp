// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/check.h"

namespace inkflate {
namespace {

namespace fs = std::filesystem;

std::string content_of(std::string const& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void redirect(std::string const& path, int flags, int descriptor) {
  int const opened = ::open(path.c_str(), flags, 0600);
  if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(127);
  ::close(opened);
}

}  // namespace

ProgramRun run_inkflate(std::string const& folder, std::vector<std::string> const& arguments,
                        std::string const& standard_input) {
  return run_program(INKFLATE_PROGRAM, folder, arguments, standard_input);
}

ProgramRun run_program(std::string const& program, std::string const& folder,
                       std::vector<std::string> const& arguments,
                       std::string const& standard_input) {
  ScratchFolder const streams;
  streams.write("in", standard_input);
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  pid_t const child = ::fork();
  CHECK(child >= 0, "the test can start a process");
  if (child == 0) {
    redirect(streams / "in", O_RDONLY, STDIN_FILENO);
    redirect(streams / "out", O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(streams / "err", O_WRONLY | O_CREAT, STDERR_FILENO);
    if (::chdir(folder.c_str()) == 0) ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  int const code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, streams.read("out"), streams.read("err")};
}

ScratchFolder::ScratchFolder() : path_(fs::temp_directory_path() / "inkflate-test-XXXXXX") {
  CHECK(::mkdtemp(path_.data()) != nullptr, "the test can make a folder");
}

ScratchFolder::~ScratchFolder() { fs::remove_all(path_); }

void ScratchFolder::write(std::string const& name, std::string const& content) const {
  std::ofstream(*this / name, std::ios::binary) << content;
}

std::string ScratchFolder::read(std::string const& name) const { return content_of(*this / name); }

std::vector<std::string> ScratchFolder::names() const {
  std::vector<std::string> names;
  for (auto const& entry : fs::directory_iterator(path_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace inkflate
