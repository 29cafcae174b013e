// SPDX-License-Identifier: Apache-2.0
#include "image/trace_contour.h"

#include <algorithm>
#include <numeric>

namespace inkflate {
namespace {

struct Pixel {
  int x = 0;
  int y = 0;

  friend bool operator==(Pixel const&, Pixel const&) = default;
};

// Right, down, left, up: adding 1 turns right on the screen; then the four diagonals.
constexpr Pixel kSteps[8] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
enum Direction { Right, Down, Left, Up };

Pixel moved(Pixel p, int direction) {
  return {p.x + kSteps[direction].x, p.y + kSteps[direction].y};
}

/// Square tracing from a pixel of the piece that has been entered from a pixel that is not.
Contour walk_around(Grid2<int> const& labels, Pixel start, Direction entered) {
  int const label = labels.at(start.x, start.y);
  Contour walk;
  Pixel last = {-1, -1};
  Pixel pixel = start;
  int direction = entered;
  do {
    bool const is_piece = labels.contains(pixel.x, pixel.y) && labels.at(pixel.x, pixel.y) == label;
    if (is_piece && pixel != last) {
      walk.push_back({pixel.x + 0.5, pixel.y + 0.5});
      last = pixel;
    }
    direction = (direction + (is_piece ? 3 : 1)) % 4;
    pixel = moved(pixel, direction);
  } while (pixel != start || direction != entered);
  if (walk.size() > 1 && walk.back() == walk.front()) walk.pop_back();
  return walk;
}

std::vector<Pixel> first_pixels(Pieces const& pieces) {
  std::vector<Pixel> firsts(static_cast<std::size_t>(pieces.count));
  int seen = 0;
  for (int y = 0; y < pieces.labels.height && seen < pieces.count; ++y) {
    for (int x = 0; x < pieces.labels.width; ++x) {
      if (pieces.labels.at(x, y) == seen + 1) firsts[seen++] = {x, y};
    }
  }
  return firsts;
}

/// Per label whether the piece reaches the rim of the picture.
std::vector<bool> labels_on_rim(Pieces const& pieces) {
  auto const& labels = pieces.labels;
  std::vector<bool> on_rim(static_cast<std::size_t>(pieces.count) + 1, false);
  for (int x = 0; x < labels.width; ++x) {
    on_rim[labels.at(x, 0)] = true;
    on_rim[labels.at(x, labels.height - 1)] = true;
  }
  for (int y = 0; y < labels.height; ++y) {
    on_rim[labels.at(0, y)] = true;
    on_rim[labels.at(labels.width - 1, y)] = true;
  }
  return on_rim;
}

}  // namespace

Pieces label_pieces(Mask const& mask, Neighbours neighbours) {
  int const step_count = neighbours == Neighbours::Four ? 4 : 8;
  Pieces pieces{Grid2<int>(mask.width, mask.height), 0};
  std::vector<Pixel> pending;
  auto const visit = [&](Pixel p) {
    if (!mask.contains(p.x, p.y) || mask.at(p.x, p.y) == 0) return;
    if (pieces.labels.at(p.x, p.y) != 0) return;
    pieces.labels.at(p.x, p.y) = pieces.count;
    pending.push_back(p);
  };
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) == 0 || pieces.labels.at(x, y) != 0) continue;
      ++pieces.count;
      visit({x, y});
      while (!pending.empty()) {
        auto const p = pending.back();
        pending.pop_back();
        for (int direction = 0; direction < step_count; ++direction) visit(moved(p, direction));
      }
    }
  }
  return pieces;
}

std::vector<TracedPiece> trace_contours(Mask const& mask) {
  std::vector<TracedPiece> traced;
  if (mask.values.empty()) return traced;
  auto const pieces = label_pieces(mask, Neighbours::Four);
  for (auto const first : first_pixels(pieces)) {
    traced.push_back({walk_around(pieces.labels, first, Right), {}});
  }
  Mask background = mask;
  for (auto& value : background.values) value = value == 0 ? 255 : 0;
  auto const gaps = label_pieces(background, Neighbours::Eight);
  auto const is_outside = labels_on_rim(gaps);
  auto const firsts = first_pixels(gaps);
  for (int i = 0; i < gaps.count; ++i) {
    if (is_outside[i + 1]) continue;
    // Above the first pixel of a hole is the piece around it.
    auto const above = moved(firsts[i], Up);
    traced[pieces.labels.at(above.x, above.y) - 1].holes.push_back(
        walk_around(pieces.labels, above, Up));
  }
  return traced;
}

std::vector<Contour> simple_loops(Contour const& walk) {
  // Equal points get equal numbers.
  auto const is_before = [&](int a, int b) {
    return walk[a].y != walk[b].y ? walk[a].y < walk[b].y : walk[a].x < walk[b].x;
  };
  std::vector<int> order(walk.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), is_before);
  std::vector<int> number(walk.size());
  int count = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && is_before(order[i - 1], order[i])) ++count;
    number[order[i]] = count;
  }

  std::vector<Contour> loops;
  std::vector<int> open;                       // indices into the walk: distinct points
  std::vector<int> position(walk.size(), -1);  // by number: where it is in `open`
  auto const close_at = [&](int first) {
    Contour loop;
    for (auto i = static_cast<std::size_t>(first); i < open.size(); ++i) {
      loop.push_back(walk[open[i]]);
      position[number[open[i]]] = -1;
    }
    open.resize(static_cast<std::size_t>(first));
    if (signed_area(loop) != 0) loops.push_back(std::move(loop));
  };
  for (int i = 0; i < std::ssize(walk); ++i) {
    if (position[number[i]] >= 0) close_at(position[number[i]]);
    position[number[i]] = static_cast<int>(std::ssize(open));
    open.push_back(i);
  }
  close_at(0);
  return loops;
}

}  // namespace inkflate
