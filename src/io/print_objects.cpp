// SPDX-License-Identifier: Apache-2.0
#include "io/print_objects.h"

#include <numeric>
#include <utility>

#include "base/check.h"
#include "io/print_pose.h"

namespace inkflate {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Sets of layers that share vertices, each known by its lowest layer.
class LayerGroups {
 public:
  explicit LayerGroups(std::size_t layer_count) : parents_(layer_count) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }
  int root(int layer) {
    while (parents_[at(layer)] != layer)
      layer = parents_[at(layer)] = parents_[at(parents_[at(layer)])];
    return layer;
  }
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    parents_[at(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parents_;
};

LayerGroups group_layers(RestModel const& model) {
  LayerGroups groups(model.layer_names.size());
  std::vector<int> layer_of(model.mesh.points.size(), -1);
  for (std::size_t i = 0; i < model.mesh.triangles.size(); ++i) {
    for (int const vertex : model.mesh.triangles[i]) {
      int const layer = model.faces[i].layer;
      if (layer_of[at(vertex)] >= 0) groups.join(layer_of[at(vertex)], layer);
      layer_of[at(vertex)] = layer;
    }
  }
  return groups;
}

}  // namespace

std::vector<PrintObject> print_objects(RestModel const& model, double longest_mm) {
  CHECK(model.faces.size() == model.mesh.triangles.size(), "each triangle has a face");
  auto const posed = print_pose(model.mesh, longest_mm);
  auto groups = group_layers(model);
  auto const layer_count = static_cast<int>(std::ssize(model.layer_names));
  std::vector<int> object_of(at(layer_count), -1);
  std::vector<PrintObject> objects;
  for (int layer = 0; layer < layer_count; ++layer) {
    int const root = groups.root(layer);
    bool const is_new = root == layer;
    object_of[at(layer)] = is_new ? static_cast<int>(std::ssize(objects)) : object_of[at(root)];
    if (is_new) objects.emplace_back();
    auto& name = objects[at(object_of[at(layer)])].name;
    name += (is_new ? "" : ", ") + model.layer_names[at(layer)];
  }
  std::vector<int> vertex_in_object(posed.points.size(), -1);  // a vertex lies in one object only
  for (std::size_t i = 0; i < posed.triangles.size(); ++i) {
    auto& object = objects[at(object_of[at(model.faces[i].layer)])];
    Triangle corners = {};
    for (std::size_t c = 0; c < 3; ++c) {
      int& vertex = vertex_in_object[at(posed.triangles[i][c])];
      if (vertex < 0) {
        vertex = static_cast<int>(std::ssize(object.mesh.points));
        object.mesh.points.push_back(posed.points[at(posed.triangles[i][c])]);
      }
      corners[c] = vertex;
    }
    object.mesh.triangles.push_back(corners);
    object.colours.push_back(model.faces[i].layer);
  }
  std::erase_if(objects, [](PrintObject const& object) { return object.mesh.triangles.empty(); });
  return objects;
}

}  // namespace inkflate
