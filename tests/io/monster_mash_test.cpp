// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/crossings.h"
#include "io/read_monster_mash.h"
#include "io/read_picture.h"
#include "io/read_zip.h"
#include "io/write_monster_mash.h"
#include "io/write_png.h"
#include "io/write_zip.h"
#include "render/draw_mask.h"
#include "support/characters.h"
#include "support/random_drawing.h"
#include "support/zip_bytes.h"

namespace inkflate {
namespace {

using test::bytes_of;
using test::raw_zip;
using test::RawZipEntry;

/// A region as the program stores it, made of a distance to its line: negative inside.
struct Region {
  Mask outline;
  Mask area;
};

template <typename Distance, typename IsOpen>
Region draw_region(int width, int height, Distance distance, IsOpen is_open) {
  Region region = {Mask(width, height, 255), Mask(width, height)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Vec2 const p = {x + 0.5, y + 0.5};
      double const d = distance(p);
      if (d <= 1.5) region.area.at(x, y) = 255;
      if (std::abs(d) <= 1.5) region.outline.at(x, y) = is_open(p) ? 64 : 0;
    }
  }
  return region;
}

/// A circle whose part left of an upright line is open.
Region circle(Vec2 centre, double radius, double open_left_of = -1, int width = 420,
              int height = 520) {
  return draw_region(
      width, height, [=](Vec2 p) { return distance(p, centre) - radius; },
      [=](Vec2 p) { return p.x < open_left_of; });
}

std::vector<RawZipEntry> entries_of(std::vector<Region> const& regions, std::string const& folder) {
  std::vector<RawZipEntry> entries;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    std::string const number = "_00" + std::to_string(i) + ".png";
    entries.push_back({folder + "_org" + number, write_png(regions[i].outline)});
    entries.push_back({folder + "_seg" + number, write_png(regions[i].area)});
  }
  return entries;
}

Project read_or_fail(test::Bytes const& archive) {
  auto project = read_monster_mash(archive);
  EXPECT_TRUE(project.has_value()) << project.error().message;
  return project ? *project : Project{};
}

ErrorCode verdict(std::vector<RawZipEntry> const& entries) {
  auto const project = read_monster_mash(raw_zip(entries));
  EXPECT_FALSE(project.has_value());
  return project ? ErrorCode::Cancelled : project.error().code;
}

double kind_length(Layer const& layer, RunKind kind) {
  double sum = 0;
  for (auto const& outline : layer.outlines) {
    for (auto const& run : runs(outline, 0.1)) {
      if (run.kind == kind) sum += length(run.points);
    }
  }
  return sum;
}

double area(Outline const& outline) { return signed_area(flatten(outline, 0.05)); }

// Written down from the format's description alone.
TEST(ReadMonsterMash, AProjectByHand) {
  auto entries =
      entries_of({circle({300, 400}, 100, -1, 1000, 800), circle({500, 400}, 150, 450, 1000, 800)},
                 "mm_project/");
  entries.push_back(
      {"mm_project/layers.txt",
       bytes_of("v. 230112\n5\n 4\n 2\n\n2\n 2 4")});  // the second picture is farther
  entries.push_back({"mm_project/cps.txt", bytes_of("v. 230112\n")});
  entries.push_back(
      {"mm_project/settings.txt",
       bytes_of("v. 230112\nmanipulationMode draw\nnew 1\ndefaultInflationAmount 3.5\n")});
  entries.push_back({"mm_project/template.png", write_png(Mask(1000, 800, 77))});
  auto const project = read_or_fail(raw_zip(entries));
  auto const& drawing = project.drawing;
  auto const& template_picture = project.template_picture;
  EXPECT_EQ(drawing.sketch.width_px, 1000);
  EXPECT_EQ(drawing.sketch.height_px, 800);
  ASSERT_EQ(drawing.layers.size(), 2U);
  EXPECT_EQ(drawing.layers[0].name, "region 2");
  EXPECT_EQ(drawing.layers[1].name, "region 1");
  EXPECT_EQ(drawing.layers[0].thickness, 3.5);
  // The line's middle comes back, within about half a pixel.
  EXPECT_NEAR(area(drawing.layers[1].outlines.at(0)), M_PI * 100 * 100, 1.2 * M_PI * 100);
  EXPECT_NEAR(area(drawing.layers[0].outlines.at(0)), M_PI * 150 * 150, 1.2 * M_PI * 150);
  // The circle's part left of 450: an angle of 2 acos(50 / 150).
  double const open_px = 150 * 2 * std::acos(50.0 / 150);
  EXPECT_NEAR(kind_length(drawing.layers[0], RunKind::HelpLine), open_px, 5);
  EXPECT_EQ(kind_length(drawing.layers[1], RunKind::HelpLine), 0);
  ASSERT_TRUE(template_picture.has_value());
  EXPECT_EQ(template_picture->at(0, 0), (Colour{77, 77, 77, 255}));
}

