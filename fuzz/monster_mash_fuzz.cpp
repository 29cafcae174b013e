// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "base/check.h"
#include "geometry/crossings.h"
#include "io/read_monster_mash.h"
#include "io/write_monster_mash.h"
#include "io/write_png.h"
#include "io/write_zip.h"

namespace inkflate {
namespace {

/// An archive whose pictures are made of the bytes: mutations reach them, not the checksums around them.
std::vector<std::byte> archive_of(std::span<std::uint8_t const> data) {
  auto const take = [&] {
    auto const byte = data.empty() ? std::uint8_t{0} : data[0];
    data = data.subspan(data.empty() ? 0 : 1);
    return byte;
  };
  int const regions = 1 + take() % 3;
  int const width = 1 + take() % 64;
  int const height = 1 + take() % 64;
  auto const picture = [&](int w, int h) {
    Mask mask(w, h);
    // Runs of equal bytes: shapes, not only noise.
    std::uint8_t value = 255;
    int left = 0;
    for (auto& pixel : mask.values) {
      if (left-- <= 0) {
        value = take();
        left = take() % 32;
      }
      pixel = value;
    }
    return write_png(mask);
  };
  std::vector<ZipFile> files;
  for (int i = 0; i < regions; ++i) {
    auto const number = std::to_string(i);
    auto const missing = take();
    if (missing % 4 != 1) files.push_back({"_org_00" + number + ".png", picture(width, height)});
    if (missing % 4 != 2)
      files.push_back({"_seg_00" + number + ".png", picture(width, 1 + missing % 64)});
  }
  auto const rest = std::as_bytes(data);
  files.push_back({"layers.txt", {rest.begin(), rest.end()}});
  files.push_back({"settings.txt", {rest.begin(), rest.end()}});
  return write_zip(files);
}

void judge(std::span<std::byte const> archive) {
  auto const project = read_monster_mash(archive);
  if (!project) return;
  for (auto const& layer : project->drawing.layers) {
    std::vector<Contour> polygons;
    for (auto const& outline : layer.outlines) polygons.push_back(flatten(outline, 0.01));
    for (auto const& polygon : polygons) {
      CHECK(std::all_of(polygon.begin(), polygon.end(), [](Vec2 p) { return is_finite(p); }),
            "contours are finite");
    }
    bool const is_traced = layer.name.starts_with("region ");
    CHECK(!is_traced || find_crossings(polygons, 1).empty(), "traced contours are simple");
  }
  if (project->drawing.layers.size() > 4) return;  // for speed
  auto const written = write_monster_mash(*project);
  if (!written) return;
  auto const again = read_monster_mash(*written);
  CHECK(again.has_value() && *again == *project, "a written project reads as the same");
}

}  // namespace
}  // namespace inkflate

// Any archive ends in a project with simple contours or an error, and a project survives being written and read.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::span<std::uint8_t const> const input(data, size);
  bool const is_archive = size > 2 && data[0] == 'P' && data[1] == 'K';
  if (is_archive) {
    inkflate::judge(std::as_bytes(input));
  } else {
    inkflate::judge(inkflate::archive_of(input));
  }
  return 0;
}
