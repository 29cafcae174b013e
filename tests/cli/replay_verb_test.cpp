// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/picture_in.h"
#include "cli/program.h"
#include "io/read_inkflate.h"

namespace inkflate {
namespace {

// A blob in two strokes, simplified.
constexpr char const* kBlob =
    R"({"stroke": [[300, 300], [300, 200], [400, 200], [500, 200], [500, 310]]}
{"stroke": [[500, 290], [500, 400], [400, 400], [300, 400], [300, 290]]}
{"key": "Enter"}
)";

class ReplayVerb : public testing::Test {
 protected:
  ReplayVerb() { folder_.write("blob.jsonl", kBlob); }

  ProgramRun replay(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "replay");
    return run_inkflate(folder_.path(), arguments);
  }

  /// The hash of what a recording leaves, as it is printed.
  std::string hash_of(std::string const& recording) const {
    auto const run = replay({recording, "--quiet", "--hash"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out.size(), 17U) << run.out;
    return run.out.substr(0, 16);
  }

  Project project(std::string const& name) const {
    auto const content = folder_.read(name);
    auto project = read_inkflate(std::as_bytes(std::span(content)));
    EXPECT_TRUE(project) << name;
    return project ? *project : Project{};
  }

  Picture picture(std::string const& name) const { return picture_in(folder_, name); }

  ScratchFolder folder_;
};

TEST_F(ReplayVerb, WhatWasDrawnIsThere) {
  auto const run = replay({"blob.jsonl", "-o", "blob.inkflate"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err.rfind("inkflate: blob.jsonl: ", 0), 0U) << run.err;
  auto const made = project("blob.inkflate");
  ASSERT_EQ(made.drawing.layers.size(), 1U);
  EXPECT_EQ(made.drawing.layers[0].strokes.size(), 2U);
}

TEST_F(ReplayVerb, ItWritesDrawingsModelsAndPictures) {
  for (std::string const name : {"a.svg", "a.zip", "a.glb", "a.stl", "a.png"}) {
    auto const run = replay({"blob.jsonl", "--quiet", "-o", name});
    EXPECT_EQ(run.status, 0) << name << run.err;
    EXPECT_FALSE(folder_.read(name).empty()) << name;
  }
  EXPECT_EQ(replay({"blob.jsonl", "--quiet", "--picture", "b.png", "--size", "320x240"}).status, 0);
  EXPECT_EQ(picture("a.png").width, 1000);
  EXPECT_EQ(picture("b.png").width, 320);
  EXPECT_EQ(picture("b.png").height, 240);
}

TEST_F(ReplayVerb, TheReportIsOneJsonObject) {
  auto const run = replay({"blob.jsonl", "--quiet", "--json"});
  auto const report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report["events"], 14);
  EXPECT_EQ(report["entries"], 3);
  EXPECT_EQ(report["layers"], 1);
  EXPECT_EQ(report["hash"], hash_of("blob.jsonl"));
  EXPECT_EQ(report["messages"].size(), 1U);
  EXPECT_TRUE(report["ms"].contains("replay"));
}

TEST_F(ReplayVerb, TheSameEventsLeaveTheSameHash) {
  folder_.write("again.jsonl", std::string(kBlob) + R"({"key": "z", "ctrl": true}
{"key": "y", "ctrl": true}
)");
  folder_.write("other.jsonl", std::string(kBlob) + R"({"key": "z", "ctrl": true})");
  EXPECT_EQ(hash_of("again.jsonl"), hash_of("blob.jsonl"));
  EXPECT_NE(hash_of("other.jsonl"), hash_of("blob.jsonl"));
  replay({"blob.jsonl", "--quiet", "-o", "blob.inkflate"});
  auto const run = run_inkflate(folder_.path(), {"hash", "blob.inkflate"});
  EXPECT_EQ(run.out.substr(0, 16), hash_of("blob.jsonl"));
}

TEST_F(ReplayVerb, AnotherHashThanExpectedIsRefused) {
  folder_.write("right.jsonl",
                std::string(kBlob) + R"({"hash": ")" + hash_of("blob.jsonl") + "\"}\n");
  folder_.write("wrong.jsonl", std::string(kBlob) + R"({"hash": "0123456789abcdef"})");
  folder_.write("asked.jsonl", std::string(kBlob) + R"({"hash": null})");
  EXPECT_EQ(replay({"right.jsonl", "--quiet"}).status, 0);
  auto const run = replay({"wrong.jsonl", "--quiet"});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("line 4: the document's hash is"), std::string::npos) << run.err;
  EXPECT_EQ(replay({"asked.jsonl", "--quiet"}).out, hash_of("blob.jsonl") + "\n");
  EXPECT_EQ(replay({"asked.jsonl", "--quiet", "--json"}).out.front(), '{');
}

