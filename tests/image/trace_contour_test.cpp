// SPDX-License-Identifier: Apache-2.0
#include "image/trace_contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "image/fill_polygon.h"
#include "image/morphology.h"
#include "support/mask_text.h"

namespace inkflate {
namespace {

/// Points at the centres of pixels given by column and row.
Contour centres(std::vector<std::pair<int, int>> const& pixels) {
  Contour contour;
  for (auto const& [x, y] : pixels) contour.push_back({x + 0.5, y + 0.5});
  return contour;
}

Mask random_mask(Rng& rng, int one_in) {
  Mask mask(24, 20);
  for (auto& value : mask.values) value = rng.below(one_in) == 0 ? 255 : 0;
  return mask;
}

/// The pixels a walk surrounds, with its own.
Mask inside_of(Contour const& walk, Mask const& like) {
  Mask mask(like.width, like.height);
  fill_polygon(std::vector<Contour>{walk}, mask);
  for (auto const p : walk) mask.at(static_cast<int>(p.x), static_cast<int>(p.y)) = 255;
  return mask;
}

/// Whether two pixels of the mask touch at a corner and the other two at that corner are background.
bool has_corner_contact(Mask const& mask) {
  for (int y = 1; y < mask.height; ++y) {
    for (int x = 1; x < mask.width; ++x) {
      if (mask.at(x, y) == mask.at(x - 1, y - 1) && mask.at(x - 1, y) == mask.at(x, y - 1) &&
          mask.at(x, y) != mask.at(x - 1, y)) {
        return true;
      }
    }
  }
  return false;
}

Mask piece_of(Pieces const& pieces, int label) {
  Mask piece(pieces.labels.width, pieces.labels.height);
  for (std::size_t p = 0; p < piece.values.size(); ++p) {
    piece.values[p] = pieces.labels.values[p] == label ? 255 : 0;
  }
  return piece;
}

/// All but the background that reaches the rim of the picture.
Mask with_holes_filled(Mask const& mask) {
  Mask background(mask.width + 2, mask.height + 2, 255);
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) background.at(x + 1, y + 1) = mask.at(x, y) == 0 ? 255 : 0;
  }
  auto const labels = label_pieces(background, Neighbours::Eight).labels;
  Mask filled(mask.width, mask.height);
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) filled.at(x, y) = labels.at(x + 1, y + 1) == 1 ? 0 : 255;
  }
  return filled;
}

void expect_closed_walk_on(Mask const& mask, Contour const& walk) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    auto const p = walk[i];
    auto const step = walk[(i + 1) % walk.size()] - p;
    EXPECT_NE(mask.at(static_cast<int>(p.x), static_cast<int>(p.y)), 0);
    EXPECT_LE(std::max(std::fabs(step.x), std::fabs(step.y)), 1);
  }
}

TEST(LabelPieces, CornersJoinOnlyAmongEightNeighbours) {
  auto const mask = mask_of({"#.#",  //
                             ".#.",  //
                             "..#"});
  EXPECT_EQ(label_pieces(mask, Neighbours::Four).count, 4);
  auto const joined = label_pieces(mask, Neighbours::Eight);
  EXPECT_EQ(joined.count, 1);
  EXPECT_EQ(joined.labels.values, (std::vector<int>{1, 0, 1, 0, 1, 0, 0, 0, 1}));
}

TEST(TraceContours, GoesRoundASquareClockwise) {
  auto const traced = trace_contours(mask_of({".....",  //
                                              ".###.",  //
                                              ".###.",  //
                                              ".###.",  //
                                              "....."}));
  ASSERT_EQ(traced.size(), 1U);
  EXPECT_EQ(traced[0].outer,
            centres({{1, 1}, {2, 1}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}, {1, 2}}));
  EXPECT_TRUE(traced[0].holes.empty());
}

TEST(TraceContours, ReachesEveryPartOfAThinPiece) {
  auto const mask = mask_of({"..#..",  //
                             "..#..",  //
                             "#####",  //
                             "..#..",  //
                             "..###"});
  auto const traced = trace_contours(mask);
  ASSERT_EQ(traced.size(), 1U);
  EXPECT_EQ(inside_of(traced[0].outer, mask), mask);
}

