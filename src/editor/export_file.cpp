// SPDX-License-Identifier: Apache-2.0
#include "editor/export_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "document/give_room.h"
#include "io/drawing_file.h"
#include "io/model_files.h"
#include "io/write_png.h"
#include "render/draw_model.h"
#include "render/rasterise_model.h"
#include "solidify/solidify.h"

namespace inkflate {
namespace {

/// The longer side of a picture of the model.
constexpr int kModelPicturePx = 1024;

Result<ModelScene> model_of(ExportRequest const& request, ModelCache& cache,
                            Progress const& progress) {
  if (!cache.is_current(request.document)) {
    auto const made = cache.make(request.document, progress);
    if (!made) return made.error();
  }
  return *cache.scene(request.view.model, request.view.shading);
}

Result<std::vector<std::byte>> print_of(RestModel const& model, Drawing const& drawing,
                                        ModelFormat format, std::string const& name,
                                        Progress const& progress) {
  auto const shell = solidify(model.mesh, {}, progress);
  if (!shell) return shell.error();
  return write_print_file(*shell, drawing, format, name);
}

Result<std::vector<FileOut>> export_model(ExportRequest const& request, ModelFormat format,
                                          ModelCache& cache, Progress const& progress) {
  auto const scene = model_of(request, cache, progress);
  if (!scene) return scene.error();
  auto const drawing = shown_drawing(request.document);
  std::vector<FileOut> result;
  if (format == ModelFormat::Stl || format == ModelFormat::ThreeMf) {
    auto bytes = print_of(*scene->model, drawing, format, request.name, progress);
    if (!bytes) return bytes.error();
    result.push_back({request.name + "." + request.extension, std::move(*bytes)});
    return result;
  }
  if (!progress.enter("write")) return Error{ErrorCode::Cancelled, "stopped on request"};
  auto files =
      write_model_files(*scene->model, scene->texture.get(), drawing, format, request.name);
  for (auto& file : files) {
    result.push_back({request.name + file.extension, std::move(file.bytes)});
  }
  return result;
}

Result<std::vector<std::byte>> picture_of_model(ExportRequest const& request, ModelCache& cache,
                                                Progress const& progress) {
  auto const scene = model_of(request, cache, progress);
  if (!scene) return scene.error();
  auto view = scene->view;
  view.pan_px = {};
  view.zoom = 1;  // all of it, however near the person looks
  auto const list = draw_model(*scene->model, scene->texture.get(), view, scene->shading,
                               kModelPicturePx, kModelPicturePx);
  return write_png(rasterise_model(list, kModelPicturePx, kModelPicturePx));
}

Result<std::vector<std::byte>> export_drawing(ExportRequest const& request, ModelCache& cache,
                                              Progress const& progress) {
  auto const format = drawing_format_of("." + request.extension);
  if (!format) {
    return Error{ErrorCode::BadOption,
                 "cannot export ." + request.extension.substr(0, 20) +
                     ": choose inkflate, svg, png, zip, glb, obj, stl or 3mf"};
  }
  if (*format == DrawingFormat::MaskPicture) {
    if (request.view.mode != Mode::Draw) return picture_of_model(request, cache, progress);
    return write_drawing_picture(give_room(to_project(request.document)).drawing);
  }
  // Our own projects are as they are: what has left the sheet is kept.
  auto project = to_project(request.document);
  if (*format != DrawingFormat::Inkflate) project = give_room(std::move(project));
  return write_drawing_file(project, *format);
}

}  // namespace

Result<std::vector<FileOut>> export_file(ExportRequest const& request, ModelCache& cache,
                                         Progress const& progress) {
  if (auto const format = model_format_of("." + request.extension)) {
    return export_model(request, *format, cache, progress);
  }
  auto bytes = export_drawing(request, cache, progress);
  if (!bytes) return bytes.error();
  std::vector<FileOut> result;
  result.push_back({request.name + "." + request.extension, std::move(*bytes)});
  return result;
}

}  // namespace inkflate
