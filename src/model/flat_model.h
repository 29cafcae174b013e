// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// The two sheets of a layer, seen from the viewer.
enum class Side { Front, Back };

enum class VertexKind {
  Inside,
  Drawn,  // on a drawn rim: both sheets share it
  Open,   // within an open run, its two ends excepted: those are drawn
};

/// One layer as it is meshed: both sheets have the same triangles on the canvas.
struct FlatLayer {
  std::string name;
  double thickness = 2;           // > 0: c of the inflation
  FlatMesh mesh;                  // canvas px, y down
  std::vector<VertexKind> kinds;  // one per point
  std::array<std::vector<Triangle>, 2>
      sheets;  // per Side: mesh.triangles in the same order and with the corners in the same order, named by
               // the model's vertices
};

/// A place where two layers are joined: the mouth of the limb's tube meets a slit in a sheet of its host, or the mouth of its tube.
struct Joint {
  int limb = 0;
  int host = 0;
  enum class Kind {
    Slit,  // in the host's sheet on this side; the limb's front and back become the slit's two lips
    Mouth,  // open run against open run: front joins front, back joins back
  };
  Kind kind = Kind::Slit;
  Side side = Side::Front;  // of the host, for a slit
  std::vector<int>
      limb_vertices;  // along the limb's open run with both ends; points of the limb's mesh
  std::vector<int> host_vertices;  // the points at the same places in the host's mesh
};

/// Where a triangle of the model comes from.
struct Face {
  int layer = 0;
  Side side = Side::Front;

  friend bool operator==(Face const&, Face const&) = default;
};

/// A triangle that closes an open run which joins nothing.
struct CapTriangle {
  Triangle corners;  // vertices of the model, in the order of its final orientation
  Face face;
};

/// Layers meshed, sheet by sheet, and stitched: the model before it has any depth.
struct FlatModel {
  double width_px = 0;
  double height_px = 0;
  std::vector<FlatLayer> layers;  // back to front
  std::vector<Joint> joints;
  std::vector<CapTriangle> caps;
  int vertex_count = 0;  // of the model
};

}  // namespace inkflate
