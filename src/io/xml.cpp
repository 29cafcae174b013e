// SPDX-License-Identifier: Apache-2.0
#include "io/xml.h"

#include <algorithm>
#include <utility>

#include "io/numbers.h"
#include "io/xml_text.h"

namespace inkflate {
namespace {

Error fault(std::size_t at, std::string const& what) {
  return {ErrorCode::BadInput,
          "not well-formed XML: " + what + " (byte " + std::to_string(at) + ")",
          static_cast<long long>(at)};
}

Error too_large(std::size_t at, std::string const& limit) {
  return {ErrorCode::TooLarge, "the XML has more than " + limit, static_cast<long long>(at)};
}

bool starts_with_at(std::string_view document, std::size_t at, std::string_view word) {
  return document.substr(at, word.size()) == word;
}

// Letters are not checked against XML's tables: names are only compared with ours.
bool is_name_char(char c) {
  return !is_blank(c) && std::string_view("<>/=\"'&?!").find(c) == std::string_view::npos &&
         c != '\0';
}

std::size_t name_end(std::string_view document, std::size_t at) {
  while (at < document.size() && is_name_char(document[at])) ++at;
  return at;
}

std::size_t skip_blanks(std::string_view document, std::size_t at) {
  while (at < document.size() && is_blank(document[at])) ++at;
  return at;
}

}  // namespace

Result<XmlTag> read_xml_tag(std::string_view document, std::size_t offset,
                            XmlLimits const& limits) {
  XmlTag tag;
  std::size_t at = name_end(document, offset + 1);
  tag.name = document.substr(offset + 1, at - offset - 1);
  if (tag.name.empty()) return fault(offset, "a '<' that starts no tag");
  while (true) {
    std::size_t const begin = skip_blanks(document, at);
    if (begin >= document.size()) return fault(offset, "the tag is cut off");
    tag.is_empty = document[begin] == '/';
    std::size_t const last = begin + (tag.is_empty ? 1 : 0);
    if (last < document.size() && document[last] == '>') {
      tag.end = last + 1;
      return tag;
    }
    std::size_t const end = name_end(document, begin);
    std::size_t const equals = skip_blanks(document, end);
    if (begin == at || end == begin || equals >= document.size() || document[equals] != '=') {
      return fault(begin, "an attribute was expected");
    }
    std::size_t const open = skip_blanks(document, equals + 1);
    if (open >= document.size() || (document[open] != '"' && document[open] != '\'')) {
      return fault(equals, "an attribute's value needs quotes");
    }
    std::size_t const close = document.find(document[open], open + 1);
    if (close == std::string_view::npos) return fault(open, "the quotes are never closed");
    auto const value = document.substr(open + 1, close - open - 1);
    if (value.find('<') != std::string_view::npos) return fault(open, "a '<' inside quotes");
    auto const bad = bad_reference(value);
    if (bad != std::string_view::npos) return fault(open + 1 + bad, "an unknown reference");
    if (std::ssize(tag.attributes) >= limits.max_attributes) {
      return too_large(offset,
                       std::to_string(limits.max_attributes) + " attributes in one element");
    }
    tag.attributes.push_back({document.substr(begin, end - begin), value});
    at = close + 1;
  }
}

Result<XmlReader> XmlReader::open(std::string_view document, XmlLimits const& limits) {
  if (std::ssize(document) > limits.max_bytes) {
    return too_large(0, std::to_string(limits.max_bytes >> 20U) + " MB");
  }
  auto const first = document.substr(0, 2);
  bool const has_zero = first.size() == 2 && (first[0] == '\0' || first[1] == '\0');
  if (first == "\xff\xfe" || first == "\xfe\xff" || has_zero) {
    return Error{ErrorCode::Unsupported, "the file is in UTF-16; save it as UTF-8", 0};
  }
  return XmlReader(document, document.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0, limits);
}

Result<XmlEvent> XmlReader::next() {
  if (is_close_pending_) {
    is_close_pending_ = false;
    open_names_.pop_back();
    return XmlEvent::Close;
  }
  // Comments, instructions and the document type pass without an event.
  while (true) {
    event_at_ = at_;
    if (at_ >= document_.size()) return read_end();
    if (document_[at_] != '<' || starts_with_at(document_, at_, "<![CDATA[")) {
      auto event = read_text();
      if (!event || !open_names_.empty()) return event;
      continue;
    }
    std::pair<std::string_view, std::string_view> passed;
    if (starts_with_at(document_, at_, "<!--")) passed = {"<!--", "-->"};
    if (starts_with_at(document_, at_, "<?")) passed = {"<?", "?>"};
    if (starts_with_at(document_, at_, "<!DOCTYPE")) passed = {"<!DOCTYPE", ">"};
    if (passed.first.empty()) break;
    auto end = document_.find(passed.second, at_ + passed.first.size());
    auto const subset = document_.substr(at_, end - at_).find('[');
    if (passed.second == ">" && subset != std::string_view::npos) {
      end = document_.find(']', at_);
      auto const declarations = document_.substr(at_, end - at_);
      auto const entity = declarations.find("<!ENTITY");
      if (entity != std::string_view::npos) {
        return Error{ErrorCode::Unsupported,
                     "the file declares entities, which are not read; save it as plain SVG",
                     static_cast<long long>(at_ + entity)};
      }
      if (end != std::string_view::npos) end = document_.find('>', end);
    }
    if (end == std::string_view::npos) return fault(at_, "this is never closed");
    at_ = end + passed.second.size();
  }
  return starts_with_at(document_, at_, "</") ? read_close() : read_open();
}

Result<XmlEvent> XmlReader::read_text() {
  std::size_t begin = at_;
  bool const is_cdata = document_[at_] == '<';
  std::size_t end = 0;
  if (is_cdata) {
    begin += 9;
    end = document_.find("]]>", begin);
    if (end == std::string_view::npos) return fault(at_, "this is never closed");
    at_ = end + 3;
  } else {
    end = std::min(document_.find('<', at_), document_.size());
    at_ = end;
  }
  text_ = document_.substr(begin, end - begin);
  auto const bad = is_cdata ? std::string_view::npos : bad_reference(text_);
  if (bad != std::string_view::npos) return fault(begin + bad, "an unknown reference");
  if (open_names_.empty() && (is_cdata || !trimmed(text_).empty())) {
    return fault(event_at_, "text outside the root element");
  }
  return XmlEvent::Text;
}

Result<XmlEvent> XmlReader::read_open() {
  if (has_root_ && open_names_.empty()) return fault(at_, "a second root element");
  auto tag = read_xml_tag(document_, at_, limits_);
  if (!tag) return tag.error();
  if (++element_count_ > limits_.max_elements) {
    return too_large(at_, std::to_string(limits_.max_elements) + " elements");
  }
  if (std::ssize(open_names_) >= limits_.max_depth) {
    return too_large(at_, std::to_string(limits_.max_depth) + " levels of elements");
  }
  tag_ = std::move(*tag);
  has_root_ = true;
  open_names_.push_back(tag_.name);
  is_close_pending_ = tag_.is_empty;
  at_ = tag_.end;
  return XmlEvent::Open;
}

Result<XmlEvent> XmlReader::read_close() {
  std::size_t const end = name_end(document_, at_ + 2);
  auto const name = document_.substr(at_ + 2, end - at_ - 2);
  std::size_t const last = skip_blanks(document_, end);
  if (last >= document_.size() || document_[last] != '>') return fault(at_, "the tag is cut off");
  if (open_names_.empty() || open_names_.back() != name) {
    return fault(at_, "the end tag does not match the start tag");
  }
  open_names_.pop_back();
  at_ = last + 1;
  return XmlEvent::Close;
}

Result<XmlEvent> XmlReader::read_end() {
  if (!open_names_.empty()) return fault(at_, "the file ends inside an element");
  if (!has_root_) return fault(at_, "no element");
  return XmlEvent::End;
}

}  // namespace inkflate
