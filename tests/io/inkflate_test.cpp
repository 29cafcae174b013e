// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "io/bytes.h"
#include "io/read_document_json.h"
#include "io/read_inkflate.h"
#include "io/read_picture.h"
#include "io/read_zip.h"
#include "io/write_document_json.h"
#include "io/write_inkflate.h"
#include "support/random_drawing.h"
#include "support/zip_bytes.h"

namespace inkflate {
namespace {

Picture random_picture(Rng& rng) {
  Picture picture(1 + rng.below(20), 1 + rng.below(20));
  for (auto& colour : picture.values) {
    for (auto* channel : {&colour.r, &colour.g, &colour.b, &colour.a}) {
      *channel = static_cast<std::uint8_t>(rng.below(256));
    }
  }
  return picture;
}

void add_random_motion(Rng& rng, Project& project) {
  for (int i = rng.below(3); i > 0; --i) {
    PinId const id{2 * i};
    project.pins.push_back({id, LayerId{rng.below(9)}, static_cast<Side>(rng.below(2)),
                            Vec2{rng.uniform(-99, 99), 2}, Vec2{rng.uniform(-1e6, 1e6), 1e6}});
    Track track = {id, {}, rng.uniform(-1, 1) * rng.below(2)};
    for (int k = rng.below(4); k > 0; --k) {
      track.keys.push_back({3.5 - k + rng.uniform(0, 0.9), {rng.uniform(), 0}});
    }
    project.clip.tracks.push_back(std::move(track));
    project.clip.length_s = 4;
  }
  project.next_id = 1 + rng.below(9);
}

TEST(Inkflate, ReadingGivesBackEveryProjectExactly) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    Project project = {test::random_drawing(rng)};
    if (rng.below(2) == 0) project.template_picture = random_picture(rng);
    add_random_motion(rng, project);
    auto const file = write_inkflate(project);
    ASSERT_TRUE(file.has_value());
    auto const again = read_inkflate(*file);
    ASSERT_TRUE(again.has_value()) << again.error().message;
    ASSERT_EQ(*again, project);
    ASSERT_EQ(*write_inkflate(*again), *file);
  }
}

TEST(Inkflate, AnEmptyProjectSurvives) {
  auto const again = read_inkflate(*write_inkflate({}));
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(*again, Project{});
}

TEST(Inkflate, HoldsAPreview) {
  Project project;
  project.drawing.sketch.width_px = 1000;
  project.drawing.sketch.height_px = 500;
  auto const file = write_inkflate(project);
  auto const entries = read_zip_directory(*file);
  auto const* const entry = find_entry(*entries, "preview.png");
  ASSERT_NE(entry, nullptr);
  auto const preview = read_picture(*unpack(*entry));
  ASSERT_TRUE(preview.has_value());
  EXPECT_EQ(preview->width, 256);
  EXPECT_EQ(preview->height, 128);
}

// One of everything, small enough to be damaged by hand.
constexpr char const* kDocument = R"({
  "format": "inkflate", "version": 1, "made_by": {"a": ["newer", "program"]},
  "canvas": {"width": 300, "height": 200},
  "groups": [{"name": "leg", "fill": "#01020304", "thickness": 3, "mood": "good"}],
  "strokes": [{"kind": "help", "width": 2, "colour": "#000000ff", "group": 0,
    "positions": [1, 2, 3.5, 4], "pressures": [0, 1], "times": [0, 0.25]}],
  "layers": [{"name": "a", "outlines": [{"points": [0, 0, 1, 0, 2, 0, 3, 0, 3, 1, 1, 3, 0, 0],
    "kinds": [["ink", 1], ["closing", 1]], "sources": [[0, 1, 0, 0, 1.5]]}],
    "strokes": [0], "details": []}],
  "stray": []})";

