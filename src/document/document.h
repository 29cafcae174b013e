// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "document/shared_list.h"
#include "geometry/rect.h"
#include "image/grid2.h"
#include "model/clip.h"
#include "model/drawing.h"
#include "model/project.h"

namespace inkflate {

template <typename T>
using Shared = std::shared_ptr<T const>;

/// A stroke as a document keeps it.
struct KeptStroke {
  Stroke stroke;
  Rect box;  // of the samples' positions
};

using StrokeList = SharedList<Shared<KeptStroke>>;

Shared<KeptStroke> keep(Stroke stroke);

/// A layer with the strokes that it was made of.
struct DocumentLayer {
  Layer
      layer;  // strokes, details, noise and the sources of outlines are indices into the list below
  StrokeList strokes;  // in drawing order
};

/// What a person has made, as a value: it never changes, and a changed copy shares with it all that stayed the same.
/// A layer whose is_open holds is being drawn again; strokes that are in no layer are loose.
struct Document {
  double width_px = 1000;
  double height_px = 1000;
  Shared<std::vector<StrokeGroup>> groups;            // never null, as all below
  StrokeList loose;                                   // in drawing order
  Shared<CloseChoice> choice;                         // for the loose strokes
  Shared<std::vector<Shared<DocumentLayer>>> layers;  // back to front
  Shared<Picture> template_picture;                   // null: none
  Shared<std::vector<Pin>> pins;
  Shared<Clip> clip;
  int next_id = 1;  // larger than every id given so far, also to layers and pins that are gone
};

/// A sheet of paper with nothing on it.
Document empty_document();

/// out     every layer has an id of its own. Strokes that more than one layer claims go to the first; sources of strokes of
///         other layers lose their stroke (-1)
/// errors  BadInput (index: the layer): an index out of range, two layers or pins with one id, an id not below next_id, a pin or a
///         track of nothing; TooLarge
Result<Document> make_document(Project const& project);

/// The document as a project that make_document turns into the same document again. Strokes are in this order: those of the
/// layers, back to front, then the loose ones.
Project to_project(Document const& document);

/// What is seen and inflated: the layers that are not hidden and have outlines; no loose strokes.
Drawing shown_drawing(Document const& document);

/// Nothing in it was made by hand.
bool is_blank(Document const& document);

/// Whether strokes are drawn and rubbed out in a layer by hand, and closed anew: it is open, seen and not locked.
bool takes_strokes(Layer const& layer);

/// Null or none when there is no such layer.
DocumentLayer const* find_layer(Document const& document, LayerId id);
/// Its place in the order from back to front.
std::optional<int> layer_index(Document const& document, LayerId id);

}  // namespace inkflate
