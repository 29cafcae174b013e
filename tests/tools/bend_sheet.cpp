// SPDX-License-Identifier: Apache-2.0
// bend_sheet OUT.png COLUMNS RECORDING.jsonl...: what recordings bend, up to each of their pictures: before with the ways of the hand, bent as a
// body, and bent as a wire.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "cli/read_events.h"
#include "editor/engine.h"
#include "io/write_png.h"
#include "render/draw_drawing.h"
#include "render/palette.h"
#include "render/rasterise.h"

namespace {

using namespace inkflate;

// Canvases are 1000 x 800 px; parts may be bent beyond them.
constexpr double kScale = 0.3;
constexpr Rect kCanvas = {{-20, -20}, {1020, 860}};
constexpr double kBetweenPx = 20;
// Of the drawing's px.
constexpr double kOutlinePx = 6;
constexpr double kWayPx = 6;
constexpr double kArrowPx = 24;
constexpr double kPinPx = 22;
constexpr double kHaloPx = 32;
// A hand that moves gives the program one frame; where it rests, all the time that it wants.
constexpr int kAllWork = 10'000;
// Less is a click.
constexpr double kDragPx = 5;

/// What was bent up to a picture.
struct Bending {
  Drawing before;
  Drawing after;
  std::vector<Polyline> ways;  // of the hand
};

/// Plays a recording and watches the hand.
class Watcher {
 public:
  explicit Watcher(char const* mode) { handle(ActionEvent{"bend_mode", mode}, kAllWork); }

  void take(cli::RecordedStep const& step) {
    if (auto const* event = std::get_if<Event>(&step)) {
      auto const* const pointer = std::get_if<PointerEvent>(event);
      if (pointer != nullptr) watch(*pointer);
      bool const is_move = pointer != nullptr && pointer->action == PointerAction::Move;
      handle(*event, is_move ? 1 : kAllWork);
    } else if (std::holds_alternative<cli::PictureStep>(step) && !bending_.ways.empty()) {
      bending_.after = to_project(engine_.document()).drawing;
      bendings.push_back(std::exchange(bending_, {}));
    }
  }

  std::vector<Bending> bendings;

 private:
  void handle(Event const& event, int frames) {
    engine_.handle(event);
    for (int i = 0; i < frames && engine_.has_work(); ++i) engine_.work();
  }

  void watch(PointerEvent const& pointer) {
    auto const view = engine_.state().view;
    if (view.tool != Tool::Deform) return;
    if (pointer.action == PointerAction::Press) way_.clear();
    way_.push_back(to_canvas(view.camera, view.size, pointer.screen));
    bool const is_drag = distance(way_.front(), way_.back()) > kDragPx;
    if (pointer.action != PointerAction::Release || !is_drag) return;
    if (bending_.ways.empty()) bending_.before = to_project(engine_.history().document()).drawing;
    bending_.ways.push_back(way_);
  }

  Engine engine_;
  Bending bending_;
  Polyline way_;
};

void add_line(DrawList& list, Polyline points, double width_px, Colour colour) {
  list.push_back(StrokedPolyline{std::move(points), {width_px}, {}, colour});
}

void add_way(DrawList& list, Polyline const& way) {
  auto const tip = way.back();
  auto tail = way.front();
  for (auto const p : way) {
    if (distance(p, tip) >= kArrowPx) tail = p;
  }
  auto const back = (tail - tip) * (kArrowPx / std::max(distance(tail, tip), 1.0));
  Vec2 const side = {-back.y / 2, back.x / 2};
  for (auto const& [width_px, colour] :
       {std::pair{kWayPx + 6, palette::kHalo}, std::pair{kWayPx, palette::kSelection}}) {
    add_line(list, way, width_px, colour);
    add_line(list, {tip + back + side, tip, tip + back - side}, width_px, colour);
  }
}

void add_pins(DrawList& list, Drawing const& drawing) {
  for (auto const& layer : drawing.layers) {
    for (auto const& pin : layer.bend_pins) {
      list.push_back(Dots{{pin.position}, kHaloPx, palette::kHalo});
      list.push_back(Dots{{pin.position}, kPinPx, palette::kSelection});
    }
  }
}

DrawList picture_of(Drawing const& drawing) {
  auto list = draw_drawing(drawing, {.line_width_px = kOutlinePx});
  add_pins(list, drawing);
  return list;
}

int usage() {
  std::fprintf(stderr, "usage: bend_sheet OUT.png COLUMNS RECORDING.jsonl...\n");
  return 2;
}

std::vector<Bending> bendings_of(std::vector<cli::RecordedEvent> const& events, char const* mode) {
  Watcher watcher(mode);
  for (auto const& event : events) watcher.take(event.step);
  return std::move(watcher.bendings);
}

std::string content_of(char const* path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Three pictures for each bending.
bool add_cells(std::vector<DrawList>& cells, char const* path) {
  auto const events = cli::read_events(content_of(path));
  if (!events) {
    std::fprintf(stderr, "%s: %s\n", path, events.error().message.c_str());
    return false;
  }
  auto const bodies = bendings_of(*events, "body");
  auto const wires = bendings_of(*events, "wire");
  for (std::size_t i = 0; i < std::min(bodies.size(), wires.size()); ++i) {
    auto before = picture_of(bodies[i].before);
    for (auto const& way : bodies[i].ways) add_way(before, way);
    cells.push_back(std::move(before));
    cells.push_back(picture_of(bodies[i].after));
    cells.push_back(picture_of(wires[i].after));
  }
  return bodies.size() == wires.size() && !bodies.empty();
}

}  // namespace

int main(int count, char** arguments) {
  int const columns = count > 3 ? std::atoi(arguments[2]) : 0;
  if (columns < 1) return usage();
  std::vector<DrawList> cells;
  bool is_done = true;
  for (int i = 3; i < count; ++i) is_done = add_cells(cells, arguments[i]) && is_done;
  double const wide_px = kCanvas.width() * kScale;
  double const high_px = kCanvas.height() * kScale + kBetweenPx;
  double const row_px = 3 * wide_px + kBetweenPx;
  DrawList sheet;
  for (int i = 0; i < std::ssize(cells); ++i) {
    int const row = i / 3;
    Vec2 const corner = {kBetweenPx + row % columns * row_px + i % 3 * wide_px,
                         kBetweenPx + row / columns * high_px};
    append(sheet, place(std::move(cells[i]), Affine::translation(corner) *
                                                 Affine::scaling(kScale, kScale) *
                                                 Affine::translation(-kCanvas.min)));
  }
  int const rows = static_cast<int>(std::ssize(cells)) / 3;
  auto const picture = rasterise(
      sheet, static_cast<int>(kBetweenPx + columns * row_px),
      static_cast<int>(kBetweenPx + (rows + columns - 1) / columns * high_px), palette::kPaper);
  auto const png = write_png(picture);
  std::ofstream file(arguments[1], std::ios::binary);
  file.write(reinterpret_cast<char const*>(png.data()), std::ssize(png));
  return is_done && file.flush().good() ? 0 : 1;
}