TEST(TraceContours, FollowsPiecesUpToTheRimOfThePicture) {
  Mask const mask(5, 4, 255);
  auto const traced = trace_contours(mask);
  ASSERT_EQ(traced.size(), 1U);
  EXPECT_EQ(std::ssize(traced[0].outer), 14);
  EXPECT_EQ(signed_area(traced[0].outer), 4 * 3);
}

TEST(TraceContours, GoesRoundHolesAgainstTheClock) {
  auto const traced = trace_contours(mask_of({"#######",  //
                                              "#.....#",  //
                                              "#.###.#",  //
                                              "#.#.#.#",  //
                                              "#.###.#",  //
                                              "#.....#",  //
                                              "#######"}));
  ASSERT_EQ(traced.size(), 2U);
  ASSERT_EQ(traced[0].holes.size(), 1U);
  EXPECT_EQ(signed_area(traced[0].outer), 36);
  ASSERT_EQ(traced[1].holes.size(), 1U);
  EXPECT_EQ(signed_area(traced[1].outer), 4);
  // Square tracing cuts some inner corners, half a pixel each.
  EXPECT_NEAR(signed_area(traced[0].holes[0]), -35, 1);
  EXPECT_NEAR(signed_area(traced[1].holes[0]), -3, 1);
}

TEST(TraceContours, WalksStayOnThePieceAndEncloseItWithItsHoles) {
  Rng rng(1);
  int without_contacts = 0;
  for (int i = 0; i < 400; ++i) {
    auto mask = random_mask(rng, i % 2 == 0 ? 2 : 12);
    if (i % 2 == 1) mask = dilate_3x3(mask);
    auto const pieces = label_pieces(mask, Neighbours::Four);
    auto const traced = trace_contours(mask);
    ASSERT_EQ(std::ssize(traced), pieces.count);
    for (int n = 0; n < pieces.count; ++n) {
      auto const piece = piece_of(pieces, n + 1);
      expect_closed_walk_on(piece, traced[n].outer);
      for (auto const& hole : traced[n].holes) expect_closed_walk_on(piece, hole);
      auto const inside = inside_of(traced[n].outer, mask);
      for (std::size_t p = 0; p < piece.values.size(); ++p) {
        EXPECT_LE(piece.values[p], inside.values[p]);
      }
      if (has_corner_contact(piece)) continue;
      ++without_contacts;
      EXPECT_EQ(text_of(inside), text_of(with_holes_filled(piece)));
    }
  }
  EXPECT_GT(without_contacts, 300);
}

TEST(SimpleLoops, CutsAFigureEightInTwo) {
  Contour const walk = {{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}};
  auto const loops = simple_loops(walk);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0], (Contour{{2, 2}, {4, 2}, {4, 4}, {2, 4}}));
  EXPECT_EQ(loops[1], (Contour{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(SimpleLoops, LeavesOutWaysThereAndBack) {
  Contour const walk = {{0, 0}, {2, 0}, {3, 0}, {4, 0}, {3, 0}, {2, 0}, {2, 2}};
  EXPECT_EQ(simple_loops(walk), (std::vector<Contour>{{{0, 0}, {2, 0}, {2, 2}}}));
  EXPECT_TRUE(simple_loops(Contour{{0, 0}, {1, 0}}).empty());
  EXPECT_TRUE(simple_loops(Contour{}).empty());
}

TEST(SimpleLoops, LoopsOfTracedPiecesVisitNoPixelTwice) {
  Rng rng(2);
  for (int i = 0; i < 300; ++i) {
    auto const mask = dilate_3x3(random_mask(rng, 15));
    for (auto const& piece : trace_contours(mask)) {
      double area = 0;
      for (auto& loop : simple_loops(piece.outer)) {
        area += signed_area(loop);
        std::sort(loop.begin(), loop.end(),
                  [](Vec2 a, Vec2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
        EXPECT_EQ(std::adjacent_find(loop.begin(), loop.end()), loop.end());
      }
      EXPECT_EQ(area, signed_area(piece.outer));
    }
  }
}

}  // namespace
}  // namespace inkflate
