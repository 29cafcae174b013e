// SPDX-License-Identifier: Apache-2.0
#include "cli/progress_line.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace inkflate::cli {
namespace {

// Work that is over before this would only make the terminal flicker.
constexpr std::chrono::milliseconds kPatience{300};
constexpr char const* kClearLine = "\r\033[K";

}  // namespace

ProgressLine::ProgressLine(Mode mode) {
  if (mode == Mode::Automatic && ::isatty(STDERR_FILENO) == 1) {
    thread_ = std::thread([this] { run(); });
  }
}

ProgressLine::~ProgressLine() {
  if (!thread_.joinable()) return;
  {
    std::lock_guard const lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void ProgressLine::show(std::string_view text) {
  if (!thread_.joinable()) return;
  {
    std::lock_guard const lock(mutex_);
    text_ = text;
  }
  changed_.notify_one();
}

// A thread of its own, so that the name of a single long stage appears while it runs.
void ProgressLine::run() {
  std::unique_lock lock(mutex_);
  if (changed_.wait_for(lock, kPatience, [this] { return is_over_; })) return;
  std::string shown;
  while (!is_over_) {
    if (shown != text_) std::fprintf(stderr, "%s%s", kClearLine, text_.c_str());
    shown = text_;
    changed_.wait(lock);
  }
  std::fputs(kClearLine, stderr);
}

}  // namespace inkflate::cli
