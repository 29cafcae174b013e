// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace inkflate {

/// Where the first reference starts that is neither predefined (&amp; &lt; &gt; &quot; &apos;) nor numeric; npos: all
/// references can be resolved.
std::size_t bad_reference(std::string_view raw);

/// The text with its references resolved and blanks normalised, as an attribute's value is defined.
std::string decode_xml(std::string_view raw);

/// The text as valid UTF-8 that XML can hold: any other byte or character becomes U+FFFD.
std::string clean_utf8(std::string_view text);

/// The text for use in an attribute's value: cleaned, special characters as references.
std::string escape_xml(std::string_view text);

}  // namespace inkflate
