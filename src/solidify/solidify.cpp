// SPDX-License-Identifier: Apache-2.0
#include "solidify/solidify.h"

#include <algorithm>
#include <numeric>

#include "solidify/label_nodes.h"
#include "solidify/march.h"
#include "solidify/print_space.h"
#include "solidify/smooth_creases.h"

namespace inkflate {
namespace {

Error cancelled() { return {ErrorCode::Cancelled, "Cancelled."}; }

/// Per triangle which connected piece it belongs to, from 0.
std::vector<int> shells_of(TriMesh const& model) {
  std::vector<int> parents(model.points.size());
  std::iota(parents.begin(), parents.end(), 0);
  auto const root = [&](int p) {
    while (parents[p] != p) p = parents[p] = parents[parents[p]];
    return p;
  };
  for (auto const& [a, b, c] : model.triangles) {
    parents[root(b)] = root(a);
    parents[root(c)] = root(a);
  }
  std::vector<int> numbers(model.points.size(), -1);
  std::vector<int> shells;
  int count = 0;
  for (auto const& triangle : model.triangles) {
    int& number = numbers[root(triangle[0])];
    if (number < 0) number = count++;
    shells.push_back(number);
  }
  return shells;
}

/// The mesh, which has points, in mm and standing on z = 0. Not always on the base that was cut: what it cut through may have been a crumb.
void move_to_mm(TriMesh& mesh, PrintSpace const& space) {
  double const lowest =
      std::min_element(mesh.points.begin(), mesh.points.end(), [](Vec3 a, Vec3 b) {
        return a.z < b.z;
      })->z;
  for (auto& point : mesh.points)
    point = (point - Vec3{space.zero.x, space.zero.y, lowest}) * space.unit_mm;
}

}  // namespace

Result<TriMesh> solidify(TriMesh const& model, SolidifyOptions const& options,
                         Progress const& progress) {
  if (!progress.enter("lay into the lattice")) return cancelled();
  auto const space = make_print_space(model, options);
  if (!space) return space.error();

  Solid solid;
  solid.lattice = space->lattice;
  for (int f = 0; f < kFamilies; ++f) {
    if (!progress.enter("scan lines")) return cancelled();
    LineSpans& family = solid.families.emplace_back(solid.lattice, f);
    if (auto const scanned = family.scan(space->mesh); !scanned) return scanned.error();
  }
  if (!progress.enter("thicken")) return cancelled();
  solid.balls = fill_balls(space->mesh, solid.families, space->least);
  if (options.has_flat_base) {
    solid.base = space->zero.z;
    for (auto& family : solid.families) family.cut_below(solid.base);
  }
  if (!progress.enter("tell inside from outside")) return cancelled();
  label_nodes(solid, shells_of(model));
  if (!progress.enter("cut edges")) return cancelled();
  Cuts const cuts(solid);
  if (!progress.enter("move nodes")) return cancelled();
  SnappedNodes const snapped = snap_nodes(solid, cuts);
  if (!progress.enter("march")) return cancelled();
  MarchedMesh marched = march(solid, cuts, snapped);
  if (!progress.enter("smooth creases")) return cancelled();
  smooth_creases(marched, solid.base);
  TriMesh& mesh = marched.mesh;
  if (mesh.triangles.empty())
    return Error{ErrorCode::NothingThere, "The model has no inside: there is nothing to print."};
  move_to_mm(mesh, *space);
  return std::move(mesh);
}

}  // namespace inkflate
