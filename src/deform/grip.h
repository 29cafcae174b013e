// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "deform/bend_mesh.h"
#include "mesh/triangles_at.h"

namespace inkflate {

/// How much stiffer each triangle is for being near to a handle: what is held by a needle would be drawn out to a spike, what is held by a
/// fingertip moves as a lump. Most at the handle, falling smoothly to nothing at its grip_px, measured at rest; only where the shape hangs
/// together on the way there.
class Grips {
 public:
  /// mesh: has to outlive the grips
  explicit Grips(BendMesh const& mesh);

  /// Whether anything is another factor than before.
  /// cost    O(triangles within the grips); none when the handles have the places that they had
  bool update(std::span<BendHandle const> handles);

  /// One per triangle, 1 .. kStiffest.
  std::vector<double> const& factors() const { return factors_; }

  static constexpr double kStiffest = 60;

 private:
  struct Grip {
    BendAnchor anchor;
    double radius_px = 0;

    friend bool operator==(Grip const&, Grip const&) = default;
  };

  void stiffen(Grip const& grip);

  BendMesh const* mesh_;
  TrianglesAt triangles_;
  std::vector<Grip> grips_;
  std::vector<double> factors_;
};

}  // namespace inkflate