TEST(ReadMonsterMash, SmoothBoundariesAreFewCurves) {
  auto const project = read_or_fail(raw_zip(entries_of({circle({300, 400}, 100)}, "")));
  EXPECT_LE(project.drawing.layers.at(0).outlines.at(0).pieces.size(), 12U);
}

TEST(ReadMonsterMash, CornersStaySharp) {
  auto const square = draw_region(
      400, 400, [](Vec2 p) { return std::max(std::abs(p.x - 200.5), std::abs(p.y - 200.5)) - 100; },
      [](Vec2) { return false; });
  auto const project = read_or_fail(raw_zip(entries_of({square}, "")));
  auto const& outline = project.drawing.layers.at(0).outlines.at(0);
  EXPECT_EQ(outline.pieces.size(), 4U);
  EXPECT_NEAR(area(outline), 200 * 200, 0.5);
}

TEST(ReadMonsterMash, HolesAndOtherCanvasesAreRead) {
  auto const ring = draw_region(
      300, 200,
      [](Vec2 p) {
        return std::abs(distance(p, {150, 100}) - 60) - 20;
      },
      [](Vec2) { return false; });
  auto const project = read_or_fail(raw_zip(entries_of({ring}, "")));
  EXPECT_EQ(project.drawing.sketch.width_px, 300);
  auto const& outlines = project.drawing.layers.at(0).outlines;
  ASSERT_EQ(outlines.size(), 2U);
  EXPECT_NEAR(area(outlines[0]), M_PI * 80 * 80, M_PI * 80);
  EXPECT_NEAR(area(outlines[1]), -M_PI * 40 * 40, M_PI * 40);
}

TEST(ReadMonsterMash, RunsAreStrokesThatTheOutlineComesFrom) {
  auto const project = read_or_fail(raw_zip(entries_of({circle({300, 400}, 100, 280)}, "")));
  auto const& sketch = project.drawing.sketch;
  auto const& layers = project.drawing.layers;
  ASSERT_EQ(sketch.strokes.size(), 2U);
  EXPECT_EQ(layers.at(0).strokes, (std::vector<int>{0, 1}));
  EXPECT_NE(sketch.strokes[0].kind, sketch.strokes[1].kind);
  for (auto const& outline : layers[0].outlines) {
    for (auto const& source : outline.sources) {
      auto const& samples = sketch.strokes[static_cast<std::size_t>(source.stroke)].samples;
      auto const& piece = outline.pieces[static_cast<std::size_t>(source.from)];
      EXPECT_EQ(samples[static_cast<std::size_t>(source.sample_from)].position,
                piece.curve.start());
      EXPECT_EQ(samples[static_cast<std::size_t>(source.sample_to)].position, piece.curve.end());
    }
  }
}

TEST(ReadMonsterMash, AMissingPartnerIsMadeUp) {
  auto const region = circle({300, 400}, 100, 280);
  auto const only_outline = read_or_fail(raw_zip({{"_org_000.png", write_png(region.outline)}}));
  auto const only_area = read_or_fail(raw_zip({{"_seg_000.png", write_png(region.area)}}));
  EXPECT_NEAR(area(only_outline.drawing.layers.at(0).outlines.at(0)), M_PI * 1e4, 380);
  EXPECT_NEAR(area(only_area.drawing.layers.at(0).outlines.at(0)), M_PI * 1e4, 380);
  EXPECT_GT(kind_length(only_outline.drawing.layers[0], RunKind::HelpLine), 200);
  EXPECT_EQ(kind_length(only_area.drawing.layers[0], RunKind::HelpLine), 0);
}

