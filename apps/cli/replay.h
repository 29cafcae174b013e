// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/journal_file.h"
#include "cli/read_events.h"
#include "editor/engine.h"

namespace inkflate::cli {

/// How a recording is played.
struct ReplayOptions {
  std::string folder = {};  // where its files lie
  std::string files =
      {};  // folder for what the recording saves and pictures; empty: it may write nothing
  std::string steps = {};  // folder for what each change of the document has made; empty: none
  std::optional<JournalFile> journal = {};
  int pace_ms = 0;              // to wait before each step
  bool prints_hashes = true;    // where the recording asks for them
  bool acknowledges = false;    // tell on standard output what is on the disk
  bool shows_messages = true;   // on standard error
  std::string input_name = {};  // for messages
};

/// An engine that lives through a recording. All that events put off is done before the next one.
class Replay {
 public:
  explicit Replay(ReplayOptions options) : options_(std::move(options)) {}

  /// Goes on from what an earlier run has left.
  ///
  /// errors  BadInput (no journal), FileSystem
  std::optional<Error> recover(std::span<std::byte const> journal);

  /// errors  FileSystem; those of files that are opened; BadInput (another hash than expected); index: the line
  std::optional<Error> run(std::span<RecordedEvent const> events);

  /// The window's size, before the first step.
  std::optional<Error> resize(ResizeEvent const& size) { return do_step(size); }

  Engine& engine() { return engine_; }
  std::vector<std::string> const& messages() const { return messages_; }
  int steps() const { return steps_; }

  /// Of what is in the history: without a gesture under way. 16 hexadecimal digits.
  std::string hash() const;

  /// What the window shows, as PNG.
  ///
  /// errors  TooLarge (PictureLimits), FileSystem
  std::optional<Error> write_picture(std::string const& path);

 private:
  std::optional<Error> run_step(RecordedStep const& step);
  std::optional<Error> do_step(Event const& event);
  std::optional<Error> do_step(OpenStep const& step);
  std::optional<Error> do_step(SaveStep const& step);
  std::optional<Error> do_step(PictureStep const& step);
  std::optional<Error> do_step(HashStep const& step);
  Result<Picture> picture();
  std::optional<Error> take(Changes const& changes);
  std::optional<Error> keep_step();
  void acknowledge();

  ReplayOptions options_;
  Engine engine_;
  std::vector<std::string> messages_;
  int steps_ = 0;                  // that were run
  int changes_ = 0;                // of the document, that were kept
  int journal_lines_ = 0;          // that this run has written
  std::string acknowledged_hash_;  // of the document as it is; empty: not known yet
};

}  // namespace inkflate::cli
