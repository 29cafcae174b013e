// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/changes_answer.h"

#include <iterator>
#include <utility>

#include "web/bindings/names.h"

namespace inkflate::web {
namespace {

template <typename T>
void append(std::vector<T>& list, std::vector<T> next) {
  list.insert(list.end(), std::make_move_iterator(next.begin()),
              std::make_move_iterator(next.end()));
}

Json place_json(std::optional<Rect> const& place) {
  if (!place || place->is_empty()) return nullptr;
  return {{"x", place->min.x},
          {"y", place->min.y},
          {"width", place->width()},
          {"height", place->height()}};
}

}  // namespace

void gather(Changes& changes, Changes next) {
  changes.is_scene_changed |= next.is_scene_changed;
  changes.is_document_changed |= next.is_document_changed;
  changes.is_state_changed |= next.is_state_changed;
  append(changes.messages, std::move(next.messages));
  append(changes.files, std::move(next.files));
  append(changes.studio_actions, std::move(next.studio_actions));
  if (next.is_journal_new) {
    changes.is_journal_new = true;
    changes.journal.clear();
  }
  changes.journal += next.journal;
}

Recovery recovery_of(Changes const& recovered, std::size_t journal_bytes) {
  bool const is_whole = recovered.is_journal_new && recovered.journal.size() == journal_bytes;
  return is_whole ? Recovery::Whole : Recovery::InPart;
}

Answer changes_answer(Changes const& changes, Recovery recovery, Language language) {
  BlobWriter blobs;
  auto messages = Json::array();
  for (auto const& message : changes.messages) {
    messages.push_back({{"severity", name_of(message.severity)},
                        {"text", text_of(message, language)},
                        {"place", place_json(message.place)}});
  }
  auto files = Json::array();
  for (auto const& file : changes.files) {
    files.push_back({{"name", file.name}, {"bytes", blobs.add(file.bytes)}});
  }
  auto const journal = blobs.add(std::as_bytes(std::span(changes.journal)));
  return blobs.answer({{"isSceneChanged", changes.is_scene_changed},
                       {"isDocumentChanged", changes.is_document_changed},
                       {"isStateChanged", changes.is_state_changed},
                       {"messages", std::move(messages)},
                       {"files", std::move(files)},
                       {"requests", changes.studio_actions},
                       {"journal", journal},
                       {"isJournalNew", changes.is_journal_new},
                       {"isRecoveredWhole", recovery == Recovery::Whole}});
}

}  // namespace inkflate::web
