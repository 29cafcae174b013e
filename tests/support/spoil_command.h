// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/rng.h"
#include "document/command.h"

namespace inkflate::test {

/// Makes some values of a command wrong: ids and indices of nothing, empty lists, numbers that are none or huge.
void spoil_command(Rng& rng, Command& command);

}  // namespace inkflate::test
