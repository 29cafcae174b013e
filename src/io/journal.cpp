// SPDX-License-Identifier: Apache-2.0
#include "io/journal.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "base/hash.h"
#include "io/command_json.h"
#include "io/json_taker.h"
#include "io/numbers.h"
#include "io/parse_json.h"
#include "io/write_document_json.h"

namespace inkflate {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kStart = R"({"format":"inkflate journal")";
constexpr int kVersion = 1;
constexpr std::size_t kSumDigits = 16;

std::string sum_of(std::string_view text) {
  Hash hash;
  hash.add(std::as_bytes(std::span(text.data(), text.size())));
  return hex_digits(hash.value());
}

std::string line_of(std::string const& text) { return sum_of(text) + " " + text + "\n"; }

std::string_view text_of(std::span<std::byte const> bytes) {
  return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
}

/// What follows the sum of a line; nothing where the sum is wrong.
std::optional<std::string_view> checked(std::string_view line) {
  if (line.size() <= kSumDigits || line[kSumDigits] != ' ') return std::nullopt;
  auto const text = line.substr(kSumDigits + 1);
  if (sum_of(text) != line.substr(0, kSumDigits)) return std::nullopt;
  return text;
}

/// Takes a whole line off the front, without its break; nothing, and the text unchanged, where the end is torn.
std::optional<std::string_view> take_line(std::string_view& text) {
  auto const end = text.find('\n');
  if (end == text.npos) return std::nullopt;
  auto const line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

/// None: it is a journal that we can read.
std::optional<Error> start_fault(std::optional<std::string_view> const& line) {
  Error const no_journal = {ErrorCode::BadInput, "not a journal of Inkflate, or its start is lost"};
  auto const text = line ? checked(*line) : std::nullopt;
  if (!text || !text->starts_with(kStart)) return no_journal;
  auto const json = parse_json(*text);
  if (!json) return no_journal;
  JsonTaker take("journal");
  double const version = take.number(take.find(*json, "version"), "version", 1, kAnyNumber);
  if (take.fault()) return no_journal;
  if (version <= kVersion) return std::nullopt;
  return Error{ErrorCode::Unsupported,
               "the journal was made by a newer version of Inkflate than this one; please update"};
}

std::optional<JournalDo> take_do(JsonTaker& take, nlohmann::json const& json) {
  JournalDo entry;
  entry.label = take.index(take.find(json, "label"), "label", -1, kAnyCount);
  for (auto const& value : take.list(json, "commands")) {
    auto command = take_command(value);
    if (!command) return std::nullopt;
    entry.commands.push_back(*std::move(command));
  }
  return take.fault() ? std::nullopt : std::optional(std::move(entry));
}

/// False: the line is no entry, or the document refuses it.
bool replay(std::string_view text, History& history) {
  auto const json = parse_json(text);
  if (!json) return false;
  JsonTaker take("journal");
  auto const name = take.text(take.find(*json, "entry"), "entry");
  if (name == "undo") return history.undo();
  if (name == "redo") return history.redo();
  if (name != "do") return false;
  auto const entry = take_do(take, *json);
  return entry && history.push(entry->commands, entry->label).has_value();
}

Json entry_json(JournalDo const& entry) {
  Json json;
  json["entry"] = "do";
  json["label"] = entry.label;
  json["commands"] = Json::array();
  for (auto const& command : entry.commands) json["commands"].push_back(command_json(command));
  return json;
}
Json entry_json(JournalUndo const& /*entry*/) { return {{"entry", "undo"}}; }
Json entry_json(JournalRedo const& /*entry*/) { return {{"entry", "redo"}}; }

}  // namespace

std::string journal_start() {
  return line_of(std::string(kStart) + ",\"version\":" + std::to_string(kVersion) + "}");
}

std::string journal_line(JournalEntry const& entry) {
  return line_of(std::visit([](auto const& each) { return json_text(entry_json(each)); }, entry));
}

bool is_journal(std::span<std::byte const> bytes) {
  auto const text = text_of(bytes);
  return text.size() > kSumDigits + 1 && text.substr(kSumDigits + 1).starts_with(kStart);
}

Result<ReadJournal> read_journal(std::span<std::byte const> bytes) {
  auto text = text_of(bytes);
  if (auto const fault = start_fault(take_line(text))) return *fault;
  if (std::count(text.begin(), text.end(), '\n') > kMostJournalLines) {
    return Error{ErrorCode::TooLarge, "the journal has more than 200 000 lines"};
  }
  ReadJournal journal = {History(empty_document())};
  journal.bytes = bytes.size() - text.size();
  while (auto const line = take_line(text)) {
    auto const entry = checked(*line);
    if (!entry || !replay(*entry, journal.history)) {
      journal.is_damaged = true;
      break;
    }
    ++journal.entries;
    journal.bytes = bytes.size() - text.size();
  }
  return journal;
}

}  // namespace inkflate
