// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace inkflate::support {

/// docs/ACTIONS.md, as the table of actions makes it.
std::string action_table();

/// apps/web/src/protocol/actions.generated.ts.
std::string action_names();

}  // namespace inkflate::support
