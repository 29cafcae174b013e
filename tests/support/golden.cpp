// SPDX-License-Identifier: Apache-2.0
#include "support/golden.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

#include "io/read_picture.h"
#include "io/write_png.h"

namespace inkflate {
namespace {

namespace fs = std::filesystem;

fs::path const kSource = INKFLATE_SOURCE_DIR;

std::optional<Picture> read_png(fs::path const& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> const chars((std::istreambuf_iterator<char>(file)),
                                std::istreambuf_iterator<char>());
  auto const picture = read_picture(std::as_bytes(std::span(chars)));
  return picture ? std::optional(*picture) : std::nullopt;
}

void put_png(fs::path const& path, Picture const& picture) {
  fs::create_directories(path.parent_path());
  auto const bytes = write_png(picture);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<char const*>(bytes.data()), std::ssize(bytes));
}

int difference(Colour a, Colour b) {
  return std::max(
      {std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

struct Differences {
  Picture map;  // white where they are the same, black where they differ too much
  int count = 0;
};

Differences compare(Picture const& a, Picture const& b, int tolerance) {
  Differences result = {Picture(a.width, a.height, {255, 255, 255}), 0};
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    int const found = difference(a.values[i], b.values[i]);
    auto const grey = static_cast<std::uint8_t>(found > tolerance ? 0 : 255 - 2 * found);
    result.map.values[i] = {grey, grey, grey};
    result.count += found > tolerance ? 1 : 0;
  }
  return result;
}

}  // namespace

testing::AssertionResult matches_golden(Picture const& picture, std::string const& name,
                                        GoldenTolerance const& tolerance) {
  auto const golden_path = kSource / "tests/golden" / (name + ".png");
  auto const folder = kSource / "build/golden";
  if (char const* const update = std::getenv("INKFLATE_UPDATE_GOLDEN");
      update != nullptr && std::string(update) == "1") {
    put_png(golden_path, picture);
    return testing::AssertionSuccess();
  }
  auto const golden = read_png(golden_path);
  bool const is_same_size =
      golden && golden->width == picture.width && golden->height == picture.height;
  if (!is_same_size) {
    put_png(folder / (name + ".png"), picture);
    return testing::AssertionFailure()
           << golden_path << " is missing or of another size than " << picture.width << " x "
           << picture.height << "; the picture is in " << folder;
  }
  auto const found = compare(picture, *golden, tolerance.channel);
  if (found.count <= tolerance.share * static_cast<double>(picture.values.size())) {
    return testing::AssertionSuccess();
  }
  put_png(folder / (name + ".png"), picture);
  put_png(folder / (name + "-difference.png"), found.map);
  return testing::AssertionFailure() << name << ": " << found.count << " pixels differ from "
                                     << golden_path << "; see " << folder;
}

}  // namespace inkflate
