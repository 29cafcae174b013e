// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "document/command.h"
#include "document/document.h"
#include "geometry/polyline.h"

namespace inkflate {

/// What could not be closed, and why.
struct ClosingFault {
  LayerId layer = LayerId::None;  // None: loose strokes
  StrokeDepth depth = StrokeDepth::Near;
  Error error;
  Vec2 place;  // where to look, canvas px: the widest opening, or the middle of the strokes
};

/// What Simplify would do to a document.
struct ClosedDocument {
  std::optional<Simplify> command;   // none: nothing could be closed
  std::vector<ClosingFault> faults;  // sets of strokes that stay as they are
  int closings = 0;                  // gaps that were closed
  int details = 0;                   // loose strokes that go to the closed layers that they lie on
};

/// Runs simplify on what is rough: each layer that takes strokes by itself, then loose strokes drawn near and loose strokes drawn
/// far, each as one sketch (by its groups, where it has any), with the choices of the document. Limbs that are open towards other parts
/// that are seen are closed there. Loose strokes that draw no shape become details of the closed layers that they lie on; only
/// what lies on none is noise, or a fault.
///
/// errors  NothingThere (nothing is rough), Cancelled
/// cost    that of simplify
Result<ClosedDocument> close_document(Document const& document, Progress const& progress = {});

/// A layer closed again, with another choice. The command is for the open layer: one that is closed has to be opened before it (OpenLayer).
///
/// errors  NothingThere (no such layer, or it has no strokes), those of simplify
Result<Simplify> close_layer_again(Document const& document, LayerId layer,
                                   CloseChoice const& choice, Progress const& progress = {});

/// The shape that simplify would make, while one draws.
struct ShapePreview {
  std::vector<Contour> contours;  // canvas px
  std::vector<int>
      areas;  // per contour: its area, 0, 0, 1, ...; areas may overlap, each is non-zero by itself
  std::vector<Polyline> closings;  // the bridges over gaps

  friend bool operator==(ShapePreview const&, ShapePreview const&) = default;
};

/// A quick look at what close_document would make: the same closings, outlines not yet smoothed to the end, limbs not yet closed
/// where they enter other parts. Where there are more than 10,000 samples it looks at fewer of them.
///
/// out     nothing to close, or cancelled: an empty preview
/// cost    at most about 10 ms for 1000 strokes; a ShapePreviewer knows what it has seen
ShapePreview preview_shape(Document const& document, Progress const& progress = {});

}  // namespace inkflate
