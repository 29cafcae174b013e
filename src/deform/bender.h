// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "deform/bend_mesh.h"
#include "deform/bend_options.h"
#include "deform/place_grid.h"
#include "geometry/polyline.h"
#include "model/drawing.h"

namespace inkflate {

/// All that is bent together.
struct BendShape {
  /// The outer one, then its holes. None: the lines are bent themselves, each as a strip.
  std::vector<Outline> outlines;
  /// Strokes and marks: they ride along. One of a single point is a place.
  std::vector<Polyline> lines;
};

/// A shape at rest and all that is needed to bend it again and again.
///
/// Nothing is sampled anew: every outline keeps its pieces, kinds and sources, cut exactly where a bend needs more of them, every line
/// its points.
class Bender {
 public:
  /// in      rest: finite, within 1e6 px
  /// errors  NothingThere (nothing to bend); BadOption
  /// cost    about 5 ms for a contour of 400 points in mode Body
  static Result<Bender> make(BendShape rest, BendOptions const& options = {});
  ~Bender();
  Bender(Bender&&) noexcept;
  Bender& operator=(Bender&&) noexcept;

  BendMesh const& mesh() const;
  BendPose const& rest_pose() const;

  /// The place of the drawn lines that is nearest to a place of the canvas while the shape lies in this pose.
  BendAnchor nearest(BendPose const& pose, Vec2 canvas) const;

  /// The place of the shape that lies at a place of the canvas; of several the first of the mesh. None: nothing of the mesh does.
  std::optional<BendAnchor> under(BendPose const& pose, Vec2 canvas) const;

  /// How far a hand at a place moves the shape: all that is farther than this, measured inside the rest shape, stays, but for small
  /// ends that hang on what is nearer (deform/hangers_on.h); towards there the shape is stiffer or held, so that it bends without a kink.
  /// cost    O(n log n)
  BendArea within_reach(BendAnchor const& from, double reach_px,
                        ReachEnd end = ReachEnd::Stiff) const;

  /// Goes on from a pose by at most `steps` steps of the mode's solver: BodySolver::step, WireSolver::step.
  BendProgress step(BendPose& pose, BendHold const& hold, int steps);

  /// The shape in a pose. In the rest pose, and wherever nothing has moved, it is the rest shape to the last bit.
  /// cost    about 0.3 ms for a contour of 400 points
  BendShape bent(BendPose const& pose) const;

  /// The same as it is kept: what has moved lies on the decimals of PlaceGrid::of_shape. No place is farther than 0.001 px from where it
  /// is in `bent`.
  BendShape bent_on_grid(BendPose const& pose) const;

 private:
  struct Inside;
  explicit Bender(std::unique_ptr<Inside> inside);
  BendShape bent(BendPose const& pose, PlaceGrid const& grid) const;
  std::unique_ptr<Inside> inside_;
};

}  // namespace inkflate
