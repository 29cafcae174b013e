// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/sketch_limits.h"

namespace inkflate {

/// Just the XML that SVG needs, read without recursion and without copying.

struct XmlLimits {
  std::int64_t max_bytes = kMaxFileBytes;
  int max_elements = 1'000'000;
  int max_depth = 1024;
  int max_attributes = 65'535;  // of one element
};

/// One attribute as it stands in the file: references are not yet resolved.
struct XmlAttribute {
  std::string_view name;
  std::string_view value;
};

/// A start tag. The views point into the document.
struct XmlTag {
  std::string_view name;
  std::vector<XmlAttribute> attributes;
  std::size_t end = 0;  // the byte after '>'
  bool is_empty = false;
};

enum class XmlEvent {
  Open,   // a start tag
  Close,  // an end tag, or the end of an empty element
  Text,   // character data or a CDATA section
  End,    // of the document
};

/// A pull parser: call next() until it says End or fails.
///
/// in      a document in UTF-8, with or without byte order mark; must outlive the reader
/// errors  BadInput (index: the byte), TooLarge (a limit, named), Unsupported (UTF-16, declared entities)
/// cost    O(bytes)
/// source  XML 1.0, fifth edition. Not promised: duplicate attributes and characters outside XML's set pass.
class XmlReader {
 public:
  static Result<XmlReader> open(std::string_view document, XmlLimits const& limits = {});

  Result<XmlEvent> next();

  /// After Open: the tag.
  XmlTag const& tag() const { return tag_; }
  /// After Text: the data as it stands in the file.
  std::string_view text() const { return text_; }
  /// Where the last event starts in the document given to open().
  std::size_t offset() const { return event_at_; }

 private:
  XmlReader(std::string_view document, std::size_t start, XmlLimits const& limits)
      : document_(document), at_(start), limits_(limits) {}

  Result<XmlEvent> read_text();
  Result<XmlEvent> read_open();
  Result<XmlEvent> read_close();
  Result<XmlEvent> read_end();

  std::string_view document_;
  std::size_t at_ = 0;
  XmlLimits limits_;
  XmlTag tag_;
  std::string_view text_;
  std::size_t event_at_ = 0;
  std::vector<std::string_view> open_names_;
  int element_count_ = 0;
  bool has_root_ = false;
  bool is_close_pending_ = false;
};

/// Reads the start tag whose '<' is at this byte.
Result<XmlTag> read_xml_tag(std::string_view document, std::size_t offset,
                            XmlLimits const& limits = {});

}  // namespace inkflate
