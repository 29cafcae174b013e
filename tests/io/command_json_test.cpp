// SPDX-License-Identifier: Apache-2.0
#include "io/command_json.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "document/apply.h"
#include "support/random_commands.h"
#include "support/random_drawing.h"

namespace inkflate {
namespace {

// One of each, in the order of Command, with all members that it can have.
constexpr std::array kCommands = {
    R"({"command":"add_stroke","layer":3,"stroke":{"kind":"help","width":2.5,"colour":"#01020304","group":1,"depth":"far","positions":[1.0,2.0,3.0,-0.5],"pressures":[0.5,1.0],"times":[0.0,0.25]}})",
    R"({"command":"erase_area","radius":4.0,"path":[1.0,2.0,3000000.0,4.0]})",
    R"({"command":"erase_strokes","strokes":[[0,7],[3,1]]})",
    R"({"command":"simplify","sets":[{"layer":2,"shapes":[]},{"strokes":[0,2],"depth":"far","shapes":[{"name":"arm","fill":"#ff0000ff","thickness":3.0,"choice":{"gap":9.0,"outside":[1.0,2.0],"inside":[3.0,4.0]},"outlines":[{"points":[0.0,0.0,1.0,0.0,2.0,0.0,3.0,0.0,3.0,1.0,1.0,3.0,0.0,0.0],"kinds":[["ink",1],["closing",1]],"sources":[[0.0,1.0,0,0.0,1.5]]}],"strokes":[0],"details":[1],"noise":[2]}]}],"details":[{"layer":1,"strokes":[1,4]}]})",
    R"({"command":"open_layer","layer":1})",
    R"({"command":"redraw_layer","layer":1})",
    R"({"command":"close_layer","layer":1})",
    R"({"command":"delete_layers","layers":[1,2]})",
    R"({"command":"duplicate_layer","layer":1,"end":"front","offset":[10.0,-2.0]})",
    R"({"command":"set_layer_order","layers":[2,1]})",
    R"({"command":"transform_layers","layers":[1],"map":[1.0,0.0,0.5,2.0,-3.0,4.0]})",
    R"({"command":"bend","parts":[{"layer":2,"outlines":[{"points":[0.0,0.0,1.0,0.0,2.0,0.0,3.0,0.0,3.0,1.0,1.0,3.0,0.0,0.0],"kinds":[["ink",2]],"sources":[[0.0,1.5,-1,0.0,1.5]]}],"samples":[1.0,2.0],"marks":[3.0,4.0]}],"lines":[{"stroke":[0,2],"samples":[5.0,6.0,7.0,8.0]}]})",
    R"({"command":"set_bend_pins","layer":1,"pins":[{"position":[1.0,2.0]},{"position":[3.0,4.0],"turn":-0.5}]})",
    R"({"command":"rename_layer","layer":1,"name":"left \"arm\""})",
    R"({"command":"set_thickness","layer":1,"thickness":4.0})",
    R"({"command":"set_fill","layer":1,"fill":"#00ff0080"})",
    R"({"command":"set_hidden","layer":1,"hidden":true})",
    R"({"command":"set_locked","layer":1,"locked":false})",
    R"({"command":"set_choice","layer":1,"choice":{"gap":12.0,"outside":[5.0,6.0]}})",
    R"({"command":"set_template"})",
    R"({"command":"set_canvas","width":800.0,"height":600.0})",
    R"({"command":"add_pin","pin":{"layer":1,"side":"back","rest":[1.0,2.0],"position":[3.0,4.0]}})",
    R"({"command":"move_pins","pins":[4,5],"positions":[1.0,2.0,3.0,4.0]})",
    R"({"command":"delete_pins","pins":[4]})",
    R"({"command":"set_track","track":{"pin":4,"phase":-0.5,"times":[0.0,0.5],"positions":[1.0,2.0,3.0,4.0]}})",
    R"({"command":"set_clip_length","length":2.5})",
    R"({"command":"replace","document":{"format":"inkflate","version":1,"canvas":{"width":1000.0,"height":1000.0},"layers":[],"strokes":[],"groups":[],"stray":[]}})"};
static_assert(kCommands.size() == std::variant_size_v<Command>);

TEST(CommandJson, IsReadAsItIsSpecifiedAndWrittenAgain) {
  for (std::size_t i = 0; i < kCommands.size(); ++i) {
    auto const command = read_command(kCommands[i]);
    ASSERT_TRUE(command.has_value()) << kCommands[i] << command.error().message;
    EXPECT_EQ(command->index(), i);
    EXPECT_EQ(write_command(*command), kCommands[i]);
  }
}

