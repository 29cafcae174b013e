// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/engine.h"
#include "web/bindings/answer.h"

namespace inkflate::web {

/// EngineState of src/protocol/state.ts.
Answer state_answer(EngineState const& state, Document const& document);

/// The rows of the action table: ActionRow[] of src/protocol/state.ts.
Answer actions_answer();

}  // namespace inkflate::web
