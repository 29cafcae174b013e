// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "io/svg_style.h"
#include "io/xml.h"

namespace inkflate {

/// One element: its attributes with references resolved. Views point into the document or into the element itself.
class SvgElement {
 public:
  /// name: without the document's prefix; empty for elements of other namespaces.
  SvgElement(std::string_view name, XmlTag tag);
  SvgElement(SvgElement const&) = delete;  // a copy's views would point into the original
  SvgElement& operator=(SvgElement const&) = delete;
  ~SvgElement() = default;

  std::string_view name() const { return name_; }
  /// The name as it stands in the file.
  std::string_view full_name() const { return tag_.name; }
  /// The value, or nothing.
  std::optional<std::string_view> find(std::string_view attribute) const;
  /// The value, or empty.
  std::string_view operator[](std::string_view attribute) const {
    return find(attribute).value_or(std::string_view{});
  }
  std::vector<XmlAttribute> const& attributes() const { return tag_.attributes; }
  std::size_t byte_count() const { return byte_count_; }

 private:
  std::string_view name_;
  XmlTag tag_;
  std::deque<std::string> decoded_;
  std::size_t byte_count_ = 0;
};

/// Where an element is in the file; its attributes are read again when they are wanted, so that a file of 64 MB does not
/// become a tree of many times its size.
struct SvgNode {
  std::size_t offset = 0;  // byte of its '<'
  int end = 0;             // the index after its subtree; children follow their parent
};

/// An SVG document as a flat list of elements in document order; nodes[0] is the root.
struct SvgTree {
  std::string_view document;  // must outlive the tree
  std::vector<SvgNode> nodes;
  std::string_view prefix;                            // of SVG's elements, with its colon
  std::vector<std::pair<std::string_view, int>> ids;  // sorted; the first of equal ones counts
  StyleSheet style_sheet;

  SvgElement element(int node) const;
  std::optional<int> find_id(std::string_view id) const;
};

/// errors  as XmlReader; BadInput where the root is not svg
/// cost    O(bytes)
Result<SvgTree> read_svg_tree(std::string_view document);

}  // namespace inkflate
