// SPDX-License-Identifier: Apache-2.0
#include "editor/model_cache.h"

#include <utility>

#include "pipeline/run_inflate.h"
#include "render/bake_texture.h"

namespace inkflate {

bool ModelCache::is_current(Document const& document) const {
  return layers_ == document.layers && template_picture_ == document.template_picture;
}

Result<bool> ModelCache::make(Document const& document, Progress const& progress) {
  auto const drawing = shown_drawing(document);
  auto model = run_inflate(drawing, {}, progress);
  bool const is_cancelled =
      model ? !progress.enter("texture") : model.error().code == ErrorCode::Cancelled;
  if (is_cancelled) return Error{ErrorCode::Cancelled, "stopped on request"};
  if (!model) return model.error();
  auto const& picture = document.template_picture;
  layers_ = document.layers;
  template_picture_ = picture;
  ++id_;
  auto texture = picture ? wear_picture(*picture, *model) : bake_texture(drawing, *model);
  model_ = std::make_shared<RestModel const>(std::move(*model));
  texture_ = std::make_shared<Texture const>(std::move(texture));
  return true;
}

std::optional<ModelScene> ModelCache::scene(ModelView const& view, Shading shading) const {
  if (!model_) return std::nullopt;
  return ModelScene{id_, model_, texture_, view, shading};
}

}  // namespace inkflate
