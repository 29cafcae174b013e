// SPDX-License-Identifier: Apache-2.0
#include "cli/replay.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include "cli/console.h"
#include "cli/files.h"
#include "cli/write_drawing.h"
#include "io/document_hash.h"
#include "io/numbers.h"
#include "io/read_picture.h"
#include "io/write_png.h"

namespace inkflate::cli {
namespace {

std::string in_folder(std::string const& folder, std::string const& name) {
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace

std::string Replay::hash() const {
  return hex_digits(document_hash(to_project(engine_.history().document())));
}

Result<Picture> Replay::picture() {
  auto const scene = engine_.scene();
  double const width_px = scene.size.width_px;
  double const height_px = scene.size.height_px;
  if (std::max(width_px, height_px) > PictureLimits::kSidePx ||
      width_px * height_px > PictureLimits::kPixels) {
    return Error{ErrorCode::TooLarge, "the window is over 16384 px or 64 megapixels"};
  }
  return picture_of(scene);
}

std::optional<Error> Replay::write_picture(std::string const& path) {
  auto const made = picture();
  return made ? write_file(path, write_png(*made)) : made.error();
}

std::optional<Error> Replay::recover(std::span<std::byte const> journal) {
  auto const changes = engine_.recover(journal);
  if (auto error = take(changes)) return error;
  if (changes.is_document_changed) return std::nullopt;
  return Error{ErrorCode::BadInput, messages_.empty() ? "cannot be recovered" : messages_.back()};
}

std::optional<Error> Replay::run(std::span<RecordedEvent const> events) {
  for (auto const& event : events) {
    if (options_.pace_ms > 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(options_.pace_ms));
    }
    if (auto error = run_step(event.step)) {
      error->message = "line " + std::to_string(event.line) + ": " + error->message;
      error->index = event.line;
      return error;
    }
  }
  return std::nullopt;
}

std::optional<Error> Replay::run_step(RecordedStep const& step) {
  if (auto error = std::visit([&](auto const& each) { return do_step(each); }, step)) return error;
  ++steps_;
  if (options_.acknowledges) acknowledge();
  return std::nullopt;
}

std::optional<Error> Replay::do_step(Event const& event) {
  if (auto error = take(engine_.handle(event))) return error;
  while (engine_.has_work()) {
    if (auto error = take(engine_.work())) return error;
  }
  return std::nullopt;
}

std::optional<Error> Replay::do_step(OpenStep const& step) {
  auto content = read_file(in_folder(options_.folder, step.name));
  if (!content) return content.error();
  return do_step(FileEvent{std::move(*content), step.name, step.use});
}

std::optional<Error> Replay::do_step(SaveStep const& step) {
  auto const format = drawing_format(step.name);
  if (!format) return format.error();
  if (options_.files.empty()) return std::nullopt;
  return write_drawing(to_project(engine_.history().document()), *format,
                       in_folder(options_.files, step.name));
}

std::optional<Error> Replay::do_step(PictureStep const& step) {
  return options_.files.empty() ? std::nullopt
                                : write_picture(in_folder(options_.files, step.name));
}

std::optional<Error> Replay::do_step(HashStep const& step) {
  auto const found = hash();
  if (step.expected.empty() && options_.prints_hashes) print(found + "\n");
  if (step.expected.empty() || step.expected == found) return std::nullopt;
  return Error{ErrorCode::BadInput,
               "the document's hash is " + found + ", not " + step.expected + " as expected"};
}

/// The journal first: what is told has to be true after a crash too.
std::optional<Error> Replay::take(Changes const& changes) {
  if (options_.journal && (changes.is_journal_new || !changes.journal.empty())) {
    auto& journal = *options_.journal;
    auto error = changes.is_journal_new ? journal.start_anew(changes.journal)
                                        : journal.append(changes.journal);
    if (error) return error;
  }
  if (!changes.journal.empty()) acknowledged_hash_.clear();
  if (changes.is_journal_new) journal_lines_ = 0;
  journal_lines_ +=
      static_cast<int>(std::count(changes.journal.begin(), changes.journal.end(), '\n'));
  for (auto const& message : changes.messages) {
    messages_.push_back(text_of(message, engine_.state().language));
    if (!options_.shows_messages) continue;
    if (message.severity == Severity::Status) {
      print_note(options_.input_name, messages_.back());
    } else {
      print_warning(options_.input_name, messages_.back());
    }
  }
  for (auto const& file : changes.files) {
    if (options_.files.empty()) continue;
    if (auto error = write_file(in_folder(options_.files, file.name), file.bytes)) return error;
  }
  return changes.journal.empty() ? std::nullopt : keep_step();
}

std::optional<Error> Replay::keep_step() {
  if (options_.steps.empty()) return std::nullopt;
  auto number = std::to_string(++changes_);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  auto const base = in_folder(options_.steps, number);
  auto const project = to_project(engine_.history().document());
  if (auto error = write_drawing(project, DrawingFormat::Inkflate, base + ".inkflate")) {
    return error;
  }
  if (auto error = write_picture(base + ".png")) return error;
  return write_file(base + ".hash", hash() + "\n");
}

/// "STEP LINES HASH": so many steps are done, so many lines of the journal are on the disk, and what they lead to.
void Replay::acknowledge() {
  if (acknowledged_hash_.empty()) acknowledged_hash_ = hash();
  print(std::to_string(steps_) + " " + std::to_string(journal_lines_) + " " + acknowledged_hash_ +
        "\n");
}

}  // namespace inkflate::cli
