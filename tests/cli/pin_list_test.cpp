// SPDX-License-Identifier: Apache-2.0
#include "cli/pin_list.h"

#include <gtest/gtest.h>

namespace inkflate::cli {
namespace {

TEST(PinList, AFileSaysAllOfAPin) {
  auto const file = read_pins(R"({"mode": "wire", "body": 0.5, "pins": [
    {"part": "arm", "at": [1, 2.5], "to": [3, -4], "turn": 90}, {"at": [5, 6]}, {"part": 2, "at": [7, 8]}]})",
                              "p.json");
  ASSERT_TRUE(file.has_value()) << file.error().message;
  EXPECT_EQ(file->mode, BendMode::Wire);
  EXPECT_EQ(file->body, 0.5);
  ASSERT_EQ(file->pins.size(), 3U);
  auto const& pin = file->pins[0];
  EXPECT_EQ(pin.source, "p.json: pin 1");
  EXPECT_EQ(pin.part, "arm");
  EXPECT_EQ(pin.at, (Vec2{1, 2.5}));
  EXPECT_EQ(pin.to, (Vec2{3, -4}));
  EXPECT_EQ(pin.turn_deg, 90);
  EXPECT_EQ(file->pins[1].part, "");
  EXPECT_EQ(file->pins[1].to, std::nullopt);
  EXPECT_EQ(file->pins[1].turn_deg, std::nullopt);
  EXPECT_EQ(file->pins[2].part, "2");
}

TEST(PinList, TooManyPinsAreRefused) {
  std::string text = "{\"pins\": [{\"at\": [0, 0]}";
  for (int i = 1; i < kMaxPins; ++i) text += ", {\"at\": [0, 0]}";
  EXPECT_TRUE(read_pins(text + "]}", "p").has_value());
  EXPECT_EQ(read_pins(text + ", {\"at\": [0, 0]}]}", "p").error().code, ErrorCode::TooLarge);
}

TEST(PinList, AWordSaysPartPlaceTargetAndTurn) {
  struct Case {
    std::string text;
    std::string part;
    Vec2 at;
    std::optional<Vec2> to = {};
    std::optional<double> turn_deg = {};
  };
  for (auto const& [text, part, at, to, turn_deg] :
       {Case{"arm:1,2", "arm", {1, 2}}, Case{"arm:1,2:3,4", "arm", {1, 2}, Vec2{3, 4}},
        Case{"arm:1,2:3,4:-90", "arm", {1, 2}, Vec2{3, 4}, -90},
        Case{"arm:1,2:30", "arm", {1, 2}, {}, 30}, Case{":1,2:3,4", "", {1, 2}, Vec2{3, 4}},
        Case{"left: arm:1,2:3,4:0", "left: arm", {1, 2}, Vec2{3, 4}, 0},
        Case{"7:1,2:3,4", "7", {1, 2}, Vec2{3, 4}}}) {
    auto const pin = parse_pin(text, 1);
    ASSERT_TRUE(pin.has_value()) << text << pin.error().message;
    EXPECT_EQ(pin->source, "--pin 1");
    EXPECT_EQ(pin->part, part) << text;
    EXPECT_EQ(pin->at, at) << text;
    EXPECT_EQ(pin->to, to) << text;
    EXPECT_EQ(pin->turn_deg, turn_deg) << text;
  }
  for (auto const* const text : {"", "arm", "1,2", "arm:1", "arm:1,2:", "arm:1,2:x", "arm:nan,2",
                                 "arm:1,2:3,4:5:6", "arm:1e7,2"}) {
    auto const pin = parse_pin(text, 3);
    ASSERT_FALSE(pin.has_value()) << text;
    EXPECT_EQ(pin.error().code, ErrorCode::BadOption);
    EXPECT_NE(pin.error().message.find("--pin 3"), std::string::npos);
  }
}

}  // namespace
}  // namespace inkflate::cli
