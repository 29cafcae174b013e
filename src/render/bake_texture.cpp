// SPDX-License-Identifier: Apache-2.0
#include "render/bake_texture.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "geometry/rect.h"
#include "render/draw_layer.h"
#include "render/lay_picture.h"
#include "render/layer_rims.h"
#include "render/pack_shelves.h"
#include "render/palette.h"

namespace inkflate {
namespace {

/// Ink goes through bands of rows, so that the coverage of a large rectangle needs little memory.
constexpr int kBandRows = 256;
/// Each try makes the picture at least a twentieth smaller.
constexpr int kMostTries = 200;

/// What one rectangle of the picture shows.
struct Area {
  Layer const* layer = nullptr;  // none: plain
  Rect box;                      // canvas px
  DrawList ink;                  // canvas px
};

struct Areas {
  std::vector<Area> list;
  std::vector<std::array<int, 2>> of_layer;  // per layer and side: which of the list
};

struct Atlas {
  double scale = 1;  // texels per canvas px
  Shelves shelves;   // a box for each area
};

int layer_count(RestModel const& model) {
  int count = 0;
  for (auto const& face : model.faces) count = std::max(count, face.layer + 1);
  return count;
}

std::vector<Rect> layer_boxes(RestModel const& model) {
  std::vector<Rect> boxes(static_cast<std::size_t>(layer_count(model)));
  for (std::size_t t = 0; t < model.faces.size(); ++t) {
    auto& box = boxes[static_cast<std::size_t>(model.faces[t].layer)];
    for (int const corner : model.mesh.triangles[t]) {
      box.include(model.canvas[static_cast<std::size_t>(corner)]);
    }
  }
  return boxes;
}

DrawList layer_ink(Drawing const& drawing, Layer const& layer, std::vector<RimLine> const& rims,
                   OutlineLook outline, BackDetails details) {
  auto list = outline == OutlineLook::Clean ? draw_clean_rims(drawing, layer, rims) : DrawList{};
  auto strokes = outline == OutlineLook::Clean ? std::vector<int>{} : layer.strokes;
  if (details == BackDetails::Shown) {
    strokes.insert(strokes.end(), layer.details.begin(), layer.details.end());
  }
  std::sort(strokes.begin(), strokes.end());  // as they were drawn
  append(list, draw_ink(drawing, strokes));
  return list;
}

Areas find_areas(Drawing const& drawing, RestModel const& model, BakeOptions const& options) {
  Areas areas;
  auto const boxes = layer_boxes(model);
  auto const rims = layer_rims(model);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].is_empty()) {  // no triangle: no place
      areas.of_layer.push_back({});
      continue;
    }
    auto const* const layer = i < drawing.layers.size() ? &drawing.layers[i] : nullptr;
    bool const differ =
        options.back_details == BackDetails::Hidden && layer && !layer->details.empty();
    int const front = static_cast<int>(areas.list.size());
    auto const add = [&](BackDetails details) {
      Area area = {layer, boxes[i], {}};
      if (layer) area.ink = layer_ink(drawing, *layer, rims[i], options.outline, details);
      areas.list.push_back(std::move(area));
    };
    add(BackDetails::Shown);
    if (differ) add(BackDetails::Hidden);
    areas.of_layer.push_back({front, differ ? front + 1 : front});
  }
  return areas;
}

Atlas try_scale(std::vector<Area> const& areas, double scale, int padding) {
  std::vector<PixelSize> sizes;
  auto const side = [&](double length_px) {
    return static_cast<int>(std::ceil(length_px * scale)) + 2 * padding;
  };
  for (auto const& area : areas) sizes.push_back({side(area.box.width()), side(area.box.height())});
  return {scale, pack_shelves(sizes)};
}

