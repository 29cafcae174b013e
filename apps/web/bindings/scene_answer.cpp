// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/scene_answer.h"

#include <utility>

#include "render/model_placement.h"
#include "web/bindings/names.h"
#include "web/bindings/write_draw_list.h"
#include "web/bindings/write_model.h"

namespace inkflate::web {
namespace {

Json shadow_json(Rect const& box, ViewSize const& size) {
  if (box.is_empty()) return {{"x", 0}, {"y", 0}, {"rx", 0}, {"ry", 0}};
  auto const [centre, half_axes_px] = shadow_ellipse(box, size.width_px, size.height_px);
  return {{"x", centre.x}, {"y", centre.y}, {"rx", half_axes_px.x}, {"ry", half_axes_px.y}};
}

Json placed_model_json(ModelScene const& model, Scene const& scene) {
  double const width_px = scene.size.width_px;
  double const height_px = scene.size.height_px;
  // Zooming goes on over the bars.
  auto const placement = model_placement(*model.model, model.view, width_px,
                                         free_height_px(scene.size), ModelFit::FromFront);
  return {{"id", model.id},
          {"toView", to_view(placement, width_px, height_px)},
          {"onPaper", onto_paper(*model.model, scene.canvas_to_screen)},
          {"shading", name_of(model.shading)},
          {"shadow", shadow_json(placement.box, scene.size)},
          {"mesh", nullptr}};
}

}  // namespace

Answer SceneSender::answer(Scene const& scene) {
  BlobWriter blobs;
  std::set<std::uint64_t> sent;
  auto chunks = Json::array();
  for (auto const& chunk : scene.chunks) {
    auto row = Json::array({chunk.id, chunk.space});
    if (chunks_.count(chunk.id) == 0) {
      auto const place =
          blobs.add_written([&](auto& bytes) { write_draw_list(*chunk.list, bytes); });
      row.insert(row.end(), place.begin(), place.end());
    }
    chunks.push_back(std::move(row));
    sent.insert(chunk.id);
  }
  chunks_ = std::move(sent);
  auto const& [a, b, c, d, e, f] = scene.canvas_to_screen;
  Json head = {{"width", scene.size.width_px},         {"height", scene.size.height_px},
               {"canvasToScreen", {a, b, c, d, e, f}}, {"paper", packed(scene.paper)},
               {"chunks", std::move(chunks)},          {"model", nullptr}};
  if (scene.model && scene.model->model) {
    auto& model = head["model"] = placed_model_json(*scene.model, scene);
    if (scene.model->id != model_) {
      model["mesh"] = mesh_json(*scene.model->model, scene.model->texture.get(), blobs);
      model_ = scene.model->id;
    }
  }
  return blobs.answer(head);
}

}  // namespace inkflate::web