TEST(ReadMonsterMash, PicturesOfOtherSizesAreCutOrFilledUp) {
  auto const small = circle({60, 60}, 40, -1, 120, 120);
  auto const project = read_or_fail(raw_zip(entries_of({circle({300, 400}, 100), small}, "")));
  ASSERT_EQ(project.drawing.layers.size(), 2U);
  EXPECT_NEAR(area(project.drawing.layers[1].outlines.at(0)), M_PI * 1600, 130);
}

TEST(ReadMonsterMash, HostileProjectsEndInTheRightVerdict) {
  auto const png = write_png(Mask(20, 20, 255));
  EXPECT_EQ(verdict({{"layers.txt", bytes_of("v. 1 1 0 1 0")}}), ErrorCode::BadInput);
  EXPECT_EQ(verdict({{"_org_000.png", png}}), ErrorCode::NothingThere);
  EXPECT_EQ(verdict({{"_org_000.png", bytes_of("no picture at all, not even by its length")}}),
            ErrorCode::BadInput);
  EXPECT_EQ(verdict({{"../_org_000.png", png}}), ErrorCode::BadInput);
  EXPECT_EQ(verdict({{"_org_000.png", {png.begin(), png.end() - 20}}}), ErrorCode::BadInput);
  auto huge = png;
  huge[16] = std::byte{1};
  EXPECT_EQ(verdict({{"_org_000.png", huge}}), ErrorCode::TooLarge);
  EXPECT_EQ(verdict({{"_org_000.png", png}, {"document.json", bytes_of("{}")}}),
            ErrorCode::BadInput);
}

TEST(ReadMonsterMash, DamagedTextsAreLookedThrough) {
  auto const regions = entries_of({circle({30, 40}, 20, -1, 100, 80)}, "");
  for (std::string const text : {"", "v.", "v. 1", "v. 1 2", "v. 1 -5 7 99999999999 x",
                                 "v. 1 1 0 2147483647 0 0 0", "1 2 3", "v. 1 9 9 1 8"}) {
    auto entries = regions;
    entries.push_back({"layers.txt", bytes_of(text)});
    entries.push_back({"settings.txt", bytes_of(text + " defaultInflationAmount 1e99")});
    auto const project = read_or_fail(raw_zip(entries));
    EXPECT_EQ(project.drawing.layers.size(), 1U) << text;
    EXPECT_EQ(project.drawing.layers[0].thickness, 2);
  }
}

TEST(ReadMonsterMash, AThousandLayersAreRead) {
  auto const png = write_png(circle({20, 20}, 10, -1, 40, 40).area);
  std::vector<RawZipEntry> entries;
  for (int i = 0; i < 1000; ++i) {
    auto const digits = std::to_string(i);
    entries.push_back({"_seg_" + std::string(3 - digits.size(), '0') + digits + ".png", png});
  }
  EXPECT_EQ(read_or_fail(raw_zip(entries)).drawing.layers.size(), 1000U);
}

TEST(ReadMonsterMash, TracedOutlinesNeverCross) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Rng rng(seed);
    Mask area(60, 60);
    for (int i = 1 + rng.below(40); i > 0; --i) {
      int const x = rng.below(60);
      int const y = rng.below(60);
      int const w = 1 + rng.below(20);
      int const h = 1 + rng.below(20);
      auto const value = static_cast<std::uint8_t>(rng.below(3) == 0 ? 0 : 255);
      for (int v = y; v < std::min(y + h, 60); ++v) {
        for (int u = x; u < std::min(x + w, 60); ++u) area.at(u, v) = value;
      }
    }
    auto const project = read_monster_mash(raw_zip({{"_seg_000.png", write_png(area)}}));
    if (!project) continue;
    for (auto const& layer : project->drawing.layers) {
      std::vector<Contour> polygons;
      for (auto const& outline : layer.outlines) polygons.push_back(flatten(outline, 0.01));
      EXPECT_TRUE(find_crossings(polygons, 1).empty()) << seed;
    }
  }
}

