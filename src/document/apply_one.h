// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/result.h"
#include "document/command.h"
#include "document/document.h"

namespace inkflate {

/// apply() for each kind of command; errors as there.
Result<Document> apply_one(Document const& document, AddStroke const& command);
Result<Document> apply_one(Document const& document, EraseArea const& command);
Result<Document> apply_one(Document const& document, EraseStrokes const& command);
Result<Document> apply_one(Document const& document, Simplify const& command);
Result<Document> apply_one(Document const& document, OpenLayer const& command);
Result<Document> apply_one(Document const& document, RedrawLayer const& command);
Result<Document> apply_one(Document const& document, CloseLayer const& command);
Result<Document> apply_one(Document const& document, DeleteLayers const& command);
Result<Document> apply_one(Document const& document, DuplicateLayer const& command);
Result<Document> apply_one(Document const& document, SetLayerOrder const& command);
Result<Document> apply_one(Document const& document, TransformLayers const& command);
Result<Document> apply_one(Document const& document, Bend const& command);
Result<Document> apply_one(Document const& document, SetBendPins const& command);
Result<Document> apply_one(Document const& document, RenameLayer const& command);
Result<Document> apply_one(Document const& document, SetThickness const& command);
Result<Document> apply_one(Document const& document, SetFill const& command);
Result<Document> apply_one(Document const& document, SetHidden const& command);
Result<Document> apply_one(Document const& document, SetLocked const& command);
Result<Document> apply_one(Document const& document, SetChoice const& command);
Result<Document> apply_one(Document const& document, SetTemplate const& command);
Result<Document> apply_one(Document const& document, SetCanvas const& command);
Result<Document> apply_one(Document const& document, AddPin const& command);
Result<Document> apply_one(Document const& document, MovePins const& command);
Result<Document> apply_one(Document const& document, DeletePins const& command);
Result<Document> apply_one(Document const& document, SetTrack const& command);
Result<Document> apply_one(Document const& document, SetClipLength const& command);
Result<Document> apply_one(Document const& document, Replace const& command);

}  // namespace inkflate
