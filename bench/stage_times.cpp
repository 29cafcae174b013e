// SPDX-License-Identifier: Apache-2.0
// stage_times [RUNS [FILE.svg ...]]: the median milliseconds of each stage of simplify, and of the whole, over a number
// of runs (60: node optimises what runs often, and a few runs are not enough), and the whole of the first run, when
// nothing is warm. Without files on three generated drawings, and on a figure that is bent in both modes: make is from the outline to
// the mesh, drag the 20 frames of a drag, bent the outline that comes of it. A line is: drawing, stage, milliseconds.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "deform/bender.h"
#include "figure_drag.h"
#include "io/read_svg.h"
#include "pipeline/stage_clock.h"
#include "rough_character.h"
#include "simplify/simplify.h"

namespace {

using namespace inkflate;

/// The times of every run, stage by stage; the last stage is the whole.
struct StageRuns {
  std::vector<std::string> stages;
  std::vector<std::vector<double>> ms;
};

double median(std::vector<double> values) {
  auto const middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void add(StageRuns& runs, std::size_t index, std::string const& stage, double ms) {
  if (index == runs.stages.size()) {
    runs.stages.push_back(stage);
    runs.ms.emplace_back();
  }
  runs.ms[index].push_back(ms);
}

using Run = std::function<Result<std::vector<StageTime>>()>;

bool measure(std::string const& name, int run_count, Run const& run) {
  StageRuns runs;
  for (int i = 0; i < run_count; ++i) {
    auto const times = run();
    if (!times) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), times.error().message.c_str());
      return false;
    }
    double total_ms = 0;
    std::size_t next = 0;
    for (auto const& time : *times) {
      total_ms += time.ms;
      add(runs, next++, time.stage, time.ms);
    }
    add(runs, next, "total", total_ms);
  }
  std::printf("%s first %.3f\n", name.c_str(), runs.ms.back().front());
  for (std::size_t i = 0; i < runs.stages.size(); ++i)
    std::printf("%s %s %.3f\n", name.c_str(), runs.stages[i].c_str(), median(runs.ms[i]));
  return true;
}

Run simplifying(Sketch const& sketch) {
  return [&sketch]() -> Result<std::vector<StageTime>> {
    StageClock clock;
    auto const drawing = simplify(sketch, {}, clock.timed({}));
    clock.stop();
    if (!drawing) return drawing.error();
    return clock.times();
  };
}

Run bending(BendShape const& shape, BendMode mode) {
  return [&shape, mode]() -> Result<std::vector<StageTime>> {
    StageClock clock;
    clock.start("make");
    auto bender = Bender::make(shape, {mode});
    if (!bender) return bender.error();
    clock.start("drag");
    auto pose = bender->rest_pose();
    for (int frame = 1; frame <= 20; ++frame) {
      auto const handles = figure_handles(bender->mesh(), frame / 20.0);
      bender->step(pose, {handles, {}}, mode == BendMode::Body ? 2 : 10);
    }
    clock.start("bent");
    auto const bent = bender->bent(pose);
    clock.stop();
    return clock.times();
  };
}

bool measure_generated(int run_count) {
  bool is_done = true;
  for (int const strokes : {50, 250, 1000}) {
    auto const sketch = rough_character(strokes);
    is_done =
        measure(std::to_string(strokes) + "-strokes", run_count, simplifying(sketch)) && is_done;
  }
  BendShape const figure = {{figure_outline(400)}, {}};
  return measure("bend-body", run_count, bending(figure, BendMode::Body)) &&
         measure("bend-wire", run_count, bending(figure, BendMode::Wire)) && is_done;
}

bool measure_file(char const* path, int run_count) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> const content{std::istreambuf_iterator<char>(stream), {}};
  auto const drawing = read_svg(std::as_bytes(std::span(content)));
  if (!drawing) {
    std::fprintf(stderr, "%s: %s\n", path, drawing.error().message.c_str());
    return false;
  }
  return measure(std::filesystem::path(path).stem().string(), run_count,
                 simplifying(drawing->sketch));
}

}  // namespace

int main(int count, char** arguments) {
  int const run_count = count > 1 ? std::atoi(arguments[1]) : 60;
  if (run_count < 1) {
    std::fprintf(stderr, "usage: stage_times [RUNS [FILE.svg ...]]\n");
    return 2;
  }
  bool is_done = true;
  for (int i = 2; i < count; ++i) is_done = measure_file(arguments[i], run_count) && is_done;
  if (count <= 2) is_done = measure_generated(run_count);
  return is_done ? 0 : 1;
}
