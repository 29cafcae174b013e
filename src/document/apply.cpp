// SPDX-License-Identifier: Apache-2.0
#include "document/apply.h"

#include <utility>
#include <variant>

#include "document/apply_one.h"

namespace inkflate {

Result<Document> apply(Document const& document, Command const& command) {
  return std::visit([&](auto const& one) { return apply_one(document, one); }, command);
}

Result<Document> apply(Document const& document, std::span<Command const> commands) {
  if (commands.empty()) return Error{ErrorCode::NothingThere, "nothing to do"};
  auto result = inkflate::apply(document, commands.front());
  for (auto const& command : commands.subspan(1)) {
    if (!result) return result;
    result = inkflate::apply(*result, command);
  }
  return result;
}

}  // namespace inkflate
