// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <vector>

#include "base/result.h"
#include "document/document.h"

namespace inkflate {

using LayerList = std::vector<Shared<DocumentLayer>>;

/// What a command may do to a layer that is locked.
enum class Reach {
  Any,       // what leaves its shape alone: its name, its place in the order
  Unlocked,  // all else
};

/// The layer's place in the order. errors: BadInput (no such layer; it is locked)
Result<std::size_t> layer_place(Document const& document, LayerId id, Reach reach);
/// The same for a layer that has to be open, too.
Result<std::size_t> open_layer_place(Document const& document, LayerId id);
/// errors: NothingThere (none), BadInput (one is named twice, is not there or is locked)
Result<std::set<LayerId>> unlocked_layers(Document const& document,
                                          std::span<LayerId const> layers);

Document with_layers(Document document, LayerList layers);
/// With another layer in this place.
Document with_layer(Document const& document, std::size_t place, DocumentLayer layer);

/// All strokes, loose ones included.
int stroke_count(Document const& document);

/// The refusal of commands that would change nothing.
Error no_change();
/// The refusal of one more layer or pin when all ids are given.
Error no_more_ids();

}  // namespace inkflate