/// The largest scale that the limits allow, to within a twentieth.
Atlas lay_out(std::vector<Area> const& areas, BakeOptions const& options) {
  double longest_px = 0;
  for (auto const& area : areas) longest_px = std::max(longest_px, area.box.longer_side());
  double const limit = options.longest_side;
  double scale = std::min(options.texels_per_px, limit / std::max(longest_px, 1.0));
  auto atlas = try_scale(areas, scale, options.padding);
  for (int i = 0; i < kMostTries; ++i) {
    double const longer = std::max(atlas.shelves.width, atlas.shelves.height);
    if (longer <= limit) break;
    scale *= std::clamp(limit / longer, 0.5, 0.95);
    atlas = try_scale(areas, scale, options.padding);
  }
  return atlas;
}

/// Canvas px to texels of the whole picture.
Affine area_map(Area const& area, PixelBox const& place, Atlas const& atlas, int padding) {
  Vec2 const corner = {static_cast<double>(place.left + padding),
                       static_cast<double>(place.top + padding)};
  return Affine::translation(corner - atlas.scale * area.box.min) *
         Affine::scaling(atlas.scale, atlas.scale);
}

void fill_box(Picture& picture, PixelBox const& box, Colour colour) {
  for (int y = box.top; y < box.top + box.height; ++y) {
    for (int x = box.left; x < box.left + box.width; ++x) picture.at(x, y) = colour;
  }
}

void draw_area(Area const& area, PixelBox const& place, Affine const& map, Picture& picture) {
  auto colour = area.layer ? area.layer->fill.value_or(palette::kSkin) : palette::kSkin;
  colour.a = 255;
  fill_box(picture, place, colour);
  auto const list = inkflate::place(area.ink, map);
  for (int row = 0; row < place.height; row += kBandRows) {
    int const rows = std::min(kBandRows, place.height - row);
    rasterise_into(list, {place.left, place.top + row, place.width, rows}, picture);
  }
}

}  // namespace

Texture bake_texture(Drawing const& drawing, RestModel const& model, BakeOptions const& options) {
  CHECK(options.texels_per_px > 0 && options.longest_side >= 64 && options.longest_side <= 16384 &&
            options.padding >= 0 && options.padding <= 64,
        "bake options in range");
  auto const areas = find_areas(drawing, model, options);
  auto const atlas = lay_out(areas.list, options);
  Texture texture;
  texture.picture =
      Picture(std::max(atlas.shelves.width, 1), std::max(atlas.shelves.height, 1), palette::kSkin);
  std::vector<Affine> maps;
  for (std::size_t i = 0; i < areas.list.size(); ++i) {
    auto const& place = atlas.shelves.boxes[i];
    maps.push_back(area_map(areas.list[i], place, atlas, options.padding));
    draw_area(areas.list[i], place, maps[i], texture.picture);
  }
  auto const to_unit = Affine::scaling(1.0 / texture.picture.width, 1.0 / texture.picture.height);
  for (auto& map : maps) map = to_unit * map;
  texture.corners.resize(model.faces.size());
  for (std::size_t t = 0; t < model.faces.size(); ++t) {
    auto const [layer, side] = model.faces[t];
    auto const& sides = areas.of_layer[static_cast<std::size_t>(layer)];
    auto const& map = maps[static_cast<std::size_t>(sides[side == Side::Front ? 0 : 1])];
    for (std::size_t k = 0; k < 3; ++k) {
      auto const vertex = static_cast<std::size_t>(model.mesh.triangles[t][k]);
      texture.corners[t][k] = map(model.canvas[vertex]);
    }
  }
  return texture;
}

Texture wear_picture(Picture picture, RestModel const& model) {
  Texture texture;
  texture.picture = std::move(picture);
  auto const map =
      lay_picture(texture.picture, std::max(model.width_px, 1.0), std::max(model.height_px, 1.0));
  Vec2 const origin = {map.e, map.f};
  Vec2 const size = {map.a * texture.picture.width, map.d * texture.picture.height};
  for (auto const& triangle : model.mesh.triangles) {
    auto& corners = texture.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      auto const place = model.canvas[static_cast<std::size_t>(triangle[k])] - origin;
      corners[k] = {std::clamp(place.x / size.x, 0.0, 1.0), std::clamp(place.y / size.y, 0.0, 1.0)};
    }
  }
  return texture;
}

}  // namespace inkflate
