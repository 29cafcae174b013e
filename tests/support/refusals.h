// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "document/apply.h"

namespace inkflate::test {

/// Why the document refuses the command; none: it does not, or it does not say why in words.
inline std::optional<ErrorCode> refusal(Document const& document, Command const& command) {
  auto const result = inkflate::apply(document, command);
  if (result || result.error().message.empty()) return {};
  return result.error().code;
}

}  // namespace inkflate::test