/// The archive without our document.
test::Bytes without_document(test::Bytes const& archive) {
  std::vector<ZipFile> files;
  auto const entries = read_zip_directory(archive);
  for (auto const& entry : *entries) {
    if (entry.name != "document.json") files.push_back({entry.name, *unpack(entry)});
  }
  return write_zip(files);
}

Mask picture_of(test::Bytes const& archive, std::string const& name) {
  auto const entries = read_zip_directory(archive);
  auto const picture = read_picture(*unpack(*find_entry(*entries, name)));
  Mask mask(picture->width, picture->height);
  for (std::size_t i = 0; i < mask.values.size(); ++i) mask.values[i] = picture->values[i].r;
  return mask;
}

TEST(WriteMonsterMash, ReadingGivesBackEveryProjectExactly) {
  int written = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Rng rng(seed);
    Project project = {test::random_drawing(rng), Picture(7, 5, Colour{1, 2, 3, 4})};
    auto const archive = write_monster_mash(project);
    if (!archive) continue;  // no layers
    ++written;
    EXPECT_EQ(read_or_fail(*archive), project);
  }
  EXPECT_GT(written, 2);
}

TEST(WriteMonsterMash, WithoutOurDocumentTheShapesStay) {
  for (int const layers : {1, 3}) {
    auto drawing = character(layers);
    drawing.sketch.height_px = 1000;
    auto const again = read_or_fail(without_document(*write_monster_mash({drawing})));
    ASSERT_EQ(again.drawing.layers.size(), drawing.layers.size());
    for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
      // 1000 x 1000 lies on the 1000 x 800 of the file at 0.8, 100 px from the left.
      Drawing one = {drawing.sketch, {drawing.layers[i]}, {}};
      one.sketch.width_px = 1000;
      one.sketch.height_px = 800;
      for (auto& outline : one.layers[0].outlines) {
        for (auto& piece : outline.pieces) {
          for (auto& p : piece.curve.control) p = p * 0.8 + Vec2{100, 0};
        }
      }
      auto const expected = draw_mask(one);
      auto const found = draw_mask({again.drawing.sketch, {again.drawing.layers[i]}, {}});
      ASSERT_EQ(found.values.size(), expected.values.size());
      long long area_px = 0;
      long long wrong_px = 0;
      for (std::size_t k = 0; k < found.values.size(); ++k) {
        area_px += expected.values[k] != 0 ? 1 : 0;
        wrong_px += expected.values[k] != found.values[k] ? 1 : 0;
      }
      double perimeter_px = 0;
      for (auto const& outline : one.layers[0].outlines)
        perimeter_px += perimeter(flatten(outline, 0.1));
      EXPECT_LT(static_cast<double>(wrong_px), 0.5 * perimeter_px) << i;
      EXPECT_GT(area_px, 1000);
    }
  }
}

