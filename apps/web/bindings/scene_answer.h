// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <set>

#include "editor/scene.h"
#include "web/bindings/answer.h"

namespace inkflate::web {

/// Turns scenes into answers, without what the page has been sent before: SceneUpdate of src/protocol/scene.ts.
///
/// In the head a chunk is [id, space] when it was in the scene before, else [id, space, first byte, bytes]; space 0: canvas, 1: screen.
/// The mesh is null when it is the one that was sent last.
class SceneSender {
 public:
  Answer answer(Scene const& scene);

 private:
  std::set<std::uint64_t> chunks_;  // of the last scene
  std::uint64_t model_ = 0;         // whose mesh was sent last; 0: none
};

}  // namespace inkflate::web
