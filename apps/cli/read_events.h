// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "editor/events.h"

namespace inkflate::cli {

/// A file to open, add or wear. Its name lies within the recording's folder.
struct OpenStep {
  std::string name;
  FileUse use = FileUse::Open;
};

/// The project is saved under a name within the folder of the caller's choice.
struct SaveStep {
  std::string name;  // its extension says as what
};

/// What the window shows becomes a PNG file.
struct PictureStep {
  std::string name;
};

/// The document's hash is printed, and where one is expected compared.
struct HashStep {
  std::string expected;  // 16 hexadecimal digits; empty: any
};

using RecordedStep = std::variant<Event, OpenStep, SaveStep, PictureStep, HashStep>;

/// One step of a recording. A line such as a whole stroke makes several.
struct RecordedEvent {
  RecordedStep step;
  int line = 1;  // of the file, from 1
};

/// No recording makes more steps than this.
inline constexpr int kMaxRecordedEvents = 1'000'000;

/// Reads a recording of editor events: one JSON object for each line; docs/FORMATS.md tells which.
///
/// errors  BadInput (index: the line), TooLarge (JsonLimits for each line, kMaxRecordedEvents)
Result<std::vector<RecordedEvent>> read_events(std::string_view text);

}  // namespace inkflate::cli