TEST(Inkflate, DocumentsAreReadAsTheyAreSpecified) {
  auto const document = read_document_json(kDocument);
  ASSERT_TRUE(document.has_value()) << document.error().message;
  auto const& sketch = document->project.drawing.sketch;
  auto const& layers = document->project.drawing.layers;
  EXPECT_EQ(sketch.width_px, 300);
  EXPECT_EQ(sketch.groups, (std::vector<StrokeGroup>{{"leg", Colour{1, 2, 3, 4}, 3}}));
  ASSERT_EQ(sketch.strokes.size(), 1U);
  EXPECT_EQ(sketch.strokes[0],
            (Stroke{{{{1, 2}, 0, 0}, {{3.5, 4}, 1, 0.25}}, StrokeKind::HelpLine, 2, {}, 0}));
  ASSERT_EQ(layers.size(), 1U);
  auto const& outline = layers[0].outlines.at(0);
  ASSERT_EQ(outline.pieces.size(), 2U);
  EXPECT_EQ(outline.pieces[1],
            (OutlinePiece{{{{{3, 0}, {3, 1}, {1, 3}, {0, 0}}}}, RunKind::Closing}));
  EXPECT_EQ(outline.sources, (std::vector<InkSource>{{0, 1, 0, 0, 1.5}}));
  EXPECT_EQ(layers[0].thickness, 2);
}

TEST(Inkflate, FilesOfEveryVersionAreRead) {
  auto const project = read_inkflate(as_bytes(test_data("inkflate/version_1.inkflate")));
  ASSERT_TRUE(project.has_value()) << project.error().message;
  EXPECT_EQ(project->drawing, read_document_json(kDocument)->project.drawing);
}

// What later programs of this version wrote beside it.
constexpr char const* kGrownDocument = R"({
  "format": "inkflate", "version": 1, "canvas": {"width": 300, "height": 200},
  "strokes": [{"kind": "ink", "width": 2, "colour": "#000000ff", "depth": "far",
    "positions": [1, 2]}],
  "layers": [{"name": "a", "id": 3, "hidden": true, "locked": true, "open": true,
    "choice": {"gap": 7, "outside": [1, 2]}, "noise": [0],
    "bend_pins": [{"position": [11, 12]}, {"position": [13, 14], "turn": 0.75}]}],
  "choice": {"inside": [5, 6, 7, 8]},
  "pins": [{"id": 4, "layer": 3, "side": "back", "rest": [9, 8], "position": [7, 6]}],
  "clip": {"length": 2, "tracks": [
    {"pin": 4, "phase": -0.5, "times": [0, 1.5], "positions": [1, 2, 3, 4]}]},
  "next_id": 5})";

TEST(Inkflate, AllOfAProjectIsReadAsItIsSpecified) {
  auto const document = read_document_json(kGrownDocument);
  ASSERT_TRUE(document.has_value()) << document.error().message;
  auto const& project = document->project;
  EXPECT_EQ(project.drawing.sketch.strokes.at(0).depth, StrokeDepth::Far);
  Layer layer = {"a", {}, {}, {}};
  layer.id = LayerId{3};
  layer.is_hidden = layer.is_locked = layer.is_open = true;
  layer.choice = {7, {{1, 2}}, {}};
  layer.noise = {0};
  layer.bend_pins = {{{11, 12}}, {{13, 14}, 0.75}};
  EXPECT_EQ(project.drawing.layers, std::vector<Layer>{layer});
  EXPECT_EQ(project.drawing.choice, (CloseChoice{{}, {}, {{5, 6}, {7, 8}}}));
  EXPECT_EQ(project.pins, (std::vector<Pin>{{PinId{4}, LayerId{3}, Side::Back, {9, 8}, {7, 6}}}));
  EXPECT_EQ(project.clip, (Clip{2, {{PinId{4}, {{0, {1, 2}}, {1.5, {3, 4}}}, -0.5}}}));
  EXPECT_EQ(project.next_id, 5);
}

