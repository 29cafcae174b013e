// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "editor/engine.h"
#include "web/bindings/answer.h"

namespace inkflate::web {

/// What has changed, and after it something else, as one.
void gather(Changes& changes, Changes next);

/// How much of a journal that was read counts.
enum class Recovery { Whole, InPart };

/// What came of recovering from a journal of so many bytes. In part: the journal has to begin anew before anything is appended to it.
Recovery recovery_of(Changes const& recovered, std::size_t journal_bytes);

/// EngineChanges of src/worker/engine-changes.ts. recovery: the last one among the changes.
Answer changes_answer(Changes const& changes, Recovery recovery, Language language);

}  // namespace inkflate::web
