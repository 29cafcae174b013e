// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bytes.h"
#include "simplify/simplify.h"
#include "support/sketches.h"

namespace {

using namespace inkflate;

// More samples take the same way, only longer.
constexpr int kMostSamples = 60;

/// How the bytes of a coordinate are meant.
enum class Coordinates {
  AnyFloat,    // nan, infinite and huge ones too
  CoarseGrid,  // 16 x 16 places: samples coincide, lines overlap and cross in samples
  Byte,        // 256 x 256 places
  TinyFarOff,  // as Byte, but small and far from the origin, where doubles are coarse
};

Vec2 read_place(Bytes& bytes, Coordinates coordinates) {
  if (coordinates == Coordinates::AnyFloat) {
    double const x = bytes.number();
    return {x, bytes.number()};
  }
  if (coordinates == Coordinates::CoarseGrid) {
    int const both = bytes.byte();
    int const row = both / 16;
    return Vec2{static_cast<double>(both % 16), static_cast<double>(row)} * 60;
  }
  double const x = bytes.byte();
  Vec2 const place = {x, static_cast<double>(bytes.byte())};
  if (coordinates == Coordinates::Byte) return place * 4;
  return Vec2{-9e5, 7e5} + place * 5e-5;
}

std::vector<Vec2> read_marks(Bytes& bytes, Coordinates coordinates) {
  std::vector<Vec2> marks;
  for (int i = bytes.below(3); i > 0; --i) marks.push_back(read_place(bytes, coordinates));
  return marks;
}

SimplifyOptions read_options(Bytes& bytes, Coordinates coordinates) {
  SimplifyOptions options;
  int const gap = bytes.byte();
  if (gap == 255) options.gap_px = bytes.number();
  if (gap > 200 && gap < 255) options.gap_px = 2.0 * (gap - 200);
  options.outside = read_marks(bytes, coordinates);
  options.inside = read_marks(bytes, coordinates);
  options.holes = static_cast<Holes>(bytes.below(2));
  options.parts = static_cast<Parts>(bytes.below(3));
  options.smooth = bytes.share();
  return options;
}

Sketch read_strokes(Bytes& bytes, Coordinates coordinates) {
  Sketch sketch = {1000, 1000, {StrokeGroup{"a"}, StrokeGroup{"b"}}, {}};
  for (int i = 0; i < kMostSamples && !bytes.is_empty(); ++i) {
    // One sample in eight or so begins a stroke; the byte also says what the stroke is.
    int const head = bytes.byte();
    if (head < 32 || sketch.strokes.empty()) {
      Stroke stroke;
      stroke.kind = head % 4 == 3 ? StrokeKind::HelpLine : StrokeKind::Ink;
      stroke.group = head / 4 % 3 - 1;
      if (head % 16 == 9) stroke.colour = {0xc0, 0xc8, 0xd0};
      sketch.strokes.push_back(stroke);
    }
    sketch.strokes.back().samples.push_back({read_place(bytes, coordinates), 1});
  }
  return sketch;
}

bool is_fair_refusal(Error const& error) {
  return error.code == ErrorCode::BadInput || error.code == ErrorCode::BadOption ||
         error.code == ErrorCode::NothingThere;
}

}  // namespace

// Any strokes with any options end in a valid drawing or a fair refusal.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  Bytes bytes(data, size);
  auto const coordinates = static_cast<Coordinates>(bytes.below(4));
  auto const options = read_options(bytes, coordinates);
  auto const drawing = simplify(read_strokes(bytes, coordinates), options);
  std::string wrong;
  if (drawing) {
    wrong = what_is_wrong(*drawing);
  } else if (!is_fair_refusal(drawing.error())) {
    wrong = "refused: " + drawing.error().message;
  }
  if (!wrong.empty()) {
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
  }
  return 0;
}
