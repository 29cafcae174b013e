// SPDX-License-Identifier: Apache-2.0
// Files made to crash, freeze or bloat a reader.
#include <gtest/gtest.h>

#include "io/bytes.h"
#include "io/read_svg.h"
#include "io/svg_tree.h"
#include "io/svg_walk.h"

namespace inkflate {
namespace {

std::string repeated(std::string_view part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

std::string svg(std::string const& body) {
  return "<svg width='10' height='10' stroke='red' fill='none'>" + body + "</svg>";
}

// "5 strokes" with what was left out, or "code@byte".
std::string outcome(std::string const& document) {
  auto const reading = read_svg_with_warnings(as_bytes(document));
  if (!reading) {
    auto const& error = reading.error();
    return error_code_name(error.code) + ("@" + std::to_string(error.index));
  }
  std::string text = std::to_string(reading->drawing.sketch.strokes.size()) + " strokes";
  for (auto const& warning : reading->warnings) {
    text += "; " + warning.reason + " x" + std::to_string(warning.count);
  }
  for (auto const& stroke : reading->drawing.sketch.strokes) {
    for (auto const& sample : stroke.samples) EXPECT_TRUE(is_finite(sample.position));
  }
  return text;
}

TEST(HostileSvg, FilesThatAreNotSvgAreNamed) {
  EXPECT_EQ(outcome(""), "bad_input@0");
  EXPECT_EQ(outcome("hello"), "bad_input@0");
  EXPECT_EQ(outcome("<html/>"), "bad_input@0");
  EXPECT_EQ(outcome("<!-- --> <g/>"), "bad_input@9");
  EXPECT_EQ(outcome("\x1f\x8b\x08"), "unsupported@0");
  EXPECT_EQ(outcome(std::string("\xff\xfe<\0s\0v\0g\0", 10)), "unsupported@0");
  EXPECT_EQ(outcome(std::string(100, '\0')), "unsupported@0");
}

TEST(HostileSvg, EntitiesAreRefused) {
  EXPECT_EQ(outcome("<!DOCTYPE svg [<!ENTITY a 'aaa'><!ENTITY b '&a;&a;&a;'>]><svg>&b;</svg>"),
            "unsupported@15");
  EXPECT_EQ(outcome("<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><svg>&x;</svg>"),
            "unsupported@15");
  EXPECT_EQ(outcome("<svg>&lol9;</svg>"), "bad_input@5");
}

TEST(HostileSvg, DepthIsLimited) {
  EXPECT_EQ(outcome(svg(repeated("<g>", 100'000) + repeated("</g>", 100'000))).substr(0, 9),
            "too_large");
  EXPECT_EQ(outcome(svg(repeated("<g>", 1000) + "<line x2='1'/>" + repeated("</g>", 1000))),
            "1 strokes");
  EXPECT_EQ(outcome(repeated("<svg>", 100'000)).substr(0, 9), "too_large");
}

TEST(HostileSvg, AttributesAreLimited) {
  std::string tag = "<line x2='5'";
  for (int i = 0; i < 65'534; ++i) tag += " a" + std::to_string(i) + "=''";
  EXPECT_EQ(outcome(svg(tag + "/>")), "1 strokes");
  EXPECT_EQ(outcome(svg(tag + " b='' c=''/>")), "too_large@53");
}

TEST(HostileSvg, EveryTruncationIsAnError) {
  auto const document = test_data("svg/sampler.svg");
  ASSERT_GT(document.size(), 500U);
  ASSERT_EQ(outcome(document).substr(0, 2), "19");
  for (std::size_t size = 0; size < document.size() - 1; ++size) {
    ASSERT_FALSE(read_svg(as_bytes(document.substr(0, size))).has_value()) << size;
  }
}

TEST(HostileSvg, EveryChangedByteEndsInAValueOrAnError) {
  auto const document = test_data("svg/sampler.svg");
  for (std::size_t i = 0; i < document.size(); ++i) {
    for (char const c : {'\0', '<', '9', '"', '\xff', '-'}) {
      auto changed = document;
      changed[i] = c;
      auto const reading = read_svg(as_bytes(changed));
      EXPECT_TRUE(reading.has_value() || reading.error().index >= 0);
    }
  }
}

TEST(HostileSvg, OddNumbersSkipTheElementAlone) {
  std::string const far = "; a coordinate beyond 1e6 px x1";
  EXPECT_EQ(outcome(svg("<line x2='1'/><line x2='1e300'/>")), "1 strokes" + far);
  EXPECT_EQ(outcome(svg("<line x2='NaN'/>")), "1 strokes");  // not a length: the default of 0
  EXPECT_EQ(outcome(svg("<line x2='1e999'/>")), "1 strokes");
  EXPECT_EQ(outcome(svg("<g transform='scale(1e200) scale(1e200)'><line x2='1'/></g>")),
            "0 strokes" + far);
  EXPECT_EQ(
      outcome(svg(
          "<g transform='matrix(1e308 1e308 -1e308 1e308 1e308 1e308)'><circle r='1e308'/></g>")),
      "0 strokes" + far);
  EXPECT_EQ(outcome(svg("<line x2='1' stroke-width='1e300'/>")), "0 strokes" + far);
  EXPECT_EQ(outcome(svg("<g transform='matrix(0 0 0 0 0 0)'><circle r='5'/></g>")), "0 strokes");
  EXPECT_EQ(outcome(svg("<g transform='skewX(90)'><line y2='5'/></g>")), "0 strokes" + far);
  EXPECT_EQ(outcome(svg("<ellipse rx='1e-300' ry='1e6'/>")), "1 strokes");
  EXPECT_EQ(outcome(svg("<path d='M0 0A1e-300 1e-300 1e300 1 1 9 9'/>")), "0 strokes" + far);
  EXPECT_EQ(
      outcome(
          "<svg viewBox='0 0 1e-300 1e-300' width='10' height='10'><path d='M0 0L1 1L0 1'/></svg>"),
      "0 strokes" + far);
  EXPECT_EQ(outcome("<svg viewBox='0 0 1e300 1e-300' width='1e300'><path d='M0 0L1 1L0 1'/></svg>")
                .substr(2, 7),
            "strokes");
}

TEST(HostileSvg, UsesOfThemselvesAreLeftOut) {
  std::string const line = "<line x2='1'/>";
  std::string const cycle = "; a use of itself x";
  EXPECT_EQ(outcome(svg("<use id='a' href='#a'/>" + line)), "1 strokes" + cycle + "1");
  EXPECT_EQ(outcome(svg("<g id='a'>" + line + "<use href='#a'/></g>")), "1 strokes" + cycle + "1");
  EXPECT_EQ(outcome(svg("<g id='a'>" + line + "<use href='#b'/></g><g id='b'>" + line +
                        "<use href='#a'/></g>")),
            "4 strokes" + cycle + "2");
  EXPECT_EQ(outcome("<svg id='a' stroke='red'><use href='#a'/>" + line + "</svg>"),
            "1 strokes" + cycle + "1");
}

TEST(HostileSvg, ExponentialUseIsLimited) {
  std::string body = "<defs><g id='a0'><line x2='1'/></g>";
  for (int i = 1; i <= 40; ++i) {
    auto const use = "<use href='#a" + std::to_string(i - 1) + "'/>";
    body += "<g id='a" + std::to_string(i) + "'>" + repeated(use, 10) + "</g>";
  }
  std::string const document = svg(body + "</defs><use href='#a40'/>");
  auto const tree = read_svg_tree(document);
  ASSERT_TRUE(tree.has_value());
  SvgLimits limits;
  limits.use_expansions = 1000;
  auto const reading = SvgWalk(*tree, limits).run();
  EXPECT_LE(reading.drawing.sketch.strokes.size(), 1000U);
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_EQ(reading.warnings[0].reason, "more uses than are expanded");
}

TEST(HostileSvg, EveryLimitOfTheWalkHolds) {
  std::string const document =
      svg("<defs><path id='p' d='M0 0L1 1 2 2 3 3'/></defs>" + repeated("<use href='#p'/>", 50));
  auto const tree = read_svg_tree(document);
  ASSERT_TRUE(tree.has_value());
  auto const strokes = [&](SvgLimits const& limits) {
    auto const reading = SvgWalk(*tree, limits).run();
    EXPECT_EQ(reading.warnings.size(), reading.drawing.sketch.strokes.size() == 50 ? 0U : 1U);
    return reading.drawing.sketch.strokes.size();
  };
  EXPECT_EQ(strokes({}), 50U);
  SvgLimits limits;
  limits.points_per_element = 3;
  EXPECT_EQ(strokes(limits), 0U);
  limits = {};
  limits.samples = 43;
  EXPECT_EQ(strokes(limits), 10U);
  limits = {};
  limits.strokes = 7;
  EXPECT_EQ(strokes(limits), 7U);
  limits = {};
  limits.use_expansions = 5;
  EXPECT_EQ(strokes(limits), 5U);
  limits = {};
  limits.use_depth = 0;
  EXPECT_EQ(strokes(limits), 0U);
  limits = {};
  limits.copied_bytes = -4000;
  EXPECT_LT(strokes(limits), 50U);
}

TEST(HostileSvg, NothingOutsideTheFileIsUsed) {
  EXPECT_EQ(outcome(svg("<script>alert(1)</script><foreignObject><line x2='1'/></foreignObject>"
                        "<line x2='1' onclick='alert(1)'/>")),
            "1 strokes; text or a picture, which is not a line x1");
  EXPECT_EQ(outcome(svg("<use href='other.svg#a'/><use href='http://example.org/#a'/>"
                        "<use xlink:href='file:///etc/passwd#a'/><use href='data:x'/>")),
            "0 strokes; a use of another file, which is never opened x4");
  EXPECT_EQ(
      outcome("<?xml-stylesheet href='http://example.org/x.css'?><svg><style>@import url(x.css);"
              "</style></svg>"),
      "0 strokes");
}

TEST(HostileSvg, LongSheetsAndClassListsAreCut) {
  auto const sheet = "<style>" + repeated(".a{stroke:blue}", 20'000) + "</style>";
  EXPECT_EQ(outcome(svg(sheet + repeated("<line x2='1' class='a a a a a a'/>", 100))),
            "100 strokes; a style sheet that is too long x1");
  EXPECT_EQ(outcome(svg("<style>.a{stroke:blue}</style><line x2='1' class='" +
                        repeated("a ", 100'000) + "'/>")),
            "1 strokes");
  EXPECT_EQ(
      outcome(svg("<style>/* {{{ </style><line x2='1' style='" + repeated(":;", 1000) + "'/>")),
      "1 strokes");
}

TEST(HostileSvg, LongPathsAreLimited) {
  EXPECT_EQ(outcome(svg("<path d='M0 0" + repeated("h1", 1'000'000) + "'/><line x2='1'/>")),
            "1 strokes; too many points x1");
}

}  // namespace
}  // namespace inkflate
