// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "editor/pick.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

constexpr LayerId kDisc{1};

Document disc_of(double radius) { return with_disc(empty_document(), {500, 500}, radius); }

View view_with(std::vector<LayerId> selection) {
  View view;
  view.camera = {{500, 500}, 1, false};
  view.selection = std::move(selection);
  return view;
}

Vec2 handle_place(Frame const& frame, FrameHandle handle) {
  for (auto const& [name, place] : frame.handles) {
    if (name == handle) return place;
  }
  ADD_FAILURE() << "no such handle";
  return {};
}

TEST(SelectionFrame, HasEightHandlesAndOneToTurnAboveTheTop) {
  auto const frame = selection_frame(disc_of(100), view_with({kDisc}));
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->handles.size(), 9u);
  EXPECT_NEAR(distance(handle_place(*frame, FrameHandle::TopLeft), {400, 400}), 0, 1e-9);
  EXPECT_NEAR(distance(handle_place(*frame, FrameHandle::Right), {600, 500}), 0, 1e-9);
  auto const turn = handle_place(*frame, FrameHandle::Turn);
  EXPECT_NEAR(turn.x, 500, 1e-9);
  EXPECT_LT(turn.y, 400 - 20);
}

TEST(SelectionFrame, FollowsZoomAndMirror) {
  auto view = view_with({kDisc});
  view.camera.zoom = 2;
  view.camera.is_mirrored = true;
  auto const frame = selection_frame(disc_of(100), view);
  ASSERT_TRUE(frame);
  // The left side of the canvas is to the right on the screen.
  EXPECT_NEAR(distance(handle_place(*frame, FrameHandle::Left), {700, 500}), 0, 1e-9);
  EXPECT_LT(handle_place(*frame, FrameHandle::Turn).y, 300 - 20);
}

TEST(SelectionFrame, ThereIsNoneAroundNothing) {
  auto const document = disc_of(100);
  EXPECT_FALSE(selection_frame(document, view_with({})));
  EXPECT_FALSE(selection_frame(document, view_with({LayerId{5}})));
  auto const locked = with_changed(document, kDisc, [](Layer& layer) { layer.is_locked = true; });
  EXPECT_FALSE(selection_frame(locked, view_with({kDisc})));
  EXPECT_FALSE(selection_frame(with_open(document, {}), view_with({LayerId{2}})));
}

TEST(PickHandle, EachIsFoundWhereItIsDrawn) {
  auto view = view_with({kDisc});
  view.camera.is_mirrored = true;
  auto const frame = selection_frame(disc_of(100), view);
  ASSERT_TRUE(frame);
  for (auto const& [handle, place] : frame->handles) {
    EXPECT_EQ(pick_handle(*frame, view, place), handle);
    EXPECT_EQ(pick_handle(*frame, view, place + Vec2{6, -6}), handle);
  }
}

TEST(PickHandle, WithinIsInsideAndFarIsNothing) {
  auto const view = view_with({kDisc});
  auto const frame = selection_frame(disc_of(100), view);
  EXPECT_EQ(pick_handle(*frame, view, {500, 500}), FrameHandle::Inside);
  EXPECT_FALSE(pick_handle(*frame, view, {700, 500}));
}

TEST(PickHandle, ASmallSelectionCanStillBeMoved) {
  auto const view = view_with({kDisc});
  auto const frame = selection_frame(disc_of(6), view);
  EXPECT_EQ(pick_handle(*frame, view, {500, 500}), FrameHandle::Inside);
  EXPECT_EQ(pick_handle(*frame, view, {505, 505}), FrameHandle::Inside);
  EXPECT_EQ(pick_handle(*frame, view, {509, 509}), FrameHandle::BottomRight);
}

}  // namespace
}  // namespace inkflate