// Files without them stay the same to the last byte.
TEST(Inkflate, LaterMembersAreWrittenOnlyWhereTheySaySomething) {
  auto const project = read_document_json(kDocument)->project;
  auto const text = write_document_json(project);
  for (auto const* const name : {"depth", "id", "hidden", "locked", "open", "choice", "noise",
                                 "pins", "clip", "next_id", "bend_pins", "template"}) {
    EXPECT_EQ(text.find('"' + std::string(name) + '"'), text.npos) << name;
  }
}

TEST(Inkflate, DamageInLaterMembersIsRefused) {
  struct Case {
    std::string from;
    std::string to;
  };
  for (auto const& [from, to] : {Case{"\"far\"", "\"away\""},
                                 Case{"\"id\": 3", "\"id\": 0"},
                                 Case{"\"id\": 3", "\"id\": 2147483648"},
                                 Case{"\"hidden\": true", "\"hidden\": 1"},
                                 Case{"\"locked\": true", "\"locked\": \"no\""},
                                 Case{"\"open\": true", "\"open\": null"},
                                 Case{"\"gap\": 7", "\"gap\": 0"},
                                 Case{"\"gap\": 7", "\"gap\": 1e7"},
                                 Case{"[1, 2]},", "[1]},"},
                                 Case{"\"noise\": [0]", "\"noise\": [1]"},
                                 Case{"[11, 12]", "[11]"},
                                 Case{"[11, 12]", "[11, 1e7]"},
                                 Case{"{\"position\": [11, 12]}", "7"},
                                 Case{"0.75", "true"},
                                 Case{"{\"inside\": [5, 6, 7, 8]}", "[]"},
                                 Case{"\"id\": 4", "\"id\": -4"},
                                 Case{"\"layer\": 3", "\"layer\": []"},
                                 Case{"\"back\"", "\"top\""},
                                 Case{"[9, 8]", "[9, 8, 7]"},
                                 Case{"[9, 8]", "[9, 1e999]"},
                                 Case{"\"position\": [7", "\"place\": [7"},
                                 Case{"\"length\": 2", "\"length\": 1"},
                                 Case{"\"length\": 2", "\"length\": -2"},
                                 Case{"\"length\": 2", "\"size\": 2"},
                                 Case{"[0, 1.5]", "[1.5, 1.5]"},
                                 Case{"[0, 1.5]", "[0]"},
                                 Case{"[0, 1.5]", "[-1, 1.5]"},
                                 Case{"-0.5", "\"-\""},
                                 Case{"\"next_id\": 5", "\"next_id\": 0"},
                                 Case{"\"next_id\": 5", "\"next_id\": 1.5"}}) {
    std::string damaged = kGrownDocument;
    auto const at = damaged.find(from);
    ASSERT_NE(at, damaged.npos) << from;
    damaged.replace(at, from.size(), to);
    auto const document = read_document_json(damaged);
    ASSERT_FALSE(document.has_value()) << from << " -> " << to;
    EXPECT_EQ(document.error().code, ErrorCode::BadInput) << document.error().message;
  }
}

