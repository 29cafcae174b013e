// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "editor/actions.h"
#include "editor/message.h"
#include "editor/view.h"

namespace inkflate::web {

/// What src/protocol calls the choices of the core.
std::string_view name_of(Mode mode);
std::string_view name_of(Tool tool);
std::string_view name_of(BendMode mode);
std::string_view name_of(Shading shading);
std::string_view name_of(Language language);
std::string_view name_of(Menu menu);
std::string_view name_of(ActionArgument argument);
std::string_view name_of(Severity severity);

}  // namespace inkflate::web
