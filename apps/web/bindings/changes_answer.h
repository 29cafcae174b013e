// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/engine.h"
#include "web/bindings/answer.h"

namespace inkflate::web {

/// What has changed, and after it something else, as one.
void gather(Changes& changes, Changes next);

/// EngineChanges of src/worker/engine-changes.ts.
Answer changes_answer(Changes const& changes, Language language);

}  // namespace inkflate::web
