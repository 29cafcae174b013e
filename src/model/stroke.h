// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "image/colour.h"

namespace inkflate {

/// One recorded position of the pen.
struct Sample {
  Vec2 position;        // canvas px
  double pressure = 1;  // 0 .. 1

  friend bool operator==(Sample const&, Sample const&) = default;
};

enum class StrokeKind {
  Ink,       // part of the drawing
  HelpLine,  // closes a shape where its outline is open; not drawn
};

/// One line of the pen, from press to lift. A single sample is a dot.
struct Stroke {
  std::vector<Sample> samples;
  StrokeKind kind = StrokeKind::Ink;
  double width_px = 2;
  Colour colour;
  int group = -1;  // index into Sketch::groups; -1: none

  friend bool operator==(Stroke const&, Stroke const&) = default;
};

/// A rough drawing: strokes in drawing order on a canvas.
struct Sketch {
  double width_px = 0;
  double height_px = 0;
  std::vector<std::string> groups;  // names of candidate layers
  std::vector<Stroke> strokes;

  friend bool operator==(Sketch const&, Sketch const&) = default;
};

}  // namespace inkflate
