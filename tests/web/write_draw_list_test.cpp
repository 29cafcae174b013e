// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/write_draw_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "io/float_bytes.h"

namespace inkflate::web {
namespace {

/// Reads what was written, as the page does.
class Words {
 public:
  explicit Words(DrawList const& list) { write_draw_list(list, bytes_); }

  std::uint32_t whole() { return little_endian32(next()); }
  double real() { return little_endian_float32(next()); }
  std::vector<double> reals(int count) {
    std::vector<double> result;
    for (int i = 0; i < count; ++i) result.push_back(real());
    return result;
  }
  bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  std::span<std::byte const> next() {
    at_ += 4;
    return std::span(bytes_).subspan(at_ - 4, 4);
  }

  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
};

TEST(WriteDrawList, RedIsInTheLowestByteOfAColour) {
  EXPECT_EQ(packed({0x12, 0x34, 0x56, 0x78}), 0x78563412U);
}

TEST(WriteDrawList, AnEmptyListHasNoBytes) { EXPECT_TRUE(Words({}).is_at_end()); }

TEST(WriteDrawList, FillsHaveTheirContours) {
  Words words({FilledPath{{{{1, 2}, {3, 4}, {5, 6}}, {}}, {1, 0, 0, 0}}});
  EXPECT_EQ(words.whole(), 0U);
  EXPECT_EQ(words.whole(), 1U);
  EXPECT_EQ(words.whole(), 2U);
  EXPECT_EQ(words.whole(), 3U);
  EXPECT_EQ(words.reals(6), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(words.whole(), 0U);
  EXPECT_TRUE(words.is_at_end());
}

TEST(WriteDrawList, StrokesHaveCountsBeforeNumbersAndMayBeOfAnyWidth) {
  StrokedPolyline const line = {{{1, 2}, {3, 4}}, {2, 2.5}, {6, 3}, {0, 0, 0, 1}, {0.75}};
  Words words({line});
  EXPECT_EQ(words.whole(), 1U);
  EXPECT_EQ(words.whole(), 0x01000000U);
  EXPECT_EQ(words.whole(), 2U);
  EXPECT_EQ(words.whole(), 2U);
  EXPECT_EQ(words.whole(), 2U);
  EXPECT_EQ(words.real(), 0.75);
  EXPECT_TRUE(std::isinf(words.real()));
  EXPECT_EQ(words.reals(8), (std::vector<double>{1, 2, 3, 4, 2, 2.5, 6, 3}));
  EXPECT_TRUE(words.is_at_end());
}

TEST(WriteDrawList, DotsHaveTheirDiameter) {
  Words words({Dots{{{1, 2}}, 4, {0, 0, 0, 0}}});
  EXPECT_EQ(words.whole(), 2U);
  EXPECT_EQ(words.whole(), 0U);
  EXPECT_EQ(words.whole(), 1U);
  EXPECT_EQ(words.reals(3), (std::vector<double>{4, 1, 2}));
  EXPECT_TRUE(words.is_at_end());
}

TEST(WriteDrawList, PicturesHaveTheirPixelsAndNoneIsLeftOut) {
  auto const picture = std::make_shared<Picture const>(2, 1, Colour{1, 2, 3, 4});
  Words words({DrawnPicture{nullptr, {}, 1}, DrawnPicture{picture, {1, 2, 3, 4, 5, 6}, 0.5}});
  EXPECT_EQ(words.whole(), 3U);
  EXPECT_EQ(words.real(), 0.5);
  EXPECT_EQ(words.whole(), 2U);
  EXPECT_EQ(words.whole(), 1U);
  EXPECT_EQ(words.reals(6), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(words.whole(), 0x04030201U);
  EXPECT_EQ(words.whole(), 0x04030201U);
  EXPECT_TRUE(words.is_at_end());
}

}  // namespace
}  // namespace inkflate::web
