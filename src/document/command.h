// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "document/document.h"
#include "geometry/affine.h"

namespace inkflate {

/// A stroke of a document: of an open layer, or a loose one.
struct StrokeRef {
  LayerId layer = LayerId::None;  // None: loose
  int index = 0;

  friend bool operator==(StrokeRef const&, StrokeRef const&) = default;
};

/// Every way to change a document. Commands are data: they can be written, read and applied again with the same result.

struct AddStroke {
  Stroke stroke;  // at least one sample; finite, within 1e6 px
  LayerId layer =
      LayerId::None;  // an open layer, at the end of its strokes; None: to the loose ones
};

/// Rubs out what lies within radius_px of the path, in the loose strokes and in those of layers that take strokes: strokes are cut there.
/// Pieces keep pressure and time; they start and end where the circle's edge was.
struct EraseArea {
  Polyline path;         // at least one point
  double radius_px = 0;  // > 0
};

struct EraseStrokes {
  std::vector<StrokeRef> strokes;  // at least one, each once
};

/// Rough strokes become layers. The shapes come with the command, so that it means the same whatever simplify becomes later.
struct Simplify {
  struct Set {
    LayerId layer = LayerId::None;  // all strokes of this open layer; None: some of the loose ones
    std::vector<int> strokes;       // which of the loose ones: ascending; empty for a layer
    StrokeDepth depth = StrokeDepth::Near;  // of new layers: before or behind all others
    std::vector<Layer>
        shapes;  // at least one. Their strokes, details, noise and sources are indices into the list that the strokes
                 // are in now. Strokes of the set that no shape names become noise of the first
  };
  /// Loose strokes that enclose nothing, drawn on a closed layer: whiskers on a face.
  struct Details {
    LayerId layer = LayerId::None;  // closed and unlocked; they go to the end of its strokes
    std::vector<int> strokes;       // which of the loose ones: at least one, ascending
  };
  std::vector<Set> sets;  // each layer once, each loose stroke at most once
  std::vector<Details> details =
      {};  // of the loose strokes that no set has; with the sets at least one in all
};
// The first shape of an open layer keeps its id, name, fill, thickness, visibility and place; further ones lie just before it. All choices
// are those with which the strokes were closed; the document's own loses its marks when no loose stroke remains.

/// Its strokes can be added to and erased until they are simplified again.
struct OpenLayer {
  LayerId layer = LayerId::None;
};

/// Opens it and takes all its strokes away; its outlines stay to be seen until the new strokes are simplified.
struct RedrawLayer {
  LayerId layer = LayerId::None;
};

/// An open layer goes back to the outlines that it has; not for one without outlines.
struct CloseLayer {
  LayerId layer = LayerId::None;
};

/// With its pins and their tracks.
struct DeleteLayers {
  std::vector<LayerId> layers;
};

enum class OrderEnd { Back, Front };

/// A copy named "NAME copy", moved by offset, behind or before all others. Its id is Document::next_id.
struct DuplicateLayer {
  LayerId layer = LayerId::None;
  OrderEnd end = OrderEnd::Back;
  Vec2 offset;
};

struct SetLayerOrder {
  std::vector<LayerId> back_to_front;  // every layer once
};

/// Strokes, outlines, marks and pins of the layers are moved; widths grow with the map's mean scale. Tracks stay.
struct TransformLayers {
  std::vector<LayerId> layers;  // empty: all loose strokes and their marks
  Affine map;                   // finite, determinant not 0
};

/// Layers and rough strokes take another shape; what they are stays. The shapes come with the command, as those of Simplify do. Outlines that
/// an open layer still has forget the rough strokes that were bent, as if those had been drawn anew.
struct Bend {
  struct Part {
    LayerId layer = LayerId::None;  // not locked
    /// As many as it has; kinds and sources follow each other as before.
    std::vector<Outline> outlines;
    std::vector<Vec2> samples;  // of all its strokes, one after the other, as many as they have
    std::vector<Vec2> marks;    // of its choice: those outside, then those inside
  };
  struct Line {
    StrokeRef stroke;           // a rough one
    std::vector<Vec2> samples;  // as many as it has
  };
  std::vector<Part> parts;       // each layer once
  std::vector<Line> lines = {};  // each stroke once; with the parts at least one in all
};

/// The places by which a layer is held while it is bent, instead of those before. TransformLayers moves them; Simplify forgets them.
struct SetBendPins {
  LayerId layer = LayerId::None;  // not locked
  /// At most DocumentLimits::kBendPins; finite, within 1e6 px and 1000 rad.
  std::vector<BendPin> pins;
};

struct RenameLayer {
  LayerId layer = LayerId::None;
  std::string name;  // at most 200 bytes, UTF-8
};

struct SetThickness {
  LayerId layer = LayerId::None;
  double thickness = 2;  // kLeastThickness .. kLargestThickness
};

struct SetFill {
  LayerId layer = LayerId::None;
  std::optional<Colour> fill;
};

struct SetHidden {
  LayerId layer = LayerId::None;
  bool is_hidden = false;
};

struct SetLocked {
  LayerId layer = LayerId::None;
  bool is_locked = false;
};

struct SetChoice {
  LayerId layer = LayerId::None;  // None: of the loose strokes
  CloseChoice choice;
};

struct SetTemplate {
  Shared<Picture> picture;  // null: none
};

struct SetCanvas {
  double width_px = 0;  // 1 .. 16384
  double height_px = 0;
};

/// Its id becomes Document::next_id.
struct AddPin {
  Pin pin;
};

struct MovePins {
  std::vector<PinId> pins;
  std::vector<Vec2> positions;  // one for each
};

/// With their tracks.
struct DeletePins {
  std::vector<PinId> pins;
};

/// Replaces the track of its pin; one without keys removes it.
struct SetTrack {
  Track track;
};

struct SetClipLength {
  double length_s = 0;  // no key lies beyond it
};

/// Another document takes the place of this one: one was opened, or a new one begun.
struct Replace {
  Document document;
};

using Command =
    std::variant<AddStroke, EraseArea, EraseStrokes, Simplify, OpenLayer, RedrawLayer, CloseLayer,
                 DeleteLayers, DuplicateLayer, SetLayerOrder, TransformLayers, Bend, SetBendPins,
                 RenameLayer, SetThickness, SetFill, SetHidden, SetLocked, SetChoice, SetTemplate,
                 SetCanvas, AddPin, MovePins, DeletePins, SetTrack, SetClipLength, Replace>;

}  // namespace inkflate
