// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace inkflate::cli {

/// One line on standard error that names what is going on, shown only once the work takes noticeably long and only
/// on a terminal. Removed at the end.
class ProgressLine {
 public:
  enum class Mode { Automatic, Off };

  explicit ProgressLine(Mode mode);
  ~ProgressLine();
  ProgressLine(ProgressLine const&) = delete;
  ProgressLine& operator=(ProgressLine const&) = delete;

  void show(std::string_view text);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::string text_;
  bool is_over_ = false;
  std::thread thread_;  // last: it uses what stands above
};

}  // namespace inkflate::cli
