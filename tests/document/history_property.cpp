// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

#include "document/apply.h"
#include "document/history.h"
#include "io/document_hash.h"
#include "io/write_document_json.h"
#include "support/random_commands.h"

namespace inkflate::test {
namespace {

/// How many commands for each seed: INKFLATE_COMMANDS.
int command_count() {
  char const* const wanted = std::getenv("INKFLATE_COMMANDS");
  return wanted == nullptr ? 200 : std::atoi(wanted);
}

constexpr int kStep = 100;  // every so many entries are looked at

std::uint64_t hash_of(Document const& document) { return document_hash(to_project(document)); }

std::string text_of(Document const& document) { return write_document_json(to_project(document)); }

/// Hash of the document after so many entries.
using Witnesses = std::map<int, std::uint64_t>;

void check_witness(History const& history, Witnesses const& witnesses) {
  auto const witness = witnesses.find(history.position());
  if (witness != witnesses.end()) RC_ASSERT(hash_of(history.document()) == witness->second);
}

void check_whole(Document const& document) {
  auto const project = to_project(document);
  auto const again = make_document(project);
  RC_ASSERT(again.has_value());
  RC_ASSERT(to_project(*again) == project);
}

/// How many commands the documents of all seeds took and refused.
struct Tally {
  long long accepted = 0;
  long long refused = 0;
};

/// Commands, each an entry of its own; hashes of every hundredth document and of the last.
Witnesses push_commands(Rng& rng, History& history, Tally& tally) {
  Witnesses witnesses = {{0, hash_of(history.document())}};
  for (int i = 0; i < command_count(); ++i) {
    auto const command = random_command(rng, history.document());
    int const size = history.size();
    auto const done = history.push({command}, i);
    RC_ASSERT(history.size() == size + (done.has_value() ? 1 : 0));
    if (!done) RC_ASSERT(!done.error().message.empty());
    ++(done ? tally.accepted : tally.refused);
    if (done && history.position() % kStep == 0) {
      check_whole(history.document());
      witnesses[history.position()] = hash_of(history.document());
    }
  }
  witnesses[history.position()] = hash_of(history.document());
  check_whole(history.document());
  return witnesses;
}

/// There and back again, for one seed.
void check_history(Tally& tally) {
  Rng rng(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()));
  History history(random_document(rng));
  auto const start = text_of(history.document());
  auto const witnesses = push_commands(rng, history, tally);
  auto const end = text_of(history.document());
  int const entries = history.position();
  while (history.undo()) check_witness(history, witnesses);
  RC_ASSERT(history.position() == 0);
  RC_ASSERT(text_of(history.document()) == start);
  while (history.redo()) check_witness(history, witnesses);
  RC_ASSERT(history.position() == entries);
  RC_ASSERT(text_of(history.document()) == end);
}

TEST(HistoryProperty, UndoGivesTheStartAndRedoTheEnd) {
  Tally tally;
  EXPECT_TRUE(rc::check([&] { check_history(tally); }));
  std::cout << "commands accepted: " << tally.accepted << ", refused: " << tally.refused << "\n";
  EXPECT_GT(tally.accepted, tally.refused) << "most commands have to do something";
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