TEST(Inkflate, DamagedDocumentsAreRefused) {
  struct Case {
    std::string from;
    std::string to;
    ErrorCode code = ErrorCode::BadInput;
  };
  for (auto const& [from, to, code] :
       {Case{"\"inkflate\"", "\"outkflate\""},
        Case{"\"version\": 1", "\"version\": 0"},
        Case{"\"version\": 1", "\"version\": 2", ErrorCode::Unsupported},
        Case{"\"version\": 1", "\"version\": \"1\""},
        Case{"300", "1e999"},
        Case{"300", "NaN"},
        Case{"300", "-1"},
        Case{"300", "1000001"},
        Case{"\"height\"", "\"heigth\""},
        Case{"\"name\": \"leg\"", "\"name\": 5"},
        Case{"#01020304", "reddish"},
        Case{"\"thickness\": 3", "\"thickness\": 0"},
        Case{"\"help\"", "\"yelp\""},
        Case{"\"width\": 2,", ""},
        Case{"\"group\": 0", "\"group\": 1"},
        Case{"\"group\": 0", "\"group\": -1"},
        Case{"\"group\": 0", "\"group\": 0.5"},
        Case{"3.5, 4]", "3.5]"},
        Case{"3.5, 4]", "3.5, null]"},
        Case{"3.5, 4]", "3.5, 2e6]"},
        Case{"[0, 1],", "[0],"},
        Case{"[0, 1],", "[0, 2],"},
        Case{"[0, 0.25]", "[0, -1]"},
        Case{"[0, 0.25]", "7"},
        Case{"1, 3, 0, 0]", "1, 3, 0, 1]"},
        Case{"3, 0, 0]", "3, 0]"},
        Case{"[\"closing\", 1]", "[\"closing\", 0]"},
        Case{"[\"closing\", 1]", "[\"closing\", 9]"},
        Case{"[\"closing\", 1]", "[\"closing\"]"},
        Case{"[\"closing\", 1]", "[\"c\", 1]"},
        Case{"[0, 1, 0, 0, 1.5]", "[0, 1, 1, 0, 1.5]"},
        Case{"[0, 1, 0, 0, 1.5]", "[0, 1, 0, 0]"},
        Case{"[0, 1, 0, 0, 1.5]", "0"},
        Case{"\"strokes\": [0]", "\"strokes\": [1]"},
        Case{"\"strokes\": [0]", "\"strokes\": {}"},
        Case{"\"stray\": []", "\"stray\": [4294967296]"},
        Case{"\"stray\": []", "\"stray\": "},
        Case{"\"stray\": []", "\"stray\": [\"0\"]"}}) {
    std::string damaged = kDocument;
    auto const at = damaged.find(from);
    ASSERT_NE(at, damaged.npos) << from;
    damaged.replace(at, from.size(), to);
    auto const document = read_document_json(damaged);
    ASSERT_FALSE(document.has_value()) << from << " -> " << to;
    EXPECT_EQ(document.error().code, code) << document.error().message;
  }
}

TEST(Inkflate, FaultsNameTheirPlace) {
  std::string damaged = kDocument;
  damaged.replace(damaged.find("\"a\", \"outlines\""), 3, "5");
  auto const document = read_document_json(damaged);
  ASSERT_FALSE(document.has_value());
  EXPECT_EQ(document.error().message, "document.json: layer 0: name is missing or no text");
  EXPECT_EQ(document.error().index, 0);
}

TEST(Inkflate, JsonLimitsHold) {
  std::string const deep = std::string(65, '[') + std::string(65, ']');
  EXPECT_EQ(read_document_json(deep).error().code, ErrorCode::TooLarge);
  EXPECT_EQ(read_document_json(deep.substr(1, 128)).error().code, ErrorCode::BadInput);
  EXPECT_EQ(read_document_json("[" + std::string(8'000'000, ',') + "]").error().code,
            ErrorCode::TooLarge);
  EXPECT_EQ(read_document_json("\"[[,\\\"[" + std::string(200, '[') + "\"").error().code,
            ErrorCode::BadInput);
}

TEST(Inkflate, WhatTheArchiveLacksIsNamed) {
  using test::bytes_of;
  auto const code = [](test::Bytes const& archive) { return read_inkflate(archive).error().code; };
  EXPECT_EQ(code(test::raw_zip({{"other.json", bytes_of(kDocument)}})), ErrorCode::BadInput);
  std::string text = kDocument;
  text.replace(1, 0, "\"template\": \"t.png\",");
  EXPECT_EQ(code(test::raw_zip({{"document.json", bytes_of(text)}})), ErrorCode::BadInput);
  EXPECT_EQ(code(test::raw_zip({{"document.json", bytes_of(text)}, {"t.png", bytes_of("no")}})),
            ErrorCode::Unsupported);
  EXPECT_EQ(code(bytes_of("PK")), ErrorCode::BadInput);
}

}  // namespace
}  // namespace inkflate
