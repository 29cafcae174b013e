// SPDX-License-Identifier: Apache-2.0
// random_bends [--count N] [--seed S] FILE_OR_FOLDER...: bends the parts of drawings at random and prints what became of them: how many
// triangles turned over, how far handles are from their targets, how far the shape is from where it would come to rest; and, for
// drags of 200 px against one pin, how often one side of a limb crosses the other and how much the shape suffers, body and wire side
// by side. Drawings are brought to 1000 px.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/rng.h"
#include "deform/bender.h"
#include "geometry/crossings.h"
#include "geometry/trig.h"
#include "io/read_document.h"
#include "pipeline/bend_hook.h"
#include "pipeline/run_simplify.h"

namespace {

using namespace inkflate;

constexpr double kCanvasPx = 1000;
constexpr double kLimbPx = 130;  // sides of one limb are nearer than this at rest
constexpr int kFrames = 20;
constexpr int kStepsOfFrame = 2;     // of the body
constexpr int kWireIterations = 10;  // of a frame
constexpr int kStepsToRest = 60;     // a drag is finished with at most so many
constexpr int kStepsToMinimum = 200;

/// The parts of a file that are large enough to be bent.
std::vector<BendShape> shapes_of(std::filesystem::path const& path) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> const content{std::istreambuf_iterator<char>(stream), {}};
  auto const document = read_document(std::as_bytes(std::span(content)));
  if (!document) return {};
  SketchSource source = document->project.drawing.sketch;
  if (document->scan) source = *document->scan;
  RunSimplifyOptions options;
  options.place = {kCanvasPx, PlaceMode::FitStrokes};
  options.simplify.parts = Parts::Groups;
  auto const drawing = run_simplify(source, options);
  std::vector<BendShape> shapes;
  if (!drawing) return shapes;
  for (auto const& layer : drawing->layers) {
    auto const box = bounds(flatten(layer.outlines.front(), 1));
    if (box.longer_side() > 2 * kLimbPx) shapes.push_back({layer.outlines, {}});
  }
  return shapes;
}

/// One drag: some pins and a place that goes somewhere.
struct Drag {
  std::vector<Vec2> pins;
  Vec2 from;
  Vec2 to;
};

Vec2 random_place(BendMesh const& mesh, Rng& rng) {
  auto const& line = mesh.lines[0].vertices;
  return mesh.rest.points[line[rng.below(static_cast<int>(std::ssize(line)))]];
}

Drag random_drag(BendMesh const& mesh, int pins, double length_px, Rng& rng) {
  Drag drag;
  for (int i = 0; i < pins; ++i) {
    bool const is_twin = i > 0 && rng.below(10) == 0;
    drag.pins.push_back(is_twin ? drag.pins.back() : random_place(mesh, rng));
  }
  drag.from = random_place(mesh, rng);
  auto const turn = sin_cos(rng.uniform(-kPi, kPi));
  drag.to = drag.from + Vec2{turn.cos, turn.sin} * length_px;
  return drag;
}

std::vector<BendHandle> handles_of(Bender const& bender, Drag const& drag, double share) {
  std::vector<BendHandle> handles;
  for (auto const pin : drag.pins) {
    handles.push_back({bender.nearest(bender.rest_pose(), pin), pin, {}});
  }
  auto const to = lerp(drag.from, drag.to, share);
  handles.push_back({bender.nearest(bender.rest_pose(), drag.from), to, {}});
  return handles;
}

/// Frame after frame, as a hand drags, then until it rests.
BendPose dragged(Bender& bender, Drag const& drag, BendMode mode) {
  auto pose = bender.rest_pose();
  int const steps = mode == BendMode::Body ? kStepsOfFrame : kWireIterations;
  for (int frame = 1; frame <= kFrames; ++frame) {
    auto const handles = handles_of(bender, drag, static_cast<double>(frame) / kFrames);
    bender.step(pose, {handles, {}}, steps);
  }
  auto const handles = handles_of(bender, drag, 1);
  // The wire gets what the thesis gives it after a drag: five frames more.
  bender.step(pose, {handles, {}}, mode == BendMode::Body ? kStepsToRest : 5 * kWireIterations);
  return pose;
}

double farthest(BendPose const& a, BendPose const& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(a[i], b[i]));
  return most;
}

int turned_triangles(BendMesh const& mesh, BendPose const& pose) {
  int count = 0;
  for (auto const& [a, b, c] : mesh.rest.triangles) {
    count += cross(pose[b] - pose[a], pose[c] - pose[a]) > 0 ? 0 : 1;
  }
  return count;
}

bool is_finite_pose(BendPose const& pose) {
  return std::all_of(pose.begin(), pose.end(), [](Vec2 p) { return is_finite(p); });
}

Contour contour_of(BendMesh const& mesh, std::vector<Vec2> const& pose) {
  Contour contour;
  for (int const v : mesh.lines[0].vertices) contour.push_back(pose[v]);
  return contour;
}

/// Whether two stretches of the outer contour that lie near one another at rest cross.
bool has_limb_crossing(BendMesh const& mesh, BendPose const& pose) {
  std::vector<Contour> const contours = {contour_of(mesh, pose)};
  auto const rest = contour_of(mesh, mesh.rest.points);
  auto const crossings = find_crossings(contours, 1000);
  return std::any_of(crossings.begin(), crossings.end(), [&](Crossing const& crossing) {
    return distance(rest[crossing.edge_a], rest[crossing.edge_b]) < kLimbPx;
  });
}

