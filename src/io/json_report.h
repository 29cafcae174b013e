// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/stage_time.h"
#include "geometry/vec2.h"
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
/// Points are px, within 0.1 px of the curve and rounded to 0.001; area is positive for holes too, and of an outline that crosses itself what its windings add up to; strokes, details and
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

/// A pin by which a part was bent.
struct BendPinFacts {
  std::string part;  // its name
  Vec2 from;         // the place that was held, canvas px
  Vec2 to;           // where it should go
  Vec2 ended;        // where it went
};

/// What became of a drawing that was bent.
struct BendFacts {
  std::vector<std::string> parts;  // names of those that moved
  std::vector<BendPinFacts> pins;
  int steps = 0;
  bool is_settled = false;
};

/// The JSON object that `deform --json` prints, on one line:
///
///     {"parts": [name, ...], "pins": [{"part", "from": [x, y], "to": [x, y], "ended": [x, y], "off"}], "steps", "settled",
///      "ms": {stage: ms, ..., "total"}}
///
/// off: px from "ended" to "to"; steps: of the solver, of all parts together; settled: nothing would move any more.
std::string json_report(BendFacts const& facts, std::span<StageTime const> stages);

/// {"error": {"code", "message", "where"}}; where is the error's index, or null.
std::string json_error(Error const& error);

}  // namespace inkflate
