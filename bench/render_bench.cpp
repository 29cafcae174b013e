// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "pipeline/run_inflate.h"
#include "render/bake_texture.h"
#include "render/rasterise_model.h"
#include "support/characters.h"

namespace inkflate {
namespace {

/// A character of five layers on 1000 px; each outline is drawn by three strokes, and has a detail.
struct Subject {
  Drawing drawing = character(5);
  RestModel model;

  Subject() {
    auto made = run_inflate(drawing);
    CHECK(made.has_value(), "the characters of the benchmark inflate");
    model = std::move(*made);
    for (auto& layer : drawing.layers) {
      auto const contour = flatten(layer.outlines[0], 0.5);
      for (int pass = 0; pass < 3; ++pass) add_stroke(contour, pass - 1.0, layer.strokes);
      add_stroke({contour[0], contour[contour.size() / 2]}, 0, layer.details);
    }
  }

  void add_stroke(Polyline const& line, double aside_px, std::vector<int>& strokes) {
    Stroke stroke;
    for (auto const point : line) stroke.samples.push_back({point + Vec2{aside_px, aside_px}});
    strokes.push_back(static_cast<int>(std::ssize(drawing.sketch.strokes)));
    drawing.sketch.strokes.push_back(std::move(stroke));
  }
};

void bake(benchmark::State& state) {
  Subject const subject;
  for ([[maybe_unused]] auto const iteration : state) {
    auto const texture = bake_texture(subject.drawing, subject.model);
    benchmark::DoNotOptimize(texture.picture.values.data());
  }
}
BENCHMARK(bake)->Unit(benchmark::kMillisecond);

void draw(benchmark::State& state, Shading shading) {
  Subject const subject;
  auto const texture = bake_texture(subject.drawing, subject.model);
  int const side_px = static_cast<int>(state.range(0));
  for ([[maybe_unused]] auto const iteration : state) {
    auto const list =
        draw_model(subject.model, &texture, {0.5, 0.2, 1, {}}, shading, side_px, side_px);
    auto const picture = rasterise_model(list, side_px, side_px);
    benchmark::DoNotOptimize(picture.values.data());
  }
  state.counters["triangles"] = static_cast<double>(subject.model.faces.size());
}
BENCHMARK_CAPTURE(draw, textured, Shading::Textured)
    ->Arg(128)
    ->Arg(512)
    ->Arg(2048)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw, matcap, Shading::Matcap)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw, lines, Shading::Lines)->Arg(512)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace inkflate
