// SPDX-License-Identifier: Apache-2.0
// action_names: prints apps/web/src/protocol/actions.generated.ts.
#include <cstdio>

#include "support/action_table.h"

int main() { std::fputs(inkflate::support::action_names().c_str(), stdout); }
