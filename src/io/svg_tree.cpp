// SPDX-License-Identifier: Apache-2.0
#include "io/svg_tree.h"

#include <algorithm>

#include "io/xml_text.h"

namespace inkflate {
namespace {

// "svg:path" is "path" in a document whose root is "svg:svg".
std::string_view local_name(std::string_view name, std::string_view prefix) {
  bool const is_ours = name.substr(0, prefix.size()) == prefix;
  auto const local = is_ours ? name.substr(prefix.size()) : std::string_view{};
  return local.find(':') == std::string_view::npos ? local : std::string_view{};
}

class TreeBuilder {
 public:
  explicit TreeBuilder(std::string_view document) { tree_.document = document; }

  std::optional<Error> open(XmlTag const& tag, std::size_t offset) {
    if (tree_.nodes.empty()) {
      tree_.prefix = tag.name.substr(0, tag.name.find(':') + 1);
      if (local_name(tag.name, tree_.prefix) != "svg") {
        return Error{ErrorCode::BadInput, "not an SVG file: its root element is not svg",
                     static_cast<long long>(offset)};
      }
    }
    int const node = static_cast<int>(std::ssize(tree_.nodes));
    for (auto const& attribute : tag.attributes) {
      if (attribute.name == "id") tree_.ids.emplace_back(attribute.value, node);
    }
    is_in_style_ = local_name(tag.name, tree_.prefix) == "style";
    tree_.nodes.push_back({offset, 0});
    open_nodes_.push_back(node);
    return std::nullopt;
  }

  void close() {
    tree_.nodes[static_cast<std::size_t>(open_nodes_.back())].end =
        static_cast<int>(std::ssize(tree_.nodes));
    open_nodes_.pop_back();
    is_in_style_ = false;
  }

  void text(std::string_view text) {
    if (is_in_style_) css_ += text;
  }

  SvgTree take() {
    std::stable_sort(tree_.ids.begin(), tree_.ids.end(),
                     [](auto const& a, auto const& b) { return a.first < b.first; });
    tree_.style_sheet = StyleSheet(css_);
    return std::move(tree_);
  }

 private:
  SvgTree tree_;
  std::vector<int> open_nodes_;
  std::string css_;
  bool is_in_style_ = false;
};

}  // namespace

SvgElement::SvgElement(std::string_view name, XmlTag tag) : name_(name), tag_(std::move(tag)) {
  for (auto& attribute : tag_.attributes) {
    byte_count_ += attribute.name.size() + attribute.value.size();
    if (attribute.value.find('&') == std::string_view::npos) continue;
    decoded_.push_back(decode_xml(attribute.value));
    attribute.value = decoded_.back();
  }
}

std::optional<std::string_view> SvgElement::find(std::string_view attribute) const {
  for (auto const& [name, value] : tag_.attributes) {
    if (name == attribute) return value;
  }
  return std::nullopt;
}

SvgElement SvgTree::element(int node) const {
  auto tag = read_xml_tag(document, nodes[static_cast<std::size_t>(node)].offset);
  CHECK(tag.has_value(), "a tag that was read once reads again");
  auto const name = local_name(tag->name, prefix);
  return {name, std::move(*tag)};
}

std::optional<int> SvgTree::find_id(std::string_view id) const {
  auto const before = [](auto const& entry, std::string_view wanted) {
    return entry.first < wanted;
  };
  auto const found = std::lower_bound(ids.begin(), ids.end(), id, before);
  if (found == ids.end() || found->first != id) return std::nullopt;
  return found->second;
}

Result<SvgTree> read_svg_tree(std::string_view document) {
  auto reader = XmlReader::open(document);
  if (!reader) return reader.error();
  TreeBuilder builder(document);
  while (true) {
    auto const event = reader->next();
    if (!event) return event.error();
    if (*event == XmlEvent::End) return builder.take();
    if (*event == XmlEvent::Close) builder.close();
    if (*event == XmlEvent::Text) builder.text(reader->text());
    if (*event == XmlEvent::Open) {
      auto const error = builder.open(reader->tag(), reader->offset());
      if (error) return *error;
    }
  }
}

}  // namespace inkflate
