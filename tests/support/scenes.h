// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <utility>

#include "editor/scene.h"
#include "support/editor_documents.h"

namespace inkflate {

/// A view of 400 x 400 px on the canvas from (0, 0), without the lines of the paper.
inline View plain_view() {
  View view;
  view.size = {400, 400};
  view.camera.centre = {200, 200};
  view.has_grid = false;
  return view;
}

/// Scenes of one document after the other, seen by one builder.
class SceneMaker {
 public:
  View view = plain_view();
  ToolState tool = ToolIdle{};
  ShapePreview preview;

  Scene scene(Document const& document) {
    return builder_.build({document, view, tool, preview, {}});
  }
  Picture picture(Document const& document) { return picture_of(scene(document)); }

 private:
  SceneBuilder builder_;
};

inline std::set<std::uint64_t> ids_of(Scene const& scene) {
  std::set<std::uint64_t> ids;
  for (auto const& chunk : scene.chunks) ids.insert(chunk.id);
  return ids;
}

/// How many chunks a studio has to make anew.
inline int new_chunks(Scene const& before, Scene const& after) {
  auto const known = ids_of(before);
  int count = 0;
  for (auto const id : ids_of(after)) count += known.count(id) == 0 ? 1 : 0;
  return count;
}

}  // namespace inkflate
