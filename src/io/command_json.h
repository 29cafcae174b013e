// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "document/command.h"

namespace inkflate {

/// A command as one line of JSON that read_command gives back exactly: {"command": "add_stroke", ...}; docs/FORMATS.md.
std::string write_command(Command const& command);

/// errors  BadInput (no JSON, an unknown command, a member that is missing or out of its range), TooLarge (JsonLimits)
Result<Command> read_command(std::string_view text);

}  // namespace inkflate
