// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "base/progress.h"
#include "base/result.h"
#include "document/document.h"
#include "editor/scene.h"

namespace inkflate {

/// The model of a document, made when it is wanted and kept while the document's layers and template are the same.
class ModelCache {
 public:
  bool is_current(Document const& document) const;
  /// errors  those of run_inflate. Then the cache is as it was before, and not current
  Result<bool> make(Document const& document, Progress const& progress);
  /// The last one that was made, seen like this; none: there is none.
  std::optional<ModelScene> scene(ModelView const& view, Shading shading) const;

 private:
  Shared<std::vector<Shared<DocumentLayer>>> layers_;
  Shared<Picture> template_picture_;
  Shared<RestModel> model_;
  Shared<Texture> texture_;
  std::uint64_t id_ = 0;
};

}  // namespace inkflate
