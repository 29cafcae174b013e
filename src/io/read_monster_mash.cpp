// SPDX-License-Identifier: Apache-2.0
#include "io/read_monster_mash.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "image/components.h"
#include "image/morphology.h"
#include "io/byte_order.h"
#include "io/monster_mash.h"
#include "io/monster_mash_archive.h"
#include "io/project_files.h"
#include "io/read_picture.h"
#include "io/trace_region.h"

namespace inkflate {
namespace {

using namespace monster_mash;

// Where the levels of its pictures part: other programs may have blurred them.
constexpr int kInkBelow = 32;
constexpr int kClosingBelow = 128;
constexpr int kInsideFrom = 128;
constexpr double kStrokeWidthPx = 3;
constexpr double kStrokeTolerancePx = 0.1;

struct Size {
  int width = 0;
  int height = 0;
};

Error about(ZipEntry const& entry, Error error) {
  error.message = entry.name + ": " + error.message;
  return error;
}

Result<Picture> unpack_picture(ZipEntry const& entry) {
  auto const file = unpack(entry);
  if (!file) return file.error();
  auto picture = read_picture(*file);
  if (!picture) return about(entry, picture.error());
  return picture;
}

std::string unpack_text(ZipEntry const* entry) {
  if (entry == nullptr) return {};
  auto const content = unpack(*entry);
  if (!content) return {};  // the text is a help, not more
  return {reinterpret_cast<char const*>(content->data()), content->size()};
}

/// What a PNG's header says, before its pixels are unpacked.
Result<Size> picture_size(ZipEntry const& entry) {
  auto const file = unpack(entry);
  if (!file) return file.error();
  bool const is_png = is_picture(*file) && (*file)[0] == std::byte{0x89} && file->size() >= 24;
  if (!is_png) return Error{ErrorCode::BadInput, entry.name + " is no PNG"};
  auto const width = big_endian32(std::span(*file).subspan(16));
  auto const height = big_endian32(std::span(*file).subspan(20));
  bool const is_legal = width > 0 && height > 0 && width <= PictureLimits::kSidePx &&
                        height <= PictureLimits::kSidePx;
  if (!is_legal || static_cast<long long>(width) * height > MonsterMashLimits::kCanvasPixels) {
    return Error{ErrorCode::TooLarge,
                 entry.name + " is no picture of 1 to 16 megapixels, the most that we trace"};
  }
  return Size{static_cast<int>(width), static_cast<int>(height)};
}

/// Luminance, as large as the canvas: cut off or filled up with the padding from the top left corner.
Mask grey(Picture const& picture, Size size, std::uint8_t padding) {
  Mask result(size.width, size.height, padding);
  for (int y = 0; y < std::min(size.height, picture.height); ++y) {
    for (int x = 0; x < std::min(size.width, picture.width); ++x) {
      auto const c = picture.at(x, y);
      result.at(x, y) = static_cast<std::uint8_t>((c.r * 77 + c.g * 150 + c.b * 29) / 256);
    }
  }
  return result;
}

Mask lines_of(Mask outline) {
  for (auto& value : outline.values) {
    value = value < kInkBelow ? kInkLine : value < kClosingBelow ? kHelpLine : kNoLine;
  }
  return outline;
}

Mask region_of(Mask region) {
  for (auto& value : region.values) value = value >= kInsideFrom ? kInside : 0;
  return region;
}

/// What the lines enclose, themselves included: all that the paper around the picture does not reach.
Mask flooded_region(Mask const& lines) {
  Mask paper = lines;
  for (auto& value : paper.values) value = value == kNoLine ? 255 : 0;
  auto const components = connected_components(paper, Neighbours::Four);
  std::vector<bool> is_outside(components.areas.size(), false);
  auto const mark = [&](int x, int y) {
    int const label = components.labels.at(x, y);
    if (label >= 0) is_outside[static_cast<std::size_t>(label)] = true;
  };
  for (int x = 0; x < paper.width; ++x) {
    mark(x, 0);
    mark(x, paper.height - 1);
  }
  for (int y = 0; y < paper.height; ++y) {
    mark(0, y);
    mark(paper.width - 1, y);
  }
  Mask region(paper.width, paper.height);
  for (std::size_t i = 0; i < region.values.size(); ++i) {
    int const label = components.labels.values[i];
    bool const is_inside = label < 0 || !is_outside[static_cast<std::size_t>(label)];
    region.values[i] = is_inside ? kInside : 0;
  }
  return region;
}

Result<std::vector<TracedRegion>> trace_pair(PicturePair const& pair, Size size) {
  Mask lines(size.width, size.height, kNoLine);
  if (pair.outline != nullptr) {
    auto const picture = unpack_picture(*pair.outline);
    if (!picture) return picture.error();
    lines = lines_of(grey(*picture, size, kPaper));
  }
  Mask region;
  if (pair.region != nullptr) {
    auto const picture = unpack_picture(*pair.region);
    if (!picture) return picture.error();
    region = region_of(grey(*picture, size, 0));
  } else {
    region = flooded_region(lines);
  }
  // Regions hold their lines in full width, so without a pixel all around they end in the middle of the lines.
  auto traced = trace_region(erode_3x3(region), lines);
  if (!traced || !traced->empty()) return traced;
  return trace_region(region, lines);
}

/// Collects a drawing from traced areas.
class DrawingBuilder {
 public:
  DrawingBuilder(Size size, double thickness) : thickness_(thickness) {
    drawing_.sketch.width_px = size.width;
    drawing_.sketch.height_px = size.height;
  }

