// SPDX-License-Identifier: Apache-2.0
#include "io/project_files.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "io/parse_json.h"
#include "io/put_bytes.h"
#include "io/read_document_json.h"
#include "io/read_picture.h"
#include "io/sketch_limits.h"
#include "io/write_document_json.h"
#include "io/write_png.h"
#include "render/draw_drawing.h"
#include "render/palette.h"
#include "render/rasterise.h"

namespace inkflate {
namespace {

constexpr std::string_view kPreviewFile = "preview.png";
constexpr std::string_view kTemplateFile = "pictures/template.png";
constexpr double kPreviewSidePx = 256;

/// Takes away dashes that nobody could count: lines far beyond the canvas may have any number of them.
void keep_dashes_few(DrawList& list) {
  constexpr double most_dashes = 500;
  for (auto& item : list) {
    auto* const line = std::get_if<StrokedPolyline>(&item);
    if (line == nullptr || line->dashes_px.empty()) continue;
    double const period_px = std::accumulate(line->dashes_px.begin(), line->dashes_px.end(), 0.0);
    if (!(length(line->points) <= most_dashes * period_px)) line->dashes_px.clear();
  }
}

/// What the drawing looks like, for file managers; empty where the canvas has no size.
std::vector<std::byte> preview(Drawing const& drawing) {
  auto const& canvas = drawing.sketch;
  if (!(canvas.width_px > 0 && canvas.height_px > 0)) return {};
  double const scale = kPreviewSidePx / std::max(canvas.width_px, canvas.height_px);
  auto const side = [&](double length_px) {
    return static_cast<int>(std::clamp(std::ceil(length_px * scale), 1.0, kPreviewSidePx));
  };
  // Lines that stay visible when the whole canvas is as small as this.
  DrawDrawingOptions const options = {.line_width_px = 1.5 / scale};
  auto list = drawing.layers.empty() ? draw_sketch(canvas) : draw_drawing(drawing, options);
  keep_dashes_few(list);
  return write_png(rasterise(place(std::move(list), Affine::scaling(scale, scale)),
                             side(canvas.width_px), side(canvas.height_px), palette::kPaper));
}

}  // namespace

Result<std::vector<ZipFile>> project_files(Project const& project) {
  auto const& picture = project.template_picture;
  auto const text = write_document_json(project, picture ? kTemplateFile : std::string_view());
  if (auto const limits = check_json_limits(text); !limits) return limits.error();
  std::vector<ZipFile> files;
  files.push_back({std::string(kDocumentFile), bytes_of(text)});
  if (auto png = preview(project.drawing); !png.empty()) {
    files.push_back({std::string(kPreviewFile), std::move(png)});
  }
  if (picture) files.push_back({std::string(kTemplateFile), write_png(*picture)});
  return files;
}

Result<std::vector<std::byte>> write_project_zip(std::span<ZipFile const> files) {
  auto archive = write_zip(files);
  if (std::ssize(archive) > kMaxFileBytes) {
    return Error{ErrorCode::TooLarge,
                 "the file would be larger than 64 MB, which is the most we read"};
  }
  return archive;
}

Result<Project> read_project_files(std::span<ZipEntry const> entries) {
  auto const* const entry = find_entry(entries, kDocumentFile);
  if (entry == nullptr) return Error{ErrorCode::BadInput, "the archive has no document.json"};
  auto const content = unpack(*entry);
  if (!content) return content.error();
  auto document =
      read_document_json({reinterpret_cast<char const*>(content->data()), content->size()});
  if (!document) return document.error();
  auto project = std::move(document->project);
  if (document->template_name.empty()) return project;
  auto const* const file = find_entry(entries, document->template_name);
  if (file == nullptr) {
    return Error{ErrorCode::BadInput,
                 "the archive lacks the template picture that its document names"};
  }
  auto const packed = unpack(*file);
  if (!packed) return packed.error();
  auto picture = read_picture(*packed);
  if (!picture) {
    return Error{picture.error().code, "the template picture: " + picture.error().message};
  }
  project.template_picture = std::move(*picture);
  return project;
}

}  // namespace inkflate