TEST_F(ReplayVerb, EachChangeIsKeptAsAStep) {
  auto const run = replay({"blob.jsonl", "--quiet", "--steps", "steps", "--hash"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(project("steps/0001.inkflate").drawing.sketch.strokes.size(), 1U);
  EXPECT_EQ(project("steps/0002.inkflate").drawing.sketch.strokes.size(), 2U);
  EXPECT_EQ(project("steps/0003.inkflate").drawing.layers.size(), 1U);
  EXPECT_EQ(picture("steps/0003.png").width, 1000);
  EXPECT_EQ(folder_.read("steps/0003.hash"), run.out);
  EXPECT_EQ(folder_.read("steps/0004.hash"), "");
}

TEST_F(ReplayVerb, ARecordingWritesOnlyWhereItMay) {
  folder_.write("writes.jsonl", std::string(kBlob) + R"({"save": "a.inkflate"}
{"picture": "a.png"}
{"key": "s", "ctrl": true}
)");
  EXPECT_EQ(replay({"writes.jsonl", "--quiet"}).status, 0);
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"blob.jsonl", "writes.jsonl"}));
  EXPECT_EQ(replay({"writes.jsonl", "--quiet", "--files", "f"}).status, 0);
  EXPECT_EQ(project("f/a.inkflate").drawing.layers.size(), 1U);
  EXPECT_EQ(project("f/drawing.inkflate"), project("f/a.inkflate"));
  EXPECT_EQ(picture("f/a.png").width, 1000);
  folder_.write("odd.jsonl", R"({"save": "a.exe"})");
  EXPECT_EQ(replay({"odd.jsonl", "--quiet", "--files", "f"}).status, 2);
}

TEST_F(ReplayVerb, FilesAreOpenedFromBesideTheRecording) {
  replay({"blob.jsonl", "--quiet", "-o", "blob.inkflate"});
  folder_.write("opens.jsonl", R"({"open": "blob.inkflate"})");
  folder_.write("misses.jsonl", "\n{\"open\": \"nothing.inkflate\"}");
  EXPECT_EQ(hash_of("opens.jsonl"), hash_of("blob.jsonl"));
  auto const run = replay({"misses.jsonl", "--quiet"});
  EXPECT_EQ(run.status, 4);
  EXPECT_NE(run.err.find("line 2: "), std::string::npos) << run.err;
}

TEST_F(ReplayVerb, WorkGoesOnFromAJournal) {
  folder_.write("first.jsonl", R"({"stroke": [[300, 300], [300, 200], [400, 200], [500, 310]]})");
  folder_.write("undo.jsonl", R"({"key": "z", "ctrl": true})");
  EXPECT_EQ(replay({"blob.jsonl", "--quiet", "--journal", "journal"}).status, 0);
  auto const hash = run_inkflate(folder_.path(), {"hash", "journal"});
  EXPECT_EQ(hash.out.substr(0, 16), hash_of("blob.jsonl")) << hash.err;
  folder_.write("torn", folder_.read("journal") + "0123 {\"do");
  auto const run = replay({"undo.jsonl", "--quiet", "--recover", "torn", "--journal", "torn"});
  EXPECT_EQ(run.status, 0) << run.err;
  auto const undone = run_inkflate(folder_.path(), {"hash", "torn"});
  EXPECT_NE(undone.out.substr(0, 16), hash.out.substr(0, 16));
  auto const whole = folder_.read("journal");
  EXPECT_EQ(folder_.read("torn").substr(0, whole.size()), whole);
  EXPECT_EQ(folder_.read("torn").find("0123 {"), std::string::npos);
}

