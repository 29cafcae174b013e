// SPDX-License-Identifier: Apache-2.0
#include "io/read_scap.h"

#include <gtest/gtest.h>

#include "io/bytes.h"

namespace inkflate {
namespace {

Sketch read(std::string const& text) {
  auto const sketch = read_scap(as_bytes(text));
  EXPECT_TRUE(sketch.has_value()) << text;
  return sketch ? *sketch : Sketch{};
}

long long line_of_error(std::string const& text) {
  auto const sketch = read_scap(as_bytes(text));
  EXPECT_FALSE(sketch.has_value()) << text;
  return sketch ? -1 : sketch.error().index;
}

TEST(ReadScap, ReadsCanvasWidthsAndSamples) {
  auto const sketch = read(
      "#593 394\n@1.5\n{\n\t#1\t0\n\t@3\n\t340\t72.5\t0.25\n\t341.149\t73.8188\t0\n}\n"
      "{\n#2 -1\n-5 1000 0\n}\n");
  EXPECT_EQ(sketch.width_px, 593);
  EXPECT_EQ(sketch.height_px, 394);
  ASSERT_EQ(sketch.strokes.size(), 2U);
  EXPECT_EQ(sketch.strokes[0].width_px, 3);
  EXPECT_EQ(sketch.strokes[0].samples,
            (std::vector<Sample>{{{340, 72.5}, 0.25}, {{341.149, 73.8188}, 0}}));
  EXPECT_EQ(sketch.strokes[1].width_px, 1.5);
  EXPECT_EQ(sketch.strokes[1].samples, (std::vector<Sample>{{{-5, 1000}, 1}}));
}

TEST(ReadScap, IsTolerantOfItsDialects) {
  auto const expected = read("#10 20\n@2\n{\n#1 0\n1 2 0\n3 4 0\n}\n");
  for (char const* text : {"#10\t20\n@2\n{\n#1\t0\n1\t2\t0\n3\t4\t0\n}",
                           "#10 20\r\n@2\r\n{\r\n#1 0\r\n1 2\r\n3 4\r\n}\r\n",
                           "# 10 20 \n\n@ 2\n{\n#1 [0, 3]\n\n1 2 0\n3 4 0\n}\n",
                           "#10 20\n@2\n{ #1 0\n 1 2 0\n 3 4 0 }\n",
                           "#10 20\n@2\n{\n#1\n@2\n1 2 0 17.5\n3 4 0 18\n}\n{\n#2 -1\n}\n{\n}\n",
                           "\xef\xbb\xbf#10 20\n@2\n{\n#1 0\n1,2,0\n3 , 4 , 0\n}\n"}) {
    EXPECT_EQ(read(text), expected) << text;
  }
}

TEST(ReadScap, ACanvasThatIsNotToldIsMeasured) {
  auto const sketch = read("{\n1 2 0\n30.5 4 0\n}\n");
  EXPECT_EQ(sketch.width_px, 31);
  EXPECT_EQ(sketch.height_px, 4);
  EXPECT_EQ(read("{}").width_px, 1);
}

TEST(ReadScap, DamageNamesItsLine) {
  EXPECT_EQ(line_of_error("#10 20\n{\n1 2 0\nnan 3 0\n}\n"), 4);
  EXPECT_EQ(line_of_error("#10 20\n{\n1 2 0\n1e7 3 0\n}\n"), 4);
  EXPECT_EQ(line_of_error("#10 20\n{\n1 1e999 0\n}\n"), 3);
  EXPECT_EQ(line_of_error("#10 20\n{\n1\n}\n"), 3);
  EXPECT_EQ(line_of_error("#10 20\n{\n1 2 nan\n}\n"), 3);
  EXPECT_EQ(line_of_error("#10 20\n{\n1 2 0\n"), 4);
  EXPECT_EQ(line_of_error("#10 20\n{\n{\n"), 3);
  EXPECT_EQ(line_of_error("#10 20\n}\n"), 2);
  EXPECT_EQ(line_of_error("#10 20\nwords\n"), 2);
  EXPECT_EQ(line_of_error("#10\n"), 1);
  EXPECT_EQ(line_of_error("#0 20\n"), 1);
  EXPECT_EQ(line_of_error("#10 20\n@-1\n"), 2);
  EXPECT_EQ(line_of_error(""), 1);
  EXPECT_EQ(line_of_error("\xff\xfe#"), 1);
}

TEST(ReadScap, EveryTruncationEndsInAValueOrAnError) {
  auto const text = test_data("scap/dialects.scap");
  ASSERT_EQ(read(text).strokes.size(), 3U);
  for (std::size_t size = 0; size < text.size(); ++size) {
    auto const sketch = read_scap(as_bytes(text.substr(0, size)));
    EXPECT_TRUE(sketch.has_value() || sketch.error().index >= 1) << size;
  }
}

}  // namespace
}  // namespace inkflate
