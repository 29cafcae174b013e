// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <sstream>
#include <thread>

#include "cli/program.h"

namespace inkflate {
namespace {

constexpr int kShapes = 6;

/// Shapes of two strokes, each simplified, the last taken back.
std::string recording() {
  std::ostringstream text;
  for (int i = 0; i < kShapes; ++i) {
    int const x = 100 + 120 * i;
    text << R"({"stroke": [[)" << x << ", 300], [" << x << ", 200], [" << x + 80 << ", 200], ["
         << x + 80 << ", 310]]}\n"
         << R"({"stroke": [[)" << x + 80 << ", 290], [" << x + 80 << ", 400], [" << x << ", 400], ["
         << x << ", 290]]}\n"
         << "{\"key\": \"Enter\"}\n";
  }
  text << "{\"key\": \"z\", \"ctrl\": true}\n";
  return text.str();
}

/// What --acknowledge has told: where each length of the journal, in lines, leads to.
struct Told {
  std::map<long, std::string> hashes;

  explicit Told(std::string const& output) {
    std::istringstream stream(output.substr(0, output.rfind('\n') + 1));
    long step = 0;
    long lines = 0;
    std::string hash;
    while (stream >> step >> lines >> hash) hashes[lines] = hash;
  }
  long lines() const { return hashes.empty() ? 0 : hashes.rbegin()->first; }
};

/// The editor with a journal, which is killed while it draws.
class KilledEditor {
 public:
  KilledEditor() { folder_.write("events.jsonl", recording()); }

  /// Runs to the end.
  Told run() const {
    return Told(run_inkflate(folder_.path(), {"replay", "events.jsonl", "--quiet", "--journal",
                                              "journal", "--acknowledge"})
                    .out);
  }

  Told run_until_killed(std::chrono::milliseconds after) const {
    ::unlink((folder_ / "journal").c_str());
    ::unlink((folder_ / "told").c_str());
    pid_t const child = ::fork();
    if (child == 0) {
      bool const is_ready =
          ::chdir(folder_.path().c_str()) == 0 &&
          ::dup2(::open("told", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO) >= 0;
      if (is_ready) {
        ::execl(INKFLATE_PROGRAM, INKFLATE_PROGRAM, "replay", "events.jsonl", "--quiet",
                "--journal", "journal", "--acknowledge", "--pace", "2", nullptr);
      }
      ::_exit(127);
    }
    std::this_thread::sleep_for(after);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return Told(folder_.read("told"));
  }

  long journal_lines() const {
    auto const journal = folder_.read("journal");
    return std::count(journal.begin(), journal.end(), '\n');
  }

  std::string journal_hash() const {
    return run_inkflate(folder_.path(), {"hash", "journal"}).out.substr(0, 16);
  }

  bool can_recover() const {
    folder_.write("nothing.jsonl", "");
    auto const before = journal_hash();
    auto const run = run_inkflate(
        folder_.path(), {"replay", "nothing.jsonl", "--quiet", "--recover", "journal", "--hash"});
    return run.status == 0 && run.out == before + "\n";
  }

 private:
  ScratchFolder folder_;
};

// tests/tools/kill_journal.py does more of this.
TEST(KillJournal, AtAnyMomentTheJournalLeadsToADocumentThatThereWas) {
  KilledEditor const editor;
  auto const clean = editor.run();
  ASSERT_EQ(editor.journal_hash(), clean.hashes.rbegin()->second);
  for (int const after_ms : {20, 90, 150, 220, 300}) {
    auto const told = editor.run_until_killed(std::chrono::milliseconds(after_ms));
    long const lines = editor.journal_lines();
    EXPECT_GE(lines, told.lines()) << after_ms;
    if (lines == 0) continue;  // too early
    auto const found = clean.hashes.find(lines);
    ASSERT_NE(found, clean.hashes.end()) << lines;
    EXPECT_EQ(editor.journal_hash(), found->second) << after_ms;
    EXPECT_TRUE(editor.can_recover()) << after_ms;
  }
}

}  // namespace
}  // namespace inkflate