TEST_F(ReplayVerb, StepsAreToldOnceTheyAreOnTheDisk) {
  auto const run =
      replay({"blob.jsonl", "--quiet", "--journal", "journal", "--acknowledge", "--pace", "1"});
  EXPECT_EQ(run.status, 0) << run.err;
  auto const hash = hash_of("blob.jsonl");
  auto const journal = folder_.read("journal");
  auto const lines = std::count(journal.begin(), journal.end(), '\n');
  EXPECT_TRUE(run.out.ends_with("\n14 " + std::to_string(lines) + " " + hash + "\n")) << run.out;
}

TEST_F(ReplayVerb, SeveralRecordingsGoIntoAFolder) {
  folder_.write("empty.jsonl", "");
  auto const run = replay({"blob.jsonl", "empty.jsonl", "--quiet", "-o", "all/"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(project("all/blob.inkflate").drawing.layers.size(), 1U);
  EXPECT_EQ(project("all/empty.inkflate").drawing.layers.size(), 0U);
}

TEST_F(ReplayVerb, FaultsAreToldWithTheirStatus) {
  folder_.write("bad.jsonl", "{}\n{\"key\": 1}\n");
  auto const bad = replay({"bad.jsonl", "--json"});
  EXPECT_EQ(bad.status, 3);
  EXPECT_EQ(bad.err, "inkflate: bad.jsonl: line 2: key is missing or no text\n");
  EXPECT_EQ(nlohmann::json::parse(bad.out)["error"]["where"], 2);
  EXPECT_EQ(replay({"nothing.jsonl"}).status, 4);
  EXPECT_EQ(replay({"blob.jsonl", "--recover", "nothing"}).status, 4);
  EXPECT_EQ(replay({"blob.jsonl", "--quiet", "--recover", "blob.jsonl"}).status, 3);
  EXPECT_EQ(replay({"blob.jsonl", "--quiet", "--journal", "no/folder"}).status, 4);
  EXPECT_EQ(replay({"blob.jsonl", "-o", "a.exe"}).status, 2);
  EXPECT_EQ(replay({"blob.jsonl", "--size", "0"}).status, 2);
  EXPECT_EQ(replay({"blob.jsonl", "--pace", "-1"}).status, 2);
  EXPECT_EQ(replay({"blob.jsonl", "--journal", "blob.jsonl"}).status, 2);
  EXPECT_EQ(replay({"blob.jsonl", "-o", "-", "--json"}).status, 2);
  EXPECT_EQ(replay({"blob.jsonl", "--hash", "--json"}).status, 2);
  EXPECT_EQ(replay({"blob.jsonl", "blob.jsonl", "--steps", "s"}).status, 2);
  EXPECT_EQ(replay({"blob.jsonl", "blob.jsonl", "-o", "a.svg"}).status, 2);
  EXPECT_EQ(replay({"blob.jsonl", "blob.jsonl", "--picture", "a.png"}).status, 2);
  EXPECT_EQ(replay({}).status, 2);
}

TEST_F(ReplayVerb, NoStreamOfEventsStopsIt) {
  folder_.write("hostile.jsonl", R"({"pointer": "press", "at": ["nan", "inf"], "time": "-inf"}
{"pointer": "move", "at": [1e300, -1e300], "pressure": "nan", "time": -5}
{"pointer": "press", "at": [1, 1], "id": 3, "kind": "touch"}
{"pointer": "release", "at": [1, 1], "id": 9}
{"stroke": [["nan", 1], [5, 5], ["inf", "-inf", "nan"]], "start": "nan", "step": "inf"}
{"wheel": ["inf", "nan"], "at": [0, "nan"], "ctrl": true}
{"pinch": 0, "at": [0, 0]}
{"pinch": "nan", "at": [0, 0], "moved": ["inf", 0]}
{"resize": ["nan", -5]}
{"resize": [0, 0]}
{"action": "no such action"}
{"action": "thickness", "argument": "nan"}
{"action": "mark_outside", "argument": "inf,nan"}
{"key": ""}
{"key": "2"}
)");
  folder_.write("picture.jsonl", folder_.read("hostile.jsonl") + R"({"picture": "a.png"})");
  EXPECT_EQ(replay({"picture.jsonl", "--quiet", "--files", "f"}).status, 0);
}

}  // namespace
}  // namespace inkflate
