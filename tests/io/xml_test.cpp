// SPDX-License-Identifier: Apache-2.0
#include "io/xml.h"

#include <gtest/gtest.h>

#include "io/xml_text.h"

namespace inkflate {
namespace {

// "<name attribute=value>", "</>" and the text, in order; a failure as "code@byte".
std::string events_of(std::string_view document, XmlLimits const& limits = {}) {
  auto reader = XmlReader::open(document, limits);
  std::string events;
  auto const failed = [&](Error const& error) {
    return events + error_code_name(error.code) + "@" + std::to_string(error.index);
  };
  if (!reader) return failed(reader.error());
  while (true) {
    auto const event = reader->next();
    if (!event) return failed(event.error());
    if (*event == XmlEvent::End) return events;
    if (*event == XmlEvent::Close) events += "</>";
    if (*event == XmlEvent::Text) events += reader->text();
    if (*event != XmlEvent::Open) continue;
    events += "<" + std::string(reader->tag().name);
    for (auto const& [name, value] : reader->tag().attributes) {
      events += " " + std::string(name) + "=" + decode_xml(value);
    }
    events += ">";
  }
}

TEST(Xml, ReadsElementsAttributesAndText) {
  EXPECT_EQ(events_of("<a x='1' y = \"2\"><b/>t<c>u</c ></a>"), "<a x=1 y=2><b></>t<c>u</></>");
}

TEST(Xml, PassesOverWhatIsNotContent) {
  EXPECT_EQ(events_of("\xef\xbb\xbf<?xml version='1.0'?><!-- <x> --><!DOCTYPE svg PUBLIC '-' 'u'>\n"
                      "<a><!-- - > --><?p <y> ?></a>\n<!-- end -->\n"),
            "<a></>");
  EXPECT_EQ(events_of("<!DOCTYPE a [<!ELEMENT a EMPTY>]><a/>"), "<a></>");
}

TEST(Xml, CdataIsText) { EXPECT_EQ(events_of("<a><![CDATA[<b>&x;]]></a>"), "<a><b>&x;</>"); }

TEST(Xml, ResolvesPredefinedAndNumericReferences) {
  EXPECT_EQ(events_of("<a x='&lt;&gt;&amp;&quot;&apos;&#65;&#x42;&#x10d;&#x1F600;'/>"),
            "<a x=<>&\"'AB\xc4\x8d\xf0\x9f\x98\x80></>");
}

TEST(Xml, RefusesOtherReferences) {
  for (char const* body : {"&foo;", "&", "&amp", "&#;", "&#x;", "&#0;", "&#xd800;", "&#x110000;",
                           "&#99999999999999999999;"}) {
    EXPECT_EQ(events_of("<a x='" + std::string(body) + "'/>"), "bad_input@6") << body;
    EXPECT_EQ(events_of("<a>" + std::string(body) + "</a>"), "<a>bad_input@3") << body;
  }
}

TEST(Xml, RefusesDeclaredEntities) {
  EXPECT_EQ(events_of("<!DOCTYPE a [<!ENTITY x 'y'>]><a>&x;</a>"), "unsupported@13");
}

TEST(Xml, RefusesUtf16) {
  EXPECT_EQ(events_of(std::string_view("\xff\xfe<\0a\0", 6)), "unsupported@0");
  EXPECT_EQ(events_of(std::string_view("\xfe\xff\0<", 4)), "unsupported@0");
  EXPECT_EQ(events_of(std::string_view("<\0a\0", 4)), "unsupported@0");
}

TEST(Xml, NamesTheByteOfDamage) {
  EXPECT_EQ(events_of("<a><b></a>"), "<a><b>bad_input@6");
  EXPECT_EQ(events_of("<a></a></b>"), "<a></>bad_input@7");
  EXPECT_EQ(events_of("<a/><b/>"), "<a></>bad_input@4");
  EXPECT_EQ(events_of("<a x=1/>"), "bad_input@4");
  EXPECT_EQ(events_of("<a x='1'y='2'/>"), "bad_input@8");
  EXPECT_EQ(events_of("<a x='<'/>"), "bad_input@5");
  EXPECT_EQ(events_of("word"), "bad_input@0");
  EXPECT_EQ(events_of("<a/>word"), "<a></>bad_input@4");
  EXPECT_EQ(events_of("< a/>"), "bad_input@0");
  EXPECT_EQ(events_of(""), "bad_input@0");
}

TEST(Xml, EveryTruncationIsAnError) {
  std::string const document =
      "<?xml version='1.0'?><!-- c --><a x='&amp;'><b y=\"2\"/>t<![CDATA[u]]></a>";
  ASSERT_EQ(events_of(document), "<a x=&><b y=2></>tu</>");
  for (std::size_t size = 0; size < document.size(); ++size) {
    EXPECT_NE(events_of(document.substr(0, size)).find("bad_input@"), std::string::npos) << size;
  }
}

TEST(Xml, LimitsAreTypedErrors) {
  XmlLimits limits;
  limits.max_bytes = 20;
  EXPECT_EQ(events_of("<a>12345678901234567</a>", limits), "too_large@0");
  limits = {};
  limits.max_elements = 2;
  EXPECT_EQ(events_of("<a><b/><c/></a>", limits), "<a><b></>too_large@7");
  limits = {};
  limits.max_depth = 2;
  EXPECT_EQ(events_of("<a><b><c/></b></a>", limits), "<a><b>too_large@6");
  limits = {};
  limits.max_attributes = 1;
  EXPECT_EQ(events_of("<a x='' y=''/>", limits), "too_large@0");
}

TEST(Xml, EscapedTextReadsBack) {
  std::string const name = "a<b>&\"'\t\n\r \xc4\x8d\xe2\x82\xac\xf0\x9f\x98\x80&amp;";
  EXPECT_EQ(decode_xml(escape_xml(name)), name);
}

TEST(Xml, TextThatXmlCannotHoldIsReplaced) {
  std::string const mark = "\xef\xbf\xbd";
  EXPECT_EQ(clean_utf8("a\x01z"), "a" + mark + "z");
  EXPECT_EQ(clean_utf8("\xff"), mark);
  EXPECT_EQ(clean_utf8("\xc0\x80"), mark + mark);             // too long a form of NUL
  EXPECT_EQ(clean_utf8("\xed\xa0\x80"), mark + mark + mark);  // half of a surrogate pair
  EXPECT_EQ(clean_utf8("\xe2\x82"), mark + mark);             // cut off
  EXPECT_EQ(clean_utf8("\xef\xbf\xbf"), mark);                // not a character
  EXPECT_EQ(clean_utf8("\xc3\xa9\xf4\x8f\xbf\xbd"), "\xc3\xa9\xf4\x8f\xbf\xbd");
}

}  // namespace
}  // namespace inkflate
