// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/result.h"
#include "document/document.h"
#include "pipeline/close_document.h"

namespace inkflate {

/// Documents as a hand draws and closes them. What does not succeed fails the test. Lengths in px.

/// What was refused is an empty document.
Document must(Result<Document> const& result);

/// The strokes one after the other, loose or in an open layer.
Document drawn(Document document, std::vector<Stroke> const& strokes,
               LayerId layer = LayerId::None);
Document drawn(std::vector<Stroke> const& strokes);

ClosedDocument closed(Document const& document);
/// The document after all that could be closed has been. At least one set could.
Document simplified(Document const& document);

/// From the back.
Layer const& layer_at(Document const& document, int index);

/// Of the outer outline, holes not taken away, px^2.
double area(Layer const& layer);

}  // namespace inkflate
