// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "base/check.h"
#include "geometry/trig.h"
#include "mesh/check_mesh.h"
#include "mesh/mesh_region.h"
#include "mesh/rim_spacing.h"

namespace inkflate {
namespace {

// Contours are sampled at this distance before the rim spacing is measured.
constexpr double kFinePx = 2;

/// A blob with five round limbs, about as long around as a character that fills a canvas of this size.
Contour character(double size_px) {
  Contour contour;
  for (int i = 0; i < 4000; ++i) {
    double const angle = 2 * kPi * i / 4000;
    auto const turn = sin_cos(angle);
    double const radius = size_px * (0.3 + 0.18 * sin_cos(5 * angle).sin);
    contour.push_back({turn.cos * radius, turn.sin * radius});
  }
  return contour;
}

Contour resampled(Contour contour, std::vector<double> spacing) {
  contour.push_back(contour.front());
  spacing.push_back(spacing.front());
  auto line = resample(contour, spacing);
  line.pop_back();
  return line;
}

Contour fine_character(double size_px) {
  auto const contour = character(size_px);
  return resampled(contour, std::vector<double>(contour.size(), kFinePx));
}

Region sampled(Contour const& fine) {
  auto spacing = rim_spacing(std::span(&fine, 1));
  return {{resampled(fine, std::move(spacing[0]))}, {}};
}

RegionMesh meshed(Region const& region) {
  auto mesh = mesh_region(region);
  CHECK(mesh.has_value(), "the regions of the benchmark are simple");
  return *std::move(mesh);
}

/// From a finely sampled contour to the mesh.
void mesh_layer(benchmark::State& state) {
  auto const fine = fine_character(static_cast<double>(state.range(0)));
  for ([[maybe_unused]] auto const iteration : state)
    benchmark::DoNotOptimize(meshed(sampled(fine)).mesh.points.data());
  state.counters["perimeter_px"] = perimeter(fine);
  state.counters["rim"] = static_cast<double>(sampled(fine).contours[0].size());
  state.counters["vertices"] = static_cast<double>(meshed(sampled(fine)).mesh.points.size());
}
BENCHMARK(mesh_layer)
    ->Arg(250)
    ->Arg(500)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(4000)
    ->Unit(benchmark::kMillisecond);

void mesh_rim_spacing(benchmark::State& state) {
  auto const fine = fine_character(static_cast<double>(state.range(0)));
  for ([[maybe_unused]] auto const iteration : state)
    benchmark::DoNotOptimize(sampled(fine).contours.data());
}
BENCHMARK(mesh_rim_spacing)->Arg(1000)->Unit(benchmark::kMillisecond);

void mesh_region_only(benchmark::State& state) {
  auto const region = sampled(fine_character(static_cast<double>(state.range(0))));
  for ([[maybe_unused]] auto const iteration : state)
    benchmark::DoNotOptimize(meshed(region).mesh.points.data());
}
BENCHMARK(mesh_region_only)->Arg(1000)->Unit(benchmark::kMillisecond);

/// A mesh and its mirror image below, one surface.
TriMesh doubled(RegionMesh const& flat) {
  TriMesh mesh;
  int const count = static_cast<int>(flat.mesh.points.size());
  for (double const side : {1.0, -1.0}) {
    for (int v = 0; v < count; ++v) {
      auto const p = flat.mesh.points[v];
      mesh.points.push_back({p.x, p.y, v < std::ssize(flat.contours[0]) ? 0 : side});
    }
  }
  for (auto const& [a, b, c] : flat.mesh.triangles) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({count + a, count + c, count + b});
  }
  return weld_vertices(mesh);
}

void mesh_check(benchmark::State& state) {
  auto const mesh = doubled(meshed(sampled(fine_character(static_cast<double>(state.range(0))))));
  for ([[maybe_unused]] auto const iteration : state)
    benchmark::DoNotOptimize(check_mesh(mesh).volume);
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}
BENCHMARK(mesh_check)->Arg(1000)->Unit(benchmark::kMillisecond);

void mesh_self_crossings(benchmark::State& state) {
  auto const mesh = doubled(meshed(sampled(fine_character(static_cast<double>(state.range(0))))));
  for ([[maybe_unused]] auto const iteration : state)
    benchmark::DoNotOptimize(count_self_crossings(mesh));
}
BENCHMARK(mesh_self_crossings)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace inkflate
