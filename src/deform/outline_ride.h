// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "deform/place_grid.h"
#include "deform/ride.h"
#include "model/drawing.h"

namespace inkflate {

/// An outline that rides on a mesh. At rest its pieces are cut at the mesh's vertices, so that they can bend as finely as the mesh can; in
/// a pose only the cuts stay that the bend needs.
class OutlineRide {
 public:
  /// in      index: of the outline in the shape that the mesh was made from
  OutlineRide(Outline outline, ShapeMesh const& shape, int index, RidePlaces& places);

  /// The outline in a pose, no farther than tolerance_px from all of its cuts, then put on the grid. Pieces that have not moved are as they
  /// were.
  /// cost    O(cuts)
  Outline bent(RidePlaces const& places, std::span<VertexMotion const> motions, double tolerance_px,
               PlaceGrid const& grid) const;

 private:
  /// A stretch of one piece between two cuts: a cubic of its own.
  struct Stretch {
    Cubic rest;
    int from = 0;      // cuts
    int to = 0;        // may be one more than there are: the first
    double split = 0;  // 0 .. 1 along it; where its two halves meet
    int halves = -1;   // the first of its two halves, which stand side by side; -1: a single cut
  };

  /// A place where the outline may be cut.
  struct Cut {
    double parameter = 0;
    int place = 0;  // index into the places
  };

  struct BentStretch {
    Cubic curve;
    double error_px = 0;  // how far it may be from all of its cuts
  };

  void cut_piece(int piece, std::span<double const> cuts, RidePlaces& places);
  int add_place(double parameter, Vec2 place, RidePlaces& places) const;
  Cubic bent_stretch(Stretch const& stretch, std::span<VertexMotion const> moved) const;
  std::vector<BentStretch> bent_stretches(RidePlaces const& places,
                                          std::span<VertexMotion const> motions) const;
  void place_sources(std::span<int const> kept, std::vector<InkSource>& sources) const;

  Outline rest_;
  int line_ = -1;  // of the mesh; -1: it has none that was made from this outline
  std::vector<Cut> cuts_;
  std::vector<Stretch> stretches_;  // of each piece the whole one, then its halves, then theirs
  std::vector<int> whole_;          // per piece its whole stretch
};

}  // namespace inkflate
