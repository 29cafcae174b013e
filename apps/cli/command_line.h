// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/exit_status.h"

namespace inkflate::cli {

/// The whole program: `words` are its arguments without the program's name.
ExitStatus run_command_line(std::vector<std::string> const& words);

}  // namespace inkflate::cli
