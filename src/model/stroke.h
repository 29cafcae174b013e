// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "image/colour.h"

namespace inkflate {

/// One recorded position of the pen.
struct Sample {
  Vec2 position;        // canvas px
  double pressure = 1;  // 0 .. 1
  double time_s = 0;    // >= 0, since the stroke's start; all 0: not recorded

  friend bool operator==(Sample const&, Sample const&) = default;
};

enum class StrokeKind {
  Ink,       // part of the drawing
  HelpLine,  // closes a shape where its outline is open; not drawn
};

/// Where the part that a stroke draws shall lie.
enum class StrokeDepth {
  Near,  // in front of all others
  Far,   // behind all others
};

/// One line of the pen, from press to lift. A single sample is a dot.
struct Stroke {
  std::vector<Sample> samples;
  StrokeKind kind = StrokeKind::Ink;
  double width_px = 2;
  Colour colour;
  int group = -1;  // index into Sketch::groups; -1: none
  StrokeDepth depth = StrokeDepth::Near;

  friend bool operator==(Stroke const&, Stroke const&) = default;
};

/// How round inflation may make a layer.
inline constexpr double kLeastThickness = 0.1;
inline constexpr double kLargestThickness = 32;

/// Strokes that belong together: a candidate layer, with what the layer shall look like.
struct StrokeGroup {
  std::string name;
  std::optional<Colour> fill = {};
  double thickness = 2;  // 0.1 .. 32, as of a layer

  friend bool operator==(StrokeGroup const&, StrokeGroup const&) = default;
};

/// Those of construction lines and noise are named so and, like those of help lines, become no layer of their own.
/// In any case of letters: "construction", "noise", or a name that starts with "help".
bool is_candidate_layer(StrokeGroup const& group);

/// A rough drawing: strokes in drawing order on a canvas.
struct Sketch {
  double width_px = 0;
  double height_px = 0;
  std::vector<StrokeGroup> groups;
  std::vector<Stroke> strokes;

  friend bool operator==(Sketch const&, Sketch const&) = default;
};

}  // namespace inkflate
