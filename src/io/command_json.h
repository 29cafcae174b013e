// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/result.h"
#include "document/command.h"

namespace inkflate {

/// A command as one line of JSON that read_command gives back exactly: {"command": "add_stroke", ...}; docs/FORMATS.md.
///
/// in      as apply takes it: a number that is not finite cannot be read again, nor a picture without pixels. Names in UTF-8 (other
///         bytes become U+FFFD); a document of Replace is whole
std::string write_command(Command const& command);

/// Whether a command suits a document only apply can tell; its indices and ids are those of that document.
///
/// errors  BadInput (no JSON, an unknown command, a member that is missing or out of its range), TooLarge (JsonLimits; pictures),
///         Unsupported (a document of a newer version)
Result<Command> read_command(std::string_view text);

/// The same as a part of other JSON.
nlohmann::ordered_json command_json(Command const& command);
Result<Command> take_command(nlohmann::json const& json);

}  // namespace inkflate
