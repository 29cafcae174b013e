// SPDX-License-Identifier: Apache-2.0
// bend_strip OUT.png [IN.svg]: the thesis' strip (section 4.2) along the longest stroke of a drawing, or along a circle, before and
// after two places were held and a third was dragged aside.
#include <algorithm>

#include "deform/wire_solver.h"
#include "deform/wire_strip.h"
#include "geometry/trig.h"
#include "io/write_png.h"
#include "mesh/rim_spacing.h"
#include "pipeline/place_sketch.h"
#include "render/rasterise.h"
#include "sketch_files.h"

namespace {

using namespace inkflate;

constexpr int kPicturePx = 1000;
constexpr int kPoints = 150;
constexpr int kIterations = 500;

Stroke circle() {
  Stroke stroke;
  for (int i = 0; i <= 400; ++i) {
    auto const [sin, cos] = sin_cos(2 * kPi * (i % 400) / 400);
    stroke.samples.push_back({{cos, sin}});
  }
  return stroke;
}

/// In the middle of the picture.
Result<Polyline> longest_line(std::vector<Stroke> const& strokes) {
  auto const is_shorter = [](Stroke const& a, Stroke const& b) {
    return length(line_of(a)) < length(line_of(b));
  };
  auto const longest = std::max_element(strokes.begin(), strokes.end(), is_shorter);
  if (longest == strokes.end() || length(line_of(*longest)) == 0)
    return Error{ErrorCode::NothingThere, "There is no line to bend."};
  auto const placed = place_sketch({1, 1, {}, {*longest}}, {kPicturePx / 2, PlaceMode::FitStrokes});
  if (!placed) return placed.error();
  auto line = line_of(placed->strokes[0]);
  for (auto& point : line) point += Vec2{kPicturePx, kPicturePx} / 4;
  return line;
}

BendMesh strip_along(Polyline line) {
  line = resample(line, std::vector<double>(line.size(), length(line) / kPoints));
  bool const is_closed = line.front() == line.back();
  if (is_closed) line.pop_back();
  return is_closed ? wire_strip(std::span(&line, 1), 0) : open_wire_strip(std::span(&line, 1), 0);
}

/// A place of the line, so far along it, moved by this.
BendHandle handle(BendMesh const& strip, double share, Vec2 by) {
  auto const& vertices = strip.lines[0].vertices;
  // Triangle i has point i of the line as its first corner.
  int const i = static_cast<int>(share * static_cast<double>(vertices.size() - 2));
  return {{i, {1, 0, 0}}, strip.rest.points[vertices[i]] + by};
}

void draw(BendMesh const& strip, BendPose const& pose, Colour colour, DrawList& list) {
  for (auto const& [a, b, c] : strip.rest.triangles)
    list.push_back(StrokedPolyline{{pose[a], pose[b], pose[c], pose[a]}, {0.5}, {}, colour});
  Polyline line;
  for (int const v : strip.lines[0].vertices) line.push_back(pose[v]);
  if (strip.lines[0].is_closed) line.push_back(line.front());
  list.push_back(StrokedPolyline{line, {2}, {}, colour});
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2 && count != 3) return fail("usage: bend_strip OUT.png [IN.svg]");
  auto const sketch = count == 3 ? read_sketch(arguments[2]) : Sketch{1, 1, {}, {circle()}};
  if (!sketch) return fail(sketch.error().message);
  auto const line = longest_line(sketch->strokes);
  if (!line) return fail(line.error().message);
  auto const strip = strip_along(*line);
  Vec2 const aside = Vec2{1, 1} * (length(*line) / 10);
  std::vector<BendHandle> const handles = {handle(strip, 0, {}), handle(strip, 0.5, {}),
                                           handle(strip, 0.25, aside)};
  auto pose = strip.rest.points;
  WireSolver(strip).step(pose, {handles, {}}, kIterations);
  DrawList list;
  draw(strip, strip.rest.points, {190, 190, 190}, list);
  draw(strip, pose, {20, 20, 20}, list);
  for (auto const& held : handles) list.push_back(Dots{{held.target}, 10, {220, 40, 30}});
  auto const picture = rasterise(list, kPicturePx, kPicturePx, {255, 255, 255});
  if (!write_bytes(arguments[1], write_png(picture))) return fail("The picture cannot be written.");
  return 0;
}