TEST(CommandJson, MembersMeanWhatTheySay) {
  auto const stroke = std::get<AddStroke>(*read_command(kCommands[0]));
  EXPECT_EQ(stroke.layer, LayerId{3});
  EXPECT_EQ(stroke.stroke, (Stroke{{{{1, 2}, 0.5, 0}, {{3, -0.5}, 1, 0.25}},
                                   StrokeKind::HelpLine,
                                   2.5,
                                   Colour{1, 2, 3, 4},
                                   1,
                                   StrokeDepth::Far}));
  auto const refs = std::get<EraseStrokes>(*read_command(kCommands[2])).strokes;
  EXPECT_EQ(refs, (std::vector<StrokeRef>{{LayerId::None, 7}, {LayerId{3}, 1}}));
  auto const map = std::get<TransformLayers>(*read_command(kCommands[10])).map;
  EXPECT_EQ(map, (Affine{1, 0, 0.5, 2, -3, 4}));
  auto const fill = read_command(R"({"command": "set_fill", "layer": 1, "mood": "good"})");
  EXPECT_EQ(std::get<SetFill>(*fill).fill, std::nullopt);
}

TEST(CommandJson, RandomShapesSurvive) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    auto const drawing = test::random_drawing(rng);
    auto const command = read_command(
        write_command(Simplify{{{LayerId::None, {}, StrokeDepth::Far, drawing.layers}}}));
    ASSERT_TRUE(command.has_value()) << command.error().message;
    EXPECT_EQ(std::get<Simplify>(*command).sets.at(0).shapes, drawing.layers);
    for (auto const& stroke : drawing.sketch.strokes) {
      EXPECT_EQ(std::get<AddStroke>(*read_command(write_command(AddStroke{stroke}))).stroke,
                stroke);
    }
  }
}

// The same text, and the same done to the same document.
TEST(CommandJson, WhatADocumentTakesSurvives) {
  int taken = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Rng rng(seed);
    auto document = test::random_document(rng);
    for (int i = 0; i < 2 * test::kCommandKinds; ++i) {
      auto const command =
          test::random_command(rng, document, i % test::kCommandKinds, test::Wish::Sensible);
      auto next = inkflate::apply(document, command);
      if (!next) continue;
      ++taken;
      auto const text = write_command(command);
      auto const again = read_command(text);
      ASSERT_TRUE(again.has_value()) << text << again.error().message;
      ASSERT_EQ(write_command(*again), text);
      auto const repeated = inkflate::apply(document, *again);
      ASSERT_TRUE(repeated.has_value()) << text << repeated.error().message;
      ASSERT_EQ(to_project(*repeated), to_project(*next)) << text;
      document = *std::move(next);
    }
  }
  EXPECT_GT(taken, 12 * test::kCommandKinds);
}

TEST(CommandJson, WhatNoDocumentTakesEndsInACommandOrAnError) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Rng rng(seed);
    auto const document = test::random_document(rng);
    for (int kind = 0; kind < test::kCommandKinds; ++kind) {
      auto const command = test::random_command(rng, document, kind, test::Wish::Hostile);
      if (std::holds_alternative<Replace>(command)) continue;  // a document that is no document
      auto const text = write_command(command);
      auto const again = read_command(text);
      if (again) {
        EXPECT_EQ(write_command(*again), text);
      }
    }
  }
}

Picture small_picture() {
  Picture picture(3, 2, Colour{10, 20, 30, 255});
  picture.values[4] = {1, 2, 3, 4};
  return picture;
}

TEST(CommandJson, PicturesKeepTheirPixels) {
  SetTemplate const command = {std::make_shared<Picture const>(small_picture())};
  auto const again = read_command(write_command(command));
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ(*std::get<SetTemplate>(*again).picture, small_picture());
}

TEST(CommandJson, AnotherDocumentComesWhole) {
  Project project;
  project.drawing.sketch = {
      320,
      200,
      {},
      {Stroke{{{{1, 2}}}, StrokeKind::Ink, 2, {}}, Stroke{{{{3, 4}}}, StrokeKind::Ink, 2, {}}}};
  project.drawing.layers = {{"body", {}, {0}, {}}};
  project.drawing.layers[0].id = LayerId{4};
  project.drawing.layers[0].is_open = true;
  project.drawing.stray = {1};
  project.pins = {{PinId{5}, LayerId{4}, Side::Back, {1, 1}, {2, 2}}};
  project.clip = {2, {{PinId{5}, {{0, {2, 2}}, {1.5, {3, 3}}}, 0.25}}};
  project.next_id = 6;
  project.template_picture = small_picture();
  auto const document = make_document(project);
  ASSERT_TRUE(document.has_value()) << document.error().message;
  auto const again = read_command(write_command(Replace{*document}));
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ(to_project(std::get<Replace>(*again).document), project);
}

struct Damage {
  int command;
  std::string from;
  std::string to;
  ErrorCode code = ErrorCode::BadInput;
};

