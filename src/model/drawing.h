// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/cubic.h"
#include "geometry/polyline.h"
#include "image/colour.h"
#include "model/stroke.h"

namespace inkflate {

/// What a piece of an outline is.
enum class RunKind {
  Ink,       // drawn: a stroke runs here
  HelpLine,  // along a help line: an open boundary
  Closing,   // bridges a gap; a later step decides whether it joins another part
};

/// One cubic of an outline. A piece never spans two kinds.
struct OutlinePiece {
  Cubic curve;
  RunKind kind = RunKind::Ink;

  friend bool operator==(OutlinePiece const&, OutlinePiece const&) = default;
};

/// A stretch of an outline that was drawn by one stroke.
struct InkSource {
  double from = 0;         // outline parameter: index of the piece + t along it
  double to = 0;           // > from
  int stroke = -1;         // index into Sketch::strokes
  double sample_from = 0;  // position on the stroke: index of the sample + fraction
  double sample_to = 0;    // less than sample_from where the stroke runs the other way

  friend bool operator==(InkSource const&, InkSource const&) = default;
};

/// A closed curve: each piece starts exactly where the one before ends. Outer ones have positive area, holes negative (geometry/polyline.h).
/// It crosses itself only where a part was bent over itself; its area is where it winds around at all (non-zero).
struct Outline {
  std::vector<OutlinePiece> pieces;
  std::vector<InkSource> sources;  // in outline order; stretches without ink have none

  friend bool operator==(Outline const&, Outline const&) = default;
};

/// How a person wants gaps to be closed.
struct CloseChoice {
  std::optional<double> gap_px = {};  // > 0: no closing is longer; none: as simplify finds best
  std::vector<Vec2> outside = {};     // these places are background
  std::vector<Vec2> inside = {};      // these places belong to the shape

  friend bool operator==(CloseChoice const&, CloseChoice const&) = default;
};

/// Names a layer for as long as its document lives, wherever it stands in the order.
enum class LayerId : int { None = 0 };

/// A place by which a layer is held while it is bent.
struct BendPin {
  Vec2 position;                        // canvas px
  std::optional<double> turn_rad = {};  // of the line around it; none: it turns as it likes

  friend bool operator==(BendPin const&, BendPin const&) = default;
};

/// One part of a character.
struct Layer {
  std::string name;
  std::vector<Outline> outlines;  // the outer one, then its holes
  std::vector<int> strokes;       // those that draw the outlines; indices into Sketch::strokes
  std::vector<int>
      details;  // those that lie on the layer without being outline: eyes, whiskers, hatching
  double thickness =
      2;  // 0.1 .. 32: c of the inflation; 2 makes limbs round, 4 makes a disc a ball
  std::optional<Colour> fill = {};  // of the layer's area; none: the default of whoever draws it
  std::vector<int> noise = {};  // strokes drawn with the layer that are neither outline nor detail
  CloseChoice choice = {};      // with which its gaps were closed
  LayerId id = LayerId::None;   // each its own in a document; None: made outside of one
  bool is_hidden = false;       // not shown, not inflated
  bool is_locked = false;       // not to be touched by hand
  bool is_open = false;  // being drawn again: its outlines are those of before, if there are any
  std::vector<BendPin> bend_pins = {};

  friend bool operator==(Layer const&, Layer const&) = default;
};

/// A sketch together with what simplify made of it. Every stroke is in the strokes, details or noise of exactly one
/// layer, or stray.
struct Drawing {
  Sketch sketch;
  std::vector<Layer> layers;  // back to front
  std::vector<int> stray;     // strokes that belong to no layer: noise, or not closed yet
  CloseChoice choice = {};    // with which the stray ones shall be closed

  friend bool operator==(Drawing const&, Drawing const&) = default;
};

/// Whether a layer is seen and inflated: it is not hidden and has an outline.
bool is_shown(Layer const& layer);

/// The drawing with these layers alone. All strokes stay, so that indices mean the same.
Drawing shown(Drawing drawing);

/// The strokes of the drawing, but for those of hidden layers.
Sketch shown_sketch(Drawing const& drawing);

/// Puts a copy of a layer behind all others, named "NAME copy": the far leg of a pair. Its strokes are copied too, into a group
/// of their own. The copy has no id.
void duplicate_behind(Drawing& drawing, int layer);

/// A maximal stretch of one kind, as points. A run that is a whole outline starts and ends at the same point.
struct Run {
  RunKind kind = RunKind::Ink;
  Polyline points;
};

/// The outline as a closed polygon whose chords stay within tolerance of the curve.
Contour flatten(Outline const& outline, double tolerance_px);

/// The outline cut where its kind changes, in outline order.
std::vector<Run> runs(Outline const& outline, double tolerance_px);

}  // namespace inkflate
