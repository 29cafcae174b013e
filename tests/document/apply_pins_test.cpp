// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "document/apply.h"
#include "support/editor_documents.h"
#include "support/refusals.h"

namespace inkflate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A disc (1) with pins 2 and 3 and a clip of 4 s that moves pin 2.
Document pinned() {
  std::vector<Command> const commands = {
      AddPin{{PinId{77}, LayerId{1}, Side::Back, {1, 2}, {3, 4}}},
      AddPin{{{}, LayerId{1}, Side::Front, {5, 5}, {5, 5}}}, SetClipLength{4},
      SetTrack{{PinId{2}, {{0, {1, 1}}, {3, {2, 2}}}, 0.5}}};
  return *inkflate::apply(with_disc(empty_document(), {0, 0}, 50),
                          std::span<Command const>(commands));
}

TEST(AddPin, GetsTheNextId) {
  auto const document = pinned();
  EXPECT_EQ(document.pins->front(), (Pin{PinId{2}, LayerId{1}, Side::Back, {1, 2}, {3, 4}}));
  EXPECT_EQ(document.next_id, 4);
}

TEST(AddPin, RefusesUnknownLayersWildPlacesAndTooMany) {
  EXPECT_EQ(test::refusal(pinned(), AddPin{{{}, LayerId{2}, {}, {}, {}}}), ErrorCode::BadInput);
  EXPECT_EQ(test::refusal(pinned(), AddPin{{{}, LayerId{1}, {}, {kNan, 0}, {}}}),
            ErrorCode::BadInput);
  auto many = pinned();
  many.pins = std::make_shared<std::vector<Pin> const>(1024);
  EXPECT_EQ(test::refusal(many, AddPin{{{}, LayerId{1}, {}, {}, {}}}), ErrorCode::TooLarge);
  auto last = pinned();
  last.next_id = DocumentLimits::kIds;
  EXPECT_EQ(test::refusal(last, AddPin{{{}, LayerId{1}, {}, {}, {}}}), ErrorCode::TooLarge);
}

TEST(MovePins, SetsPositionsAndLeavesRest) {
  auto const after = inkflate::apply(pinned(), MovePins{{PinId{3}, PinId{2}}, {{9, 9}, {8, 8}}});
  ASSERT_TRUE(after);
  EXPECT_EQ((*after->pins)[0].position, (Vec2{8, 8}));
  EXPECT_EQ((*after->pins)[0].rest, (Vec2{1, 2}));
  EXPECT_EQ((*after->pins)[1].position, (Vec2{9, 9}));
}

TEST(MovePins, RefusesWhatDoesNotFit) {
  auto const refused = [](std::vector<PinId> pins, std::vector<Vec2> positions) {
    return test::refusal(pinned(), MovePins{std::move(pins), std::move(positions)});
  };
  EXPECT_EQ(refused({}, {}), ErrorCode::NothingThere);
  EXPECT_EQ(refused({PinId{2}}, {}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{9}}, {{0, 0}}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{2}, PinId{2}}, {{0, 0}, {1, 1}}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{2}}, {{0, 1e300}}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{2}}, {{3, 4}}), ErrorCode::NothingThere);
}

TEST(DeletePins, TakesTheirTracks) {
  auto const after = inkflate::apply(pinned(), DeletePins{{PinId{2}}});
  ASSERT_TRUE(after);
  EXPECT_EQ(after->pins->size(), 1U);
  EXPECT_TRUE(after->clip->tracks.empty());
  EXPECT_EQ(after->clip->length_s, 4);
  auto const other = inkflate::apply(pinned(), DeletePins{{PinId{3}}});
  ASSERT_TRUE(other);
  EXPECT_EQ(other->clip->tracks.size(), 1U);
  EXPECT_EQ(test::refusal(*after, DeletePins{{PinId{2}}}), ErrorCode::BadInput);
  EXPECT_EQ(test::refusal(*after, DeletePins{}), ErrorCode::NothingThere);
}

TEST(SetTrack, ReplacesAddsAndRemoves) {
  Track const other = {PinId{3}, {{1, {0, 0}}}, 0};
  auto const added = inkflate::apply(pinned(), SetTrack{other});
  ASSERT_TRUE(added);
  EXPECT_EQ(added->clip->tracks.back(), other);
  Track const changed = {PinId{2}, {{4, {6, 6}}}, 0};
  auto const replaced = inkflate::apply(*added, SetTrack{changed});
  ASSERT_TRUE(replaced);
  EXPECT_EQ(replaced->clip->tracks, (std::vector<Track>{changed, other}));
  auto const removed = inkflate::apply(*replaced, SetTrack{{PinId{2}, {}, 0}});
  ASSERT_TRUE(removed);
  EXPECT_EQ(removed->clip->tracks, std::vector<Track>{other});
  EXPECT_EQ(test::refusal(*removed, SetTrack{{PinId{2}, {}, 0}}), ErrorCode::NothingThere);
  EXPECT_EQ(test::refusal(*removed, SetTrack{other}), ErrorCode::NothingThere);
}

TEST(SetTrack, RefusesKeysOutOfOrderOrOutsideOfTheClip) {
  auto const refused = [](Track const& track) { return test::refusal(pinned(), SetTrack{track}); };
  EXPECT_EQ(refused({PinId{9}, {{0, {}}}, 0}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{3}, {{5, {}}}, 0}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{3}, {{-1, {}}}, 0}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{3}, {{kNan, {}}}, 0}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{3}, {{1, {}}, {1, {}}}, 0}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{3}, {{1, {kNan, 0}}}, 0}), ErrorCode::BadInput);
  EXPECT_EQ(refused({PinId{3}, {{1, {}}}, kNan}), ErrorCode::BadOption);
  EXPECT_EQ(refused({PinId{3}, std::vector<Key>(100'001), 0}), ErrorCode::TooLarge);
}

TEST(SetClipLength, HoldsAllKeys) {
  auto const after = inkflate::apply(pinned(), SetClipLength{3});
  ASSERT_TRUE(after);
  EXPECT_EQ(after->clip->length_s, 3);
  EXPECT_EQ(after->clip->tracks, pinned().clip->tracks);
  EXPECT_EQ(test::refusal(pinned(), SetClipLength{2.9}), ErrorCode::BadOption);
  EXPECT_EQ(test::refusal(pinned(), SetClipLength{4}), ErrorCode::NothingThere);
  for (double const length_s : {-1.0, kNan, 1e300}) {
    EXPECT_EQ(test::refusal(pinned(), SetClipLength{length_s}), ErrorCode::BadOption);
  }
}

}  // namespace
}  // namespace inkflate
