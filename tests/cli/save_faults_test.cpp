// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "cli/program.h"

namespace inkflate {
namespace {

constexpr char const* kSquare =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="200" height="200" fill="none" stroke="black">
<path d="M50 50H150V150H50Z"/></svg>)";

/// A save that is interrupted: what the program would do, killed before it has done all of it.
class InterruptedSave {
 public:
  InterruptedSave() {
    folder_.write("square.svg", kSquare);
    EXPECT_EQ(run_inflate({"convert", "square.svg", "-o", "new.inkflate"}).status, 0);
    new_ = folder_.read("new.inkflate");
  }

  /// Starts from a folder with an old file. Kills the program at one of its stops: those before and after each system call.
  /// Gives the number of stops that there were; -1: nothing can be traced here.
  int run(int last_stop) {
    for (auto const& name : folder_.names()) {
      if (name != "square.svg") ::unlink((folder_ / name).c_str());
    }
    folder_.write("a.inkflate", "old");
    folder_.write("a.inkflate~", "older");
    pid_t const child = ::fork();
    if (child == 0) run_traced();
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!WIFSTOPPED(status)) return -1;
    ::ptrace(PTRACE_SETOPTIONS, child, 0, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    for (int stops = 0;;) {
      ::ptrace(PTRACE_SYSCALL, child, 0, 0);
      ::waitpid(child, &status, 0);
      if (!WIFSTOPPED(status)) return stops;
      if (WSTOPSIG(status) != (SIGTRAP | 0x80)) continue;
      if (++stops < last_stop) continue;
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      return stops;
    }
  }

  bool is_old() const { return folder_.read("a.inkflate") == "old"; }
  bool is_new() const { return folder_.read("a.inkflate") == new_; }
  bool has_whole_backup() const {
    auto const backup = folder_.read("a.inkflate~");
    return backup == "old" || (backup == "older" && is_old());
  }
  bool has_begun() const { return folder_.names().size() > 3 || !is_old(); }

 private:
  ProgramRun run_inflate(std::vector<std::string> const& arguments) const {
    return run_inkflate(folder_.path(), arguments);
  }

  [[noreturn]] void run_traced() const {
    ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);  // the leak checker cannot be traced
    if (::chdir(folder_.path().c_str()) != 0 || ::ptrace(PTRACE_TRACEME, 0, 0, 0) != 0)
      ::_exit(127);
    ::execl(INKFLATE_PROGRAM, INKFLATE_PROGRAM, "convert", "square.svg", "-o", "a.inkflate",
            nullptr);
    ::_exit(127);
  }

  ScratchFolder folder_;
  std::string new_;
};

// From the last system call backwards until the save has not begun. tests/tools/save_faults.py does more of this.
TEST(SaveFaults, KilledAtAnyMomentTheFileIsOldOrNew) {
  InterruptedSave save;
  int const stops = save.run(1'000'000);
  if (stops < 0) GTEST_SKIP() << "programs cannot be traced here";
  ASSERT_TRUE(save.is_new());
  int old_count = 0;
  int new_count = 0;
  int before = 0;
  for (int stop = stops; stop > 0 && before < 4; --stop) {
    save.run(stop);
    ASSERT_TRUE(save.is_old() || save.is_new()) << "killed at stop " << stop << " of " << stops;
    ASSERT_TRUE(save.has_whole_backup()) << "killed at stop " << stop << " of " << stops;
    (save.is_old() ? old_count : new_count) += 1;
    before = save.has_begun() ? 0 : before + 1;
  }
  EXPECT_GT(old_count, 10);
  EXPECT_GT(new_count, 2);
  RecordProperty("points", old_count + new_count);
}

TEST(SaveFaults, AFullDiskLeavesTheOldFileAndIsTold) {
  ScratchFolder const folder;
  folder.write("square.svg", kSquare);
  folder.write("a.inkflate", "old");
  struct rlimit usual = {};
  ::getrlimit(RLIMIT_FSIZE, &usual);
  auto* const handler = ::signal(SIGXFSZ, SIG_IGN);  // inherited: then the write fails
  struct rlimit limit = usual;
  limit.rlim_cur = 300;
  ::setrlimit(RLIMIT_FSIZE, &limit);
  auto const run = run_inkflate(folder.path(), {"convert", "square.svg", "-o", "a.inkflate"});
  ::setrlimit(RLIMIT_FSIZE, &usual);
  ::signal(SIGXFSZ, handler);
  EXPECT_EQ(run.status, 4);
  EXPECT_NE(run.err.find("cannot write a.inkflate"), std::string::npos) << run.err;
  EXPECT_EQ(folder.read("a.inkflate"), "old");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.inkflate", "square.svg"}));
}

TEST(SaveFaults, TheLastVersionIsKept) {
  ScratchFolder const folder;
  folder.write("square.svg", kSquare);
  auto const save = [&] {
    return run_inkflate(folder.path(), {"convert", "square.svg", "-o", "a.inkflate"}).status;
  };
  EXPECT_EQ(save(), 0);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.inkflate", "square.svg"}));
  folder.write("a.inkflate", "old");
  EXPECT_EQ(save(), 0);
  EXPECT_EQ(folder.read("a.inkflate~"), "old");
  auto const saved = folder.read("a.inkflate");
  EXPECT_EQ(save(), 0);
  EXPECT_EQ(folder.read("a.inkflate~"), saved);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.inkflate", "a.inkflate~", "square.svg"}));
}

}  // namespace
}  // namespace inkflate