  std::size_t layer_count() const { return drawing_.layers.size(); }
  Drawing take() && { return std::move(drawing_); }

  void add_region(int number, std::vector<TracedRegion> areas) {
    for (int piece = 1; auto& outlines : areas) {
      std::string const name = "region " + std::to_string(number) +
                               (piece == 1 ? "" : " piece " + std::to_string(piece));
      ++piece;
      add_layer(name, std::move(outlines));
    }
  }

 private:
  void add_layer(std::string const& name, std::vector<Outline> outlines) {
    group_ = static_cast<int>(std::ssize(drawing_.sketch.groups));
    drawing_.sketch.groups.push_back({name, {}, thickness_});
    Layer layer;
    layer.name = name;
    layer.thickness = thickness_;
    layer.outlines = std::move(outlines);
    for (auto& outline : layer.outlines) draw(outline, layer.strokes);
    drawing_.layers.push_back(std::move(layer));
  }

  /// Makes a stroke of each run, and tells the outline that this is where it comes from.
  void draw(Outline& outline, std::vector<int>& strokes) {
    auto const& pieces = outline.pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      bool const goes_on = i > 0 && pieces[i].kind == pieces[i - 1].kind;
      if (!goes_on) start_stroke(pieces[i], strokes);
      auto& samples = drawing_.sketch.strokes.back().samples;
      Polyline points;
      flatten_into(pieces[i].curve, kStrokeTolerancePx, points);
      double const before = static_cast<double>(samples.size() - 1);
      for (auto const point : points) samples.push_back({point});
      outline.sources.push_back({static_cast<double>(i), static_cast<double>(i + 1), strokes.back(),
                                 before, static_cast<double>(samples.size() - 1)});
    }
  }

  void start_stroke(OutlinePiece const& piece, std::vector<int>& strokes) {
    Stroke stroke;
    stroke.kind = piece.kind == RunKind::Ink ? StrokeKind::Ink : StrokeKind::HelpLine;
    stroke.width_px = kStrokeWidthPx;
    stroke.group = group_;
    stroke.samples.push_back({piece.curve.start()});
    strokes.push_back(static_cast<int>(std::ssize(drawing_.sketch.strokes)));
    drawing_.sketch.strokes.push_back(std::move(stroke));
  }

  Drawing drawing_;
  double thickness_;
  int group_ = -1;
};

/// Each picture is unpacked as large as it is and then made as large as the canvas.
std::optional<Error> check_pictures(std::span<PicturePair const> pairs, Size canvas) {
  long long pixels = 0;
  for (auto const& pair : pairs) {
    for (auto const* const entry : {pair.outline, pair.region}) {
      if (entry == nullptr) continue;
      auto const size = picture_size(*entry);
      if (!size) return size.error();
      pixels += std::max(static_cast<long long>(size->width) * size->height,
                         static_cast<long long>(canvas.width) * canvas.height);
    }
  }
  if (pixels <= MonsterMashLimits::kAllPixels) return std::nullopt;
  return Error{ErrorCode::TooLarge,
               "the pictures of this Monster Mash project have more than 512 megapixels together"};
}

Result<Drawing> trace_drawing(ProjectEntries const& entries, Size size) {
  auto const pair_count = static_cast<int>(std::ssize(entries.pairs));
  if (auto const error = check_pictures(entries.pairs, size)) return *error;
  double const thickness =
      thickness_setting(unpack_text(entries.settings)).value_or(Layer{}.thickness);
  DrawingBuilder builder(size, thickness);
  for (int const pair : depth_order(unpack_text(entries.layers), pair_count)) {
    auto areas = trace_pair(entries.pairs[static_cast<std::size_t>(pair)], size);
    if (!areas) return areas.error();
    if (areas->size() + builder.layer_count() > MonsterMashLimits::kLayers) {
      return Error{ErrorCode::TooLarge,
                   "this Monster Mash project has more than 1024 separate areas"};
    }
    builder.add_region(pair + 1, std::move(*areas));
  }
  if (builder.layer_count() == 0) {
    return Error{ErrorCode::NothingThere, "no region of this Monster Mash project has any area"};
  }
  return std::move(builder).take();
}

}  // namespace

Result<Project> read_monster_mash(std::span<std::byte const> file) {
  auto const archive = read_zip_directory(file);
  if (!archive) return archive.error();
  if (find_entry(*archive, kDocumentFile) != nullptr) return read_project_files(*archive);
  auto const entries = find_project(*archive);
  if (entries.pairs.empty()) {
    return Error{ErrorCode::BadInput, "no Monster Mash project: it has no pictures of regions"};
  }
  auto const& first = entries.pairs[0];
  auto const size = picture_size(first.outline != nullptr ? *first.outline : *first.region);
  if (!size) return size.error();
  auto drawing = trace_drawing(entries, *size);
  if (!drawing) return drawing.error();
  Project project = {std::move(*drawing)};
  if (entries.template_picture != nullptr) {
    auto picture = unpack_picture(*entries.template_picture);
    if (!picture) return picture.error();
    project.template_picture = std::move(*picture);
  }
  return project;
}

}  // namespace inkflate
