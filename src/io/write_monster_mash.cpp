// SPDX-License-Identifier: Apache-2.0
#include "io/write_monster_mash.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/affine.h"
#include "geometry/rect.h"
#include "image/fill_polygon.h"
#include "image/filter.h"
#include "image/morphology.h"
#include "image/rasterise_line.h"
#include "io/monster_mash.h"
#include "io/numbers.h"
#include "io/project_files.h"
#include "io/put_bytes.h"
#include "io/write_png.h"

namespace inkflate {
namespace {

using namespace monster_mash;

constexpr double kTolerancePx = 0.05;
// A closing joins another part if its ends come so close to it, px of the written canvas: the pen's width.
constexpr double kJoinPx = 3;
// Layers that leave the canvas keep so much distance from its edges: room for the pen.
constexpr double kMarginPx = 3;

constexpr std::string_view kVersionLine = "v. 230112\n";

/// A layer on the written canvas.
struct Part {
  std::vector<Contour> contours;
  std::vector<std::vector<Run>> runs;  // per contour
};

void move_points(std::vector<Vec2>& points, Affine const& map) {
  for (auto& point : points) point = map(point);
}

/// The largest scale at which the box lies on the written canvas, centred.
Affine fit(Rect const& box, double margin_px) {
  if (!(box.width() > 0 && box.height() > 0)) return {};
  double const scale = std::min((kWidthPx - 2 * margin_px) / box.width(),
                                (kHeightPx - 2 * margin_px) / box.height());
  return Affine::translation({kWidthPx / 2.0, kHeightPx / 2.0}) * Affine::scaling(scale, scale) *
         Affine::translation(-box.centre());
}

Affine canvas_map(Drawing const& drawing) {
  Rect canvas;
  canvas.include({0, 0});
  canvas.include({drawing.sketch.width_px, drawing.sketch.height_px});
  Rect all = canvas;
  for (auto const& layer : drawing.layers) {
    for (auto const& outline : layer.outlines) {
      for (auto const point : flatten(outline, 1)) all.include(point);
    }
  }
  return all == canvas ? fit(canvas, 0) : fit(all, kMarginPx);
}

Part placed(Layer const& layer, Affine const& map) {
  Part part;
  double const tolerance_px = kTolerancePx / map.mean_scale();
  for (auto const& outline : layer.outlines) {
    part.contours.push_back(flatten(outline, tolerance_px));
    move_points(part.contours.back(), map);
    part.runs.push_back(runs(outline, tolerance_px));
    for (auto& run : part.runs.back()) move_points(run.points, map);
  }
  return part;
}

bool is_on(Part const& part, Vec2 p) {
  for (auto const& contour : part.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      auto const a = contour[i];
      auto const b = contour[(i + 1) % contour.size()];
      if (squared_distance_to_segment(p, a, b) <= kJoinPx * kJoinPx) return true;
    }
  }
  return contains(part.contours, p);
}

bool is_open(Run const& run, std::vector<Part> const& parts, std::size_t own) {
  if (run.kind == RunKind::HelpLine) return true;
  if (run.kind == RunKind::Ink) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == own) continue;
    if (is_on(parts[i], run.points.front()) && is_on(parts[i], run.points.back())) return true;
  }
  return false;
}

void copy_where(Mask const& wanted, std::uint8_t value, Mask& picture) {
  for (std::size_t i = 0; i < wanted.values.size(); ++i) {
    if (wanted.values[i] != 0) picture.values[i] = value;
  }
}

struct RegionPictures {
  Mask outline;
  Mask region;
};

/// Lines are 3 px wide, since the program halves the pictures. It follows a hole on the hole's own pixels, so there they
/// reach 1 px farther than the region.
RegionPictures draw_region(std::vector<Part> const& parts, std::size_t index) {
  auto const& part = parts[index];
  RegionPictures pictures = {Mask(kWidthPx, kHeightPx, kPaper), Mask(kWidthPx, kHeightPx)};
  fill_polygon(part.contours, pictures.region, kInside);
  for (bool const draws_open : {true, false}) {  // ink lies over closing lines
    Mask rims(kWidthPx, kHeightPx);
    Mask hole_rims = rims;
    for (std::size_t i = 0; i < part.contours.size(); ++i) {
      bool const is_hole = signed_area(part.contours[i]) < 0;
      for (auto const& run : part.runs[i]) {
        if (is_open(run, parts, index) != draws_open) continue;
        rasterise_polyline(run.points, is_hole ? hole_rims : rims);
      }
    }
    rims = dilate_3x3(rims);
    hole_rims = dilate_3x3(hole_rims);
    copy_where(rims, kInside, pictures.region);
    copy_where(hole_rims, kInside, pictures.region);
    std::uint8_t const value = draws_open ? kClosing : kOutline;
    copy_where(dilate_3x3(hole_rims), value, pictures.outline);
    copy_where(rims, value, pictures.outline);
  }
  return pictures;
}

