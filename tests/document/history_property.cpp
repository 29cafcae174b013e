// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <map>

#include "document/apply.h"
#include "document/history.h"
#include "support/random_commands.h"

namespace inkflate::test {
namespace {

/// How many commands for each seed: INKFLATE_COMMANDS.
int command_count() {
  char const* const wanted = std::getenv("INKFLATE_COMMANDS");
  return wanted == nullptr ? 200 : std::atoi(wanted);
}

constexpr int kStep = 100;  // every so many entries are looked at

/// What the document was after so many entries.
using Witnesses = std::map<int, Project>;

void check_witness(History const& history, Witnesses const& witnesses) {
  auto const witness = witnesses.find(history.position());
  if (witness != witnesses.end()) RC_ASSERT(to_project(history.document()) == witness->second);
}

void check_whole(Document const& document) {
  auto const project = to_project(document);
  auto const again = make_document(project);
  RC_ASSERT(again.has_value());
  RC_ASSERT(to_project(*again) == project);
}

RC_GTEST_PROP(HistoryProperty, UndoGivesTheStartAndRedoTheEnd, ()) {
  Rng rng(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
  History history(random_document(rng));
  Witnesses witnesses = {{0, to_project(history.document())}};
  for (int i = 0; i < command_count(); ++i) {
    auto const command = random_command(rng, history.document());
    int const size = history.size();
    auto const done = history.push({command}, i);
    RC_ASSERT(history.size() == size + (done.has_value() ? 1 : 0));
    if (!done) RC_ASSERT(!done.error().message.empty());
    if (history.position() % kStep == 0) {
      check_whole(history.document());
      witnesses[history.position()] = to_project(history.document());
    }
  }
  int const end = history.position();
  witnesses[end] = to_project(history.document());
  check_whole(history.document());
  while (history.undo()) check_witness(history, witnesses);
  RC_ASSERT(history.position() == 0);
  while (history.redo()) check_witness(history, witnesses);
  RC_ASSERT(history.position() == end);
}

RC_GTEST_PROP(HistoryProperty, EveryCommandLeavesAWholeDocumentOrTheOld, ()) {
  Rng rng(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
  auto const document = random_document(rng);
  auto const before = to_project(document);
  for (int kind = 0; kind < kCommandKinds; ++kind) {
    for (auto const wish : {Wish::Sensible, Wish::Hostile}) {
      auto const next = inkflate::apply(document, random_command(rng, document, kind, wish));
      if (next) check_whole(*next);
      RC_ASSERT(to_project(document) == before);
    }
  }
}

}  // namespace
}  // namespace inkflate::test
