// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/write_draw_list.h"

#include <span>

#include "io/put_bytes.h"

namespace inkflate::web {
namespace {

enum class ItemCode : std::uint32_t { Fill, Stroke, Dots, Picture };

class ItemWriter {
 public:
  explicit ItemWriter(std::vector<std::byte>& bytes) : bytes_(bytes) {}

  void operator()(FilledPath const& path) {
    put(ItemCode::Fill);
    put(packed(path.colour));
    put(path.contours.size());
    for (auto const& contour : path.contours) {
      put(contour.size());
      put(contour);
    }
  }

  void operator()(StrokedPolyline const& line) {
    put(ItemCode::Stroke);
    put(packed(line.colour));
    put(line.points.size());
    put(line.widths_px.size());
    put(line.dashes_px.size());
    put_float32(bytes_, line.limits.least_px);
    put_float32(bytes_, line.limits.most_px);
    put(line.points);
    put(line.widths_px);
    put(line.dashes_px);
  }

  void operator()(Dots const& dots) {
    put(ItemCode::Dots);
    put(packed(dots.colour));
    put(dots.centres.size());
    put_float32(bytes_, dots.diameter_px);
    put(dots.centres);
  }

  void operator()(DrawnPicture const& drawn) {
    if (!drawn.picture) return;
    auto const& [a, b, c, d, e, f] = drawn.map;
    put(ItemCode::Picture);
    put_float32(bytes_, drawn.opacity);
    put(static_cast<std::size_t>(drawn.picture->width));
    put(static_cast<std::size_t>(drawn.picture->height));
    for (double const number : {a, b, c, d, e, f}) put_float32(bytes_, number);
    auto const pixels = std::as_bytes(std::span(drawn.picture->values));
    bytes_.insert(bytes_.end(), pixels.begin(), pixels.end());
  }

 private:
  void put(std::uint32_t word) { put_little_endian32(bytes_, word); }
  void put(ItemCode code) { put(static_cast<std::uint32_t>(code)); }
  void put(std::size_t count) { put(static_cast<std::uint32_t>(count)); }
  void put(std::vector<double> const& numbers) {
    for (double const number : numbers) put_float32(bytes_, number);
  }
  void put(std::vector<Vec2> const& points) {
    for (auto const p : points) {
      put_float32(bytes_, p.x);
      put_float32(bytes_, p.y);
    }
  }

  std::vector<std::byte>& bytes_;
};

}  // namespace

std::uint32_t packed(Colour colour) {
  return colour.r | static_cast<std::uint32_t>(colour.g) << 8U |
         static_cast<std::uint32_t>(colour.b) << 16U | static_cast<std::uint32_t>(colour.a) << 24U;
}

void write_draw_list(DrawList const& list, std::vector<std::byte>& bytes) {
  ItemWriter writer(bytes);
  for (auto const& item : list) std::visit(writer, item);
}

}  // namespace inkflate::web