/// The picture as it lies on the written canvas; paper is white.
Picture place_template(Picture const& picture, Drawing const& drawing, Affine const& map) {
  Vec2 const size = {static_cast<double>(picture.width), static_cast<double>(picture.height)};
  Vec2 const canvas = {drawing.sketch.width_px, drawing.sketch.height_px};
  double const scale = std::min(canvas.x / size.x, canvas.y / size.y);
  auto const corner = map((canvas - size * scale) / 2);
  auto const placed_size = size * (scale * map.mean_scale());
  auto const side = [](double wanted_px, int most) {
    return static_cast<int>(std::clamp(std::round(wanted_px), 1.0, static_cast<double>(most)));
  };
  // Each pixel of what is left stands for one of the canvas, or for more.
  auto const small = over_white(
      shrink(picture, side(placed_size.x, picture.width), side(placed_size.y, picture.height)));
  Picture placed(kWidthPx, kHeightPx, Colour{255, 255, 255, 255});
  for (int y = 0; y < kHeightPx; ++y) {
    for (int x = 0; x < kWidthPx; ++x) {
      double const u = (x + 0.5 - corner.x) / placed_size.x * small.width;
      double const v = (y + 0.5 - corner.y) / placed_size.y * small.height;
      if (!(u >= 0 && v >= 0 && u < small.width && v < small.height)) continue;
      placed.at(x, y) = small.at(static_cast<int>(u), static_cast<int>(v));
    }
  }
  return placed;
}

std::string numbered(std::string_view kind, std::size_t index) {
  std::string const digits = std::to_string(index);
  return "_" + std::string(kind) + "_" + std::string(3 - digits.size(), '0') + digits + ".png";
}

/// Regions are stored back to front, so that is the order of their ids as well.
std::string layers_text(std::size_t count) {
  std::string ids;
  for (std::size_t i = 0; i < count; ++i) ids += std::to_string(i) + "\n";
  std::string const number = std::to_string(count) + "\n";
  return std::string(kVersionLine) + number + ids + "\n" + number + ids;
}

/// The program knows one thickness for all; it is told where ours is one, too.
std::string settings_text(Project const& project, Drawing const& drawing) {
  auto const& layers = drawing.layers;
  bool const is_common = std::all_of(layers.begin(), layers.end(), [&](Layer const& layer) {
    return layer.thickness == layers[0].thickness;
  });
  std::string text = std::string(kVersionLine) + "manipulationMode draw\n";
  text += project.template_picture ? "showTemplateImg 1\n" : "showTemplateImg 0\n";
  text += "defaultInflationAmount ";
  append_rounded(text, is_common ? layers[0].thickness : Layer{}.thickness);
  return text + "\n";
}

std::vector<Part> parts_of(Drawing const& drawing, Affine const& map) {
  std::vector<Part> parts;
  for (auto const& layer : drawing.layers) {
    auto part = placed(layer, map);
    bool const encloses = std::any_of(part.contours.begin(), part.contours.end(),
                                      [](Contour const& c) { return c.size() > 2; });
    if (encloses) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

Result<std::vector<std::byte>> write_monster_mash(Project const& project) {
  auto const drawing = shown(project.drawing);
  auto const map = canvas_map(drawing);
  auto const parts = parts_of(drawing, map);
  if (parts.empty()) {
    return Error{ErrorCode::NothingThere,
                 "a Monster Mash project needs closed layers; simplify the strokes first"};
  }
  if (parts.size() > kMostRegions) {
    return Error{ErrorCode::TooLarge, "a Monster Mash project holds at most 255 layers"};
  }
  std::vector<ZipFile> files;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto const pictures = draw_region(parts, i);
    files.push_back({numbered("org", i), write_png(pictures.outline)});
    files.push_back({numbered("seg", i), write_png(pictures.region)});
  }
  files.push_back({"layers.txt", bytes_of(layers_text(parts.size()))});
  files.push_back({"cps.txt", bytes_of(kVersionLine)});
  if (auto const& picture = project.template_picture) {
    files.push_back({"template.png", write_png(place_template(*picture, drawing, map))});
  }
  files.push_back({"settings.txt", bytes_of(settings_text(project, drawing))});
  auto own = project_files(project);
  if (!own) return own.error();
  for (auto& file : *own) files.push_back(std::move(file));
  return write_project_zip(files);
}

}  // namespace inkflate