TEST(WriteMonsterMash, PicturesHoldNoValuesButThoseOfTheFormat) {
  auto const archive = *write_monster_mash({character(3), Picture(50, 100, Colour{9, 9, 9, 255})});
  std::vector<std::string> names;
  auto const entries = read_zip_directory(archive);
  for (auto const& entry : *entries) names.push_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{
                       "_org_000.png", "_seg_000.png", "_org_001.png", "_seg_001.png",
                       "_org_002.png", "_seg_002.png", "layers.txt", "cps.txt", "template.png",
                       "settings.txt", "document.json", "preview.png", "pictures/template.png"}));
  for (int i = 0; i < 3; ++i) {
    auto const outline = picture_of(archive, "_org_00" + std::to_string(i) + ".png");
    auto const region = picture_of(archive, "_seg_00" + std::to_string(i) + ".png");
    EXPECT_EQ(outline.width, 1000);
    EXPECT_EQ(outline.height, 800);
    for (std::size_t k = 0; k < outline.values.size(); ++k) {
      int const line = outline.values[k];
      int const inside = region.values[k];
      ASSERT_TRUE(line == 0 || line == 64 || line == 255);
      ASSERT_TRUE(inside == 0 || inside == 255);
      ASSERT_TRUE(line == 255 || inside == 255);  // the region holds its lines
    }
  }
  auto const picture = picture_of(archive, "template.png");
  EXPECT_EQ(picture.width, 1000);
  EXPECT_EQ(picture.at(500, 400), 9);
  EXPECT_EQ(picture.at(100, 400), 255);
  auto const layers = unpack(*find_entry(*entries, "layers.txt"));
  EXPECT_EQ(*layers, bytes_of("v. 230112\n3\n0\n1\n2\n\n3\n0\n1\n2\n"));
}

TEST(WriteMonsterMash, AHolesLineLiesOnTheHole) {
  auto const archive =
      *write_monster_mash({drawing_of({ring_layer("ring", {500, 500}, 100, 200)})});
  auto const outline = picture_of(archive, "_org_000.png");
  auto const region = picture_of(archive, "_seg_000.png");
  // From the middle to the right: the hole's last pixel is inked.
  int x = 500;
  while (region.at(x + 1, 400) == 0) ++x;
  EXPECT_EQ(outline.at(x, 400), 0);
  EXPECT_EQ(outline.at(x - 3, 400), 255);
}

TEST(WriteMonsterMash, OnlyWhatJoinsAnotherLayerIsOpen) {
  auto const count_open = [](std::vector<Layer> layers) {
    auto const archive = *write_monster_mash({drawing_of(std::move(layers))});
    auto const outline = picture_of(archive, "_org_001.png");
    return std::count(outline.values.begin(), outline.values.end(), 64);
  };
  auto const body = drawn_layer("body", ellipse_contour({500, 500}, 200, 200));
  auto const closing = RunKind::Closing;
  EXPECT_GT(count_open({body, limb_layer("arm", {600, 500}, {900, 500}, 40, closing)}), 100);
  EXPECT_EQ(count_open({body, limb_layer("arm", {750, 500}, {900, 500}, 40, closing)}), 0);
  EXPECT_GT(count_open({body, limb_layer("arm", {750, 500}, {900, 500}, 40, RunKind::HelpLine)}),
            100);
}

TEST(WriteMonsterMash, WhatItCannotHoldIsRefused) {
  EXPECT_EQ(write_monster_mash({}).error().code, ErrorCode::NothingThere);
  auto const disc = drawn_layer("disc", ellipse_contour({500, 500}, 20, 20));
  auto const many = drawing_of(std::vector<Layer>(256, disc));
  EXPECT_EQ(write_monster_mash({many}).error().code, ErrorCode::TooLarge);
}

TEST(WriteMonsterMash, HiddenLayersAreKeptButNotInThePictures) {
  Outline square;
  Vec2 const corners[] = {{100, 100}, {300, 100}, {300, 300}, {100, 300}};
  for (int i = 0; i < 4; ++i) {
    square.pieces.push_back({line_cubic(corners[i], corners[(i + 1) % 4])});
  }
  Project project;
  project.drawing.sketch.width_px = 1000;
  project.drawing.sketch.height_px = 800;
  project.drawing.layers = {
      {"seen", {square}, {}, {}}, {"hidden", {square}, {}, {}}, {"open", {}, {}, {}}};
  project.drawing.layers[1].is_hidden = true;
  auto const archive = write_monster_mash(project);
  ASSERT_TRUE(archive.has_value());
  EXPECT_EQ(read_or_fail(*archive), project);
  EXPECT_EQ(read_or_fail(without_document(*archive)).drawing.layers.size(), 1U);
  project.drawing.layers[0].is_hidden = true;
  EXPECT_EQ(write_monster_mash(project).error().code, ErrorCode::NothingThere);
}

}  // namespace
}  // namespace inkflate
