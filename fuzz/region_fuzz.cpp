// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bytes.h"
#include "mesh/mesh_region.h"
#include "mesh/rim_spacing.h"
#include "support/regions.h"

namespace {

using namespace inkflate;

/// How the bytes of a coordinate are meant.
enum class Coordinates {
  Byte,        // 256 x 256 places
  Lattice,     // 16 x 16 places: points coincide and lie on lines
  TinyFarOff,  // as Byte, but where doubles are coarse
  AnyFloat,    // nan, infinite and huge ones too
};

Vec2 read_place(Bytes& bytes, Coordinates coordinates) {
  if (coordinates == Coordinates::AnyFloat) {
    double const x = bytes.number();
    return {x, bytes.number()};
  }
  int const x = bytes.byte();
  int const y = bytes.byte();
  if (coordinates == Coordinates::Lattice)
    return {static_cast<double>(x % 16), static_cast<double>(y % 16)};
  Vec2 const place = {static_cast<double>(x), static_cast<double>(y)};
  return coordinates == Coordinates::Byte ? place : Vec2{-9e5, 7e5} + place * 2e-10;
}

Region read_region(Bytes& bytes, Coordinates coordinates) {
  Region region;
  while (!bytes.is_empty() && region.contours.size() + region.seams.size() < 6) {
    int const head = bytes.byte();
    std::vector<Vec2> line;
    for (int i = head / 2 % 32; i > 0; --i) line.push_back(read_place(bytes, coordinates));
    (head % 2 == 0 ? region.contours : region.seams).push_back(std::move(line));
  }
  return region;
}

/// The area's sum is only as exact as the coordinates are.
bool is_measurable(Region const& region) {
  double const area = std::abs(signed_area(region.contours[0]));
  for (auto const p : region.contours[0]) {
    if (squared_norm(p) > 1e4 * area) return false;
  }
  return true;
}

}  // namespace

// Any region with any options ends in a mesh for which all laws hold, or is refused; spacing is finite and above zero.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  Bytes bytes(data, size);
  MeshRegionOptions options;
  options.longest_px = 1 + bytes.byte() / 8.0;
  options.growth = 0.05 + bytes.byte() / 256.0;
  auto const coordinates = static_cast<Coordinates>(bytes.byte() % 4);
  // The same way through huge regions with fewer steps.
  if (coordinates == Coordinates::AnyFloat) options.longest_px *= 1e4;
  auto const region = read_region(bytes, coordinates);
  auto const mesh = mesh_region(region, options);
  if (!mesh) return mesh.error().code == ErrorCode::BadInput ? 0 : (std::abort(), 0);
  for (auto const& spacing : rim_spacing(region.contours)) {
    for (double const value : spacing) {
      if (!(value > 0 && value < 1e9)) std::abort();
    }
  }
  auto const wrong = what_is_wrong(region, *mesh);
  if (wrong.empty() || (wrong == "the area differs" && !is_measurable(region))) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
