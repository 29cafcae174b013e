// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "io/format.h"
#include "mesh/tri_mesh.h"

namespace inkflate {

/// What a model's file may hold; also those of docs/LIMITS.md for every file.
struct MeshLimits {
  static constexpr long long kPoints = 6'000'000;
  static constexpr long long kTriangles = 2'000'000;
};

/// The triangles of a model's file, as they stand there, to be looked at: nothing is repaired.
struct MeshReading {
  FileFormat format = FileFormat::Unknown;
  TriMesh
      mesh;  // all parts together, in the file's units and axes; every index names a point, coordinates may be NaN
  std::vector<std::string>
      names;                 // of layers where the file tells them, else of objects; may be empty
  bool has_texture = false;  // a picture, or places on one
};

/// Reads GLB, OBJ, STL (binary or text) or 3MF, whichever the content is.
///
/// in      file: the whole file
/// out     points of a file that shares none between triangles (STL) stand once for each corner: see weld_vertices
/// errors  BadInput (damaged, or an index that names nothing; index: the byte, line or number, as the message says),
///         Unsupported (no mesh, or a kind that we do not read), TooLarge (MeshLimits), NothingThere (no triangle)
/// cost    O(bytes)
/// source  glTF 2.0 (Khronos, 2021); Wavefront OBJ, appendix B1; 3MF core specification 1.3
Result<MeshReading> read_mesh(std::span<std::byte const> file);

}  // namespace inkflate
