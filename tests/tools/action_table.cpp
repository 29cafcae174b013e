// SPDX-License-Identifier: Apache-2.0
// action_table: prints docs/ACTIONS.md.
#include "support/action_table.h"

#include <cstdio>

int main() { std::fputs(inkflate::support::action_table().c_str(), stdout); }
