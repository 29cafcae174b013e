// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "base/result.h"
#include "base/stage_time.h"
#include "mesh/check_mesh.h"
#include "model/drawing.h"

namespace inkflate {

/// The JSON object that `simplify --json` prints, on one line.
///
///     {"canvas": {"width", "height"}, "strokes", "samples",
///      "layers": [{"name", "strokes", "details", "contours": [{"hole", "closed", "area", "perimeter", "points": [[x, y], ...]}]}],
///      "closings": [{"layer", "from": [x, y], "to": [x, y], "length"}], "open": [the same], "stray",
///      "ms": {stage: ms, ..., "total"}}
///
/// Points are px, within 0.1 px of the curve and rounded to 0.001; area is positive for holes too; strokes, details and
/// stray are counts; closings and open runs name their layer by index. Keys keep this order. The stages "read" and
/// "write" are listed but not part of the total.
std::string json_report(Drawing const& drawing, std::span<StageTime const> stages);

/// What there is to say about a model that was made, beside its mesh.
struct ModelFacts {
  int layers = 0;
  std::string unit = "px";  // of the mesh
};

/// The JSON object that `inflate --json` prints, on one line:
///
///     {"vertices", "triangles", "layers", "shells", "genus", "unit", "volume", "bounding_box": {"min": [x, y, z], "max": [x, y, z]},
///      "ok", "ms": {stage: ms, ..., "total"}}
///
/// ok: closed, manifold, oriented, finite, no flipped and no zero-area triangle.
std::string json_report(TriMesh const& mesh, MeshCheck const& check, ModelFacts const& facts,
                        std::span<StageTime const> stages);

/// {"error": {"code", "message", "where"}}; where is the error's index, or null.
std::string json_error(Error const& error);

}  // namespace inkflate
