// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "model/stroke.h"
#include "simplify/work_space.h"

namespace inkflate {

/// A point of a stroke after resampling.
struct StrokeSample {
  Vec2 position;     // work px
  Vec2 direction;    // of the stroke, length 1; zero for a dot
  double along = 0;  // where on the stroke: index of its sample + fraction
  int stroke = 0;    // index into Sketch::strokes
};

/// All strokes at one spacing.
struct StrokeSamples {
  std::vector<StrokeSample> points;   // stroke by stroke, in stroke order
  std::vector<LatticePoint> lattice;  // the same points, rounded
  double spacing_px = 0;  // consecutive points of a stroke are at most this far apart, work px
  int chord_count = 0;    // so many of the last points lie on chords, which no one has drawn

  int drawn_count() const { return static_cast<int>(points.size()) - chord_count; }
  bool is_chord(int sample) const { return sample >= drawn_count(); }
};

/// A straight line along which a shape may be closed for nothing, work px.
struct Chord {
  Vec2 from;
  Vec2 to;
};

/// Resamples strokes so that no step is longer than spacing_px. Corners between longer steps (polygons, say) stay.
///
/// in      chosen: the strokes to take, indices into sketch.strokes
/// out     at least one sample per stroke that has any. Above kMostSamples in all the spacing grows with the sketch
/// cost    O(samples in + samples out)
StrokeSamples sample_strokes(Sketch const& sketch, std::span<int const> chosen,
                             WorkSpace const& space, double spacing_px);

/// Appends samples between the ends of a chord, as of a stroke that follows all others.
///
/// in      stroke: above the index of every stroke of the sketch
void append_chord(Chord const& chord, int stroke, StrokeSamples& samples);

}  // namespace inkflate
