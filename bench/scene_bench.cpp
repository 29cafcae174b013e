// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "base/rng.h"
#include "document/apply.h"
#include "editor/scene.h"

namespace inkflate {
namespace {

/// 30 samples from one place, all over the canvas.
Stroke any_stroke(Rng& rng) {
  Stroke stroke;
  Vec2 p = {rng.uniform(0, 900), rng.uniform(0, 900)};
  Vec2 step = {rng.uniform(-3, 3), rng.uniform(-3, 3)};
  for (int i = 0; i < 30; ++i) {
    stroke.samples.push_back({p, rng.uniform(0.3, 1), 0.01 * i});
    step += Vec2{rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)};
    p += step;
  }
  return stroke;
}

/// 1000 loose strokes on the canvas.
struct Subject {
  Rng rng = Rng(1);
  Document document = empty_document();
  View view;
  ToolDrawing drawing;
  ShapePreview preview;

  Subject() {
    for (int i = 0; i < 1000; ++i) add();
    drawing.smooth = any_stroke(rng);
    // As many points as the outline of a large figure has.
    preview.contours.resize(4);
    for (auto& contour : preview.contours) {
      for (int i = 0; i < 500; ++i) contour.push_back({rng.uniform(0, 900), rng.uniform(0, 900)});
    }
  }

  void add() {
    auto next = apply(document, AddStroke{any_stroke(rng)});
    CHECK(next.has_value(), "strokes of the benchmark are good");
    document = std::move(*next);
  }

  Scene build(SceneBuilder& builder) const {
    return builder.build({document, view, drawing, preview, {}});
  }
};

void scene_while_drawing(benchmark::State& state) {
  Subject subject;
  SceneBuilder builder;
  subject.build(builder);
  for ([[maybe_unused]] auto const iteration : state) {
    auto& samples = subject.drawing.smooth.samples;
    samples.push_back({samples.back().position + Vec2{1, 1}});
    if (samples.size() > 200) samples.resize(1);
    benchmark::DoNotOptimize(subject.build(builder).chunks.data());
  }
}
BENCHMARK(scene_while_drawing)->Unit(benchmark::kMicrosecond);

void scene_while_panning(benchmark::State& state) {
  Subject subject;
  SceneBuilder builder;
  for ([[maybe_unused]] auto const iteration : state) {
    subject.view.camera.centre.x += 0.5;
    benchmark::DoNotOptimize(subject.build(builder).chunks.data());
  }
}
BENCHMARK(scene_while_panning)->Unit(benchmark::kMicrosecond);

void scene_after_a_stroke(benchmark::State& state) {
  Subject subject;
  SceneBuilder builder;
  auto const before = subject.document;
  subject.build(builder);
  for ([[maybe_unused]] auto const iteration : state) {
    state.PauseTiming();
    if (subject.document.loose.size() > 1200) subject.document = before;
    subject.add();
    state.ResumeTiming();
    benchmark::DoNotOptimize(subject.build(builder).chunks.data());
  }
}
BENCHMARK(scene_after_a_stroke)->Unit(benchmark::kMicrosecond);

void scene_from_nothing(benchmark::State& state) {
  Subject const subject;
  for ([[maybe_unused]] auto const iteration : state) {
    SceneBuilder builder;
    benchmark::DoNotOptimize(subject.build(builder).chunks.data());
  }
}
BENCHMARK(scene_from_nothing)->Unit(benchmark::kMicrosecond);

void picture_of_scene(benchmark::State& state) {
  Subject const subject;
  SceneBuilder builder;
  auto const scene = subject.build(builder);
  for ([[maybe_unused]] auto const iteration : state) {
    benchmark::DoNotOptimize(picture_of(scene).values.data());
  }
}
BENCHMARK(picture_of_scene)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace inkflate