/// How far the contour is from a rigid motion of its parts, which are what lies in one cell of a grid of 2 limbs at rest; mean, px.
double shape_error_px(BendMesh const& mesh, BendPose const& pose) {
  auto const rest = contour_of(mesh, mesh.rest.points);
  auto const bent = contour_of(mesh, pose);
  std::map<std::pair<int, int>, std::pair<std::vector<Vec2>, std::vector<Vec2>>> cells;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    auto& [before, after] = cells[{static_cast<int>(std::floor(rest[i].x / (2 * kLimbPx))),
                                   static_cast<int>(std::floor(rest[i].y / (2 * kLimbPx)))}];
    before.push_back(rest[i]);
    after.push_back(bent[i]);
  }
  double sum = 0;
  for (auto const& [cell, points] : cells) {
    auto const motion = best_motion(points.first, points.second);
    for (std::size_t i = 0; i < points.first.size(); ++i) {
      sum += distance(motion(points.first[i]), points.second[i]);
    }
  }
  return sum / static_cast<double>(rest.size());
}

/// What is sorted last but one in a hundred, and the largest.
void print_spread(char const* what, std::vector<double> values) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  std::printf("%-36s median %8.4f  99 %% %8.4f  most %8.4f px\n", what, values[values.size() / 2],
              values[values.size() * 99 / 100], values.back());
}

void bend_anyhow(std::vector<BendShape> const& shapes, int count, Rng& rng) {
  int turned = 0;
  int unbounded = 0;
  std::vector<double> residuals;
  std::vector<double> ways;
  for (int i = 0; i < count; ++i) {
    auto bender = Bender::make(shapes[rng.below(static_cast<int>(std::ssize(shapes)))]);
    if (!bender) continue;
    bool const is_far = rng.below(20) == 0;
    auto const drag =
        random_drag(bender->mesh(), 1 + rng.below(5), is_far ? 5000 : rng.uniform(0, 400), rng);
    auto pose = dragged(*bender, drag, BendMode::Body);
    turned += turned_triangles(bender->mesh(), pose) > 0 ? 1 : 0;
    unbounded += is_finite_pose(pose) ? 0 : 1;
    if (is_far) continue;
    auto const handles = handles_of(*bender, drag, 1);
    double most = 0;
    for (auto const& handle : handles) {
      auto const place = place_of(bender->mesh().rest, pose, handle.anchor);
      most = std::max(most, distance(place, handle.target));
    }
    // Pins at one place and a handle beside them cannot all be met: the wish itself is in the way.
    residuals.push_back(most);
    auto minimum = pose;
    bender->step(minimum, {handles, {}}, kStepsToMinimum);
    ways.push_back(farthest(pose, minimum));
  }
  std::printf("%d drags of up to 400 px, one in 20 of 5000 px, 1 to 5 pins\n", count);
  std::printf("with turned triangles %d, not finite %d\n", turned, unbounded);
  print_spread("handle to target", residuals);
  print_spread("to the minimum after the drag", ways);
}

void compare(std::vector<BendShape> const& shapes, int count, std::uint64_t seed) {
  std::printf("%d drags of 200 px, one pin\n", count);
  for (auto const mode : {BendMode::Body, BendMode::Wire}) {
    Rng rng(seed);
    int crossed = 0;
    double error_px = 0;
    for (int i = 0; i < count; ++i) {
      BendOptions options;
      options.mode = mode;
      auto bender = Bender::make(shapes[rng.below(static_cast<int>(std::ssize(shapes)))], options);
      if (!bender) continue;
      auto const drag = random_drag(bender->mesh(), 1, 200, rng);
      auto const pose = dragged(*bender, drag, mode);
      crossed += has_limb_crossing(bender->mesh(), pose) ? 1 : 0;
      error_px += shape_error_px(bender->mesh(), pose);
    }
    std::printf("%s  same-limb crossings %5.1f %%  shape error %6.2f px\n",
                mode == BendMode::Body ? "body" : "wire", 100.0 * crossed / count,
                error_px / count);
  }
}

}  // namespace

int main(int count, char** arguments) {
  int drags = 1000;
  std::uint64_t seed = 1;
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < count; ++i) {
    std::string const word = arguments[i];
    if (word == "--count" && i + 1 < count) {
      drags = std::max(1, std::atoi(arguments[++i]));
    } else if (word == "--seed" && i + 1 < count) {
      seed = std::strtoull(arguments[++i], nullptr, 10);
    } else if (std::filesystem::is_directory(word)) {
      for (auto const& entry : std::filesystem::directory_iterator(word)) {
        auto const ending = entry.path().extension();
        if (ending == ".svg" || ending == ".scap") files.push_back(entry.path());
      }
    } else {
      files.emplace_back(word);
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<BendShape> shapes;
  for (auto const& file : files) {
    for (auto& shape : shapes_of(file)) shapes.push_back(std::move(shape));
  }
  std::printf("%zu parts of %zu files\n", shapes.size(), files.size());
  if (shapes.empty()) return 1;
  Rng rng(seed);
  bend_anyhow(shapes, drags, rng);
  compare(shapes, std::max(1, drags / 5), seed);
  return 0;
}