TEST(CommandJson, DamageIsRefused) {
  for (auto const& [command, from, to, code] :
       {Damage{0, "\"command\"", "\"c\""},
        Damage{0, "add_stroke", "add_strokes"},
        Damage{0, "\"layer\":3", "\"layer\":-1"},
        Damage{0, "\"layer\":3", "\"layer\":0.5"},
        Damage{0, "\"stroke\"", "\"line\""},
        Damage{0, "\"far\"", "\"away\""},
        Damage{0, "\"far\"", "1"},
        Damage{0, "2.5", "-1"},
        Damage{0, "-0.5]", "1e7]"},
        Damage{0, "}}", "}"},
        Damage{1, "4.0,", "\"4\","},
        Damage{1, "4.0,", "1e999,"},
        Damage{1, ",4.0]", "]"},
        Damage{2, "[3,1]", "[3]"},
        Damage{2, "[3,1]", "[3,-1]"},
        Damage{2, "[3,1]", "3"},
        Damage{3, "[0,2]", "[0,-2]"},
        Damage{3, "\"shapes\":[]", "\"shapes\":{}"},
        Damage{3, "\"gap\":9.0", "\"gap\":0"},
        Damage{3, "\"noise\":[2]", "\"noise\":[2.5]"},
        Damage{3, "{\"gap\"", "[{\"gap\""},
        Damage{7, "[1,2]", "[1,\"2\"]"},
        Damage{8, "front", "top"},
        Damage{8, "[10.0,-2.0]", "[10.0]"},
        Damage{10, "4.0]", "4.0,5.0]"},
        Damage{10, "4.0]", "null]"},
        Damage{11, "[5.0,6.0,7.0,8.0]", "[5.0,6.0,7.0]"},
        Damage{11, "\"stroke\":[0,2]", "\"stroke\":[0]"},
        Damage{11, "\"stroke\":[0,2]", "\"stroke\":2"},
        Damage{11, "[\"ink\",2]", "[\"ink\",1]"},
        Damage{11, "1.0,3.0,0.0,0.0]", "1.0,3.0,0.0,0.5]"},
        Damage{11, "\"layer\":2", "\"layer\":-2"},
        Damage{11, "[3.0,4.0]", "7"},
        Damage{12, "[1.0,2.0]", "[1.0,2e6]"},
        Damage{12, "\"position\":[3.0", "\"place\":[3.0"},
        Damage{12, "-0.5", "\"-0.5\""},
        Damage{12, "[{", "[[{"},
        Damage{13, "\"name\"", "\"n\""},
        Damage{14, ":4.0", ":true"},
        Damage{15, "#00ff0080", "green-ish"},
        Damage{16, "true", "1"},
        Damage{18, "12.0", "-12.0"},
        Damage{18, "{\"gap\":12.0,\"outside\":[5.0,6.0]}", "7"},
        Damage{19, "\"}", "\",\"picture\":\"!\"}"},
        Damage{19, "\"}", "\",\"picture\":\"AAAA\"}", ErrorCode::Unsupported},
        Damage{19, "\"}", "\",\"picture\":7}"},
        Damage{20, "600.0", "[600]"},
        Damage{21, "\"back\"", "\"left\""},
        Damage{21, "[3.0,4.0]", "[3.0,4e6]"},
        Damage{22, "[4,5]", "{}"},
        Damage{24, "[0.0,0.5]", "[0.5,0.5]"},
        Damage{24, "[0.0,0.5]", "[0.0]"},
        Damage{24, "\"pin\":4", "\"pin\":\"4\""},
        Damage{25, "2.5", "\"2.5\""},
        Damage{26, "\"version\":1", "\"version\":2", ErrorCode::Unsupported},
        Damage{26, "\"stray\":[]", "\"stray\":[0]"},
        Damage{26, "\"stray\":[]", "\"next_id\":0"},
        Damage{26, "\"layers\":[]", "\"layers\":[{\"name\":\"a\",\"id\":1}]"},
        Damage{26, "\"document\"", "\"d\""}}) {
    std::string damaged = kCommands[static_cast<std::size_t>(command)];
    auto const at = damaged.rfind(from);
    ASSERT_NE(at, damaged.npos) << from;
    damaged.replace(at, from.size(), to);
    auto const read = read_command(damaged);
    ASSERT_FALSE(read.has_value()) << damaged;
    EXPECT_EQ(read.error().code, code) << damaged << read.error().message;
  }
}

TEST(CommandJson, OtherJsonAndTooMuchOfItAreRefused) {
  for (auto const* const text :
       {"", "{}", "[]", "7", "null", "{\"command\": 7}", "[{\"command\":\"undo\"}]"}) {
    EXPECT_EQ(read_command(text).error().code, ErrorCode::BadInput) << text;
  }
  EXPECT_EQ(read_command(std::string(65, '[') + std::string(65, ']')).error().code,
            ErrorCode::TooLarge);
}

}  // namespace
}  // namespace inkflate
