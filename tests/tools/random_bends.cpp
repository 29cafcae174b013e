// SPDX-License-Identifier: Apache-2.0
// random_bends [--count N] [--figures N] [--seed S] FILE_OR_FOLDER...: bends the parts of drawings at random, as the tool Deform does, and
// prints what became of them: how many triangles turned over, how far handles are from their targets, how far the shape is from where it
// would come to rest, how long letting go takes, and the drags that were worst: each is drag 1 of --count 1 --seed ITS_SEED. Then, on one
// figure, how often its contour crosses itself and how much its parts suffer, body and wire side by side, without and with the tool's
// grip. Drawings are brought to 1000 px.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "figure_drag.h"
#include "geometry/polyline.h"
#include "io/read_document.h"
#include "pipeline/run_simplify.h"
#include "tools/random_drag.h"

namespace {

using namespace inkflate;

constexpr double kCanvasPx = 1000;
constexpr double kLeastPartPx = 260;
constexpr int kStepsToMinimum = 200;
constexpr int kFigurePoints = 400;

/// A part that is large enough to be bent.
struct NamedPart {
  std::string name;
  std::vector<Outline> outlines;
};

std::vector<NamedPart> parts_of(std::filesystem::path const& path) {
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
  std::vector<NamedPart> parts;
  if (!drawing) return parts;
  for (auto const& layer : drawing->layers) {
    auto const box = bounds(flatten(layer.outlines.front(), 1));
    if (box.longer_side() <= kLeastPartPx) continue;
    NamedPart part = {path.filename().string() + " " + layer.name, layer.outlines};
    for (auto& outline : part.outlines) outline.sources.clear();
    parts.push_back(std::move(part));
  }
  return parts;
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

/// One value of each drag, and which drag it is of.
class Spread {
 public:
  void add(double value, std::string of) { values_.emplace_back(value, std::move(of)); }

  /// Without the largest ones, if none is as large as that.
  void print(char const* what, char const* unit, double worth_a_name) {
    if (values_.empty()) return;
    std::sort(values_.begin(), values_.end());
    auto const at = [&](std::size_t share) {
      return values_[(values_.size() - 1) * share / 100].first;
    };
    std::printf("%-36s median %8.4f  95 %% %8.4f  99 %% %8.4f  most %8.4f %s\n", what, at(50),
                at(95), at(99), at(100), unit);
    constexpr int most_named = 5;
    for (int i = 1; i <= most_named && i <= std::ssize(values_); ++i) {
      auto const& [value, of] = values_[values_.size() - static_cast<std::size_t>(i)];
      if (value >= worth_a_name) std::printf("  %10.4f  %s\n", value, of.c_str());
    }
  }

 private:
  std::vector<std::pair<double, std::string>> values_;
};

struct Spreads {
  int turned = 0;
  int unbounded = 0;
  int unsettled = 0;
  Spread handles;
  Spread minima;
  Spread finishes;
};

std::string description(NamedPart const& part, RandomDrag const& drag, std::uint64_t seed) {
  auto const place = [](Vec2 p) {
    return std::to_string(static_cast<int>(p.x)) + "," + std::to_string(static_cast<int>(p.y));
  };
  auto text = "seed " + std::to_string(seed) + "  " + part.name + "  " + place(drag.from) + " to " +
              place(drag.to) + ", pins";
  for (auto const pin : drag.pins) text += " " + place(pin);
  return text;
}

void bend_once(std::vector<NamedPart> const& parts, std::uint64_t seed, Spreads& spreads) {
  Rng rng(seed);
  auto const& part =
      parts[static_cast<std::size_t>(rng.below(static_cast<int>(std::ssize(parts))))];
  auto deformed = DeformedPart::make(part.outlines);
  if (!deformed) return;
  bool const is_far = rng.below(20) == 0;
  auto const drag =
      random_drag(deformed->mesh(), 1 + rng.below(5), is_far ? 5000 : rng.uniform(0, 400), rng);
  auto const name = description(part, drag, seed);
  deformed->drag(drag);
  spreads.finishes.add(deformed->finish(), name);
  auto const pose = deformed->pose();
  spreads.turned += turned_triangles(deformed->mesh(), pose) > 0 ? 1 : 0;
  spreads.unbounded += is_finite_pose(pose) ? 0 : 1;
  spreads.unsettled += deformed->is_settled() ? 0 : 1;
  if (is_far) return;
  spreads.handles.add(deformed->farthest_handle_px(), name);
  deformed->settle(kStepsToMinimum);
  spreads.minima.add(farthest(pose, deformed->pose()), name);
}

void bend_anyhow(std::vector<NamedPart> const& parts, int count, std::uint64_t seed) {
  std::printf("%d drags of up to 400 px, one in 20 of 5000 px, 1 to 5 pins\n", count);
  Spreads spreads;
  for (int i = 0; i < count; ++i) {
    bend_once(parts, seed + static_cast<std::uint64_t>(i), spreads);
    if ((i + 1) % 100 == 0) std::printf("  %d\n", i + 1);
  }
  std::printf("with turned triangles %d, not finite %d, let go before all was still %d\n",
              spreads.turned, spreads.unbounded, spreads.unsettled);
  spreads.handles.print("handle to target", "px", 1);
  spreads.minima.print("to the minimum after the drag", "px", 0.1);
  spreads.finishes.print("processor time of letting go", "ms", 20);
}

/// What holds a figure, and how.
struct FigureWay {
  char const* name;
  BendMode mode;
  bool has_grip;
};

/// One row: the same drags for every way.
void bend_figures(FigureWay const& way, int pins, double length_px, int count, std::uint64_t seed) {
  BendOptions options;
  options.mode = way.mode;
  int any = 0;
  int sides = 0;
  int limbs = 0;
  int kinks = 0;
  int turned = 0;
  double error_px = 0;
  for (int i = 0; i < count; ++i) {
    std::vector<Outline> const outlines = {figure_outline(kFigurePoints)};
    auto bender = Bender::make({outlines, {}}, options);
    auto deformed = DeformedPart::make(outlines, options);
    if (!bender || !deformed) return;
    auto const& mesh = bender->mesh();
    Rng rng(seed + static_cast<std::uint64_t>(i));
    auto const drag = random_drag(mesh, pins, length_px, rng);
    BendPose pose;
    if (way.has_grip) {
      deformed->drag(drag);
      deformed->finish();
      pose = deformed->pose();
    } else {
      pose = dragged_by_needle(*bender, drag, way.mode);
    }
    auto const crossings = self_crossings(mesh, pose);
    any += crossings.has_sides || crossings.has_limbs || crossings.has_kinks ? 1 : 0;
    sides += crossings.has_sides ? 1 : 0;
    limbs += crossings.has_limbs ? 1 : 0;
    kinks += crossings.has_kinks ? 1 : 0;
    turned += turned_triangles(mesh, pose) > 0 ? 1 : 0;
    error_px += figure_shape_error(contour_of(mesh, mesh.rest.points), contour_of(mesh, pose));
  }
  auto const share = [&](int part) { return 100.0 * part / count; };
  std::printf(
      "%4.0f px, %d pins  %-16s turned %4.1f %%  crossed %4.1f %% (sides of a limb %4.1f, along "
      "one "
      "side %4.1f, limbs %4.1f)  shape %5.2f px\n",
      length_px, pins, way.name, share(turned), share(any), share(sides), share(kinks),
      share(limbs), error_px / count);
}

void compare(int count, std::uint64_t seed) {
  std::printf("a figure of %d points, %d drags each\n", kFigurePoints, count);
  struct Drags {
    double length_px;
    int pins;
  };
  for (auto const [length_px, pins] : {Drags{200, 1}, {200, 3}, {400, 1}}) {
    for (auto const& way : {FigureWay{"body", BendMode::Body, false},
                            {"body, as Deform", BendMode::Body, true},
                            {"wire", BendMode::Wire, false},
                            {"wire, as Deform", BendMode::Wire, true}}) {
      bend_figures(way, pins, length_px, count, seed);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  int drags = 1000;
  int figures = 200;
  std::uint64_t seed = 1;
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < count; ++i) {
    std::string const word = arguments[i];
    bool const has_value = i + 1 < count;
    if (word == "--count" && has_value) {
      drags = std::max(0, std::atoi(arguments[++i]));
    } else if (word == "--figures" && has_value) {
      figures = std::max(0, std::atoi(arguments[++i]));
    } else if (word == "--seed" && has_value) {
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
  if (figures > 0) compare(figures, seed);
  std::sort(files.begin(), files.end());
  std::vector<NamedPart> parts;
  for (auto const& file : files) {
    for (auto& part : parts_of(file)) parts.push_back(std::move(part));
  }
  std::printf("%zu parts of %zu files\n", parts.size(), files.size());
  if (!parts.empty() && drags > 0) bend_anyhow(parts, drags, seed);
  return 0;
}
