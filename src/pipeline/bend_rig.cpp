// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_rig.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace inkflate {
namespace {

// A pin has come where it was to go if its part came so near; else it is where the part is.
constexpr double kReachedPx = 1;

bool is_same_list(std::vector<HeldPin> const& a, std::vector<HeldPin> const& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](HeldPin const& p, HeldPin const& q) { return p.pin == q.pin; });
}

// How far a hand or a pin takes hold around it, of a square as large as the part: what is drawn out of a head is a bump and no spike, and a
// limb that is thinner than it is long is held by its whole width.
constexpr double kGripShare = 0.1;

// The same of a line's length: its strip has hardly an area.
constexpr double kGripShareOfLine = 0.05;

double grip_px(FlatMesh const& mesh, bool is_line) {
  if (is_line) return kGripShareOfLine * bounds(mesh.points).longer_side();
  double area = 0;
  for (auto const& [a, b, c] : mesh.triangles) {
    area += cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]) / 2;
  }
  return kGripShare * std::sqrt(area);
}

}  // namespace

BendRig::BendRig(std::vector<BendRoot> const& roots, std::vector<LayerId> const& hanging,
                 BendParts const& parts, BendJoints const& joints) {
  std::vector<LayerId> layers;
  for (auto const& root : roots) {
    if (auto const& layer = root.part->now().source.layer) {
      layers.push_back(layer->layer.id);
    } else {
      parts_.push_back(part_at_start(root.part, root.stroke));
    }
  }
  layers.insert(layers.end(), hanging.begin(), hanging.end());
  add_layers(hosts_first(std::move(layers), joints), hanging, parts, joints);
  for (auto const& root : roots) {
    auto const place = std::find_if(parts_.begin(), parts_.end(),
                                    [&](Part const& part) { return part.part == root.part; });
    roots_.push_back(static_cast<int>(place - parts_.begin()));
  }
  find_whole();
}

BendRig::Part BendRig::part_at_start(std::shared_ptr<BendPart> bent,
                                     std::optional<StrokeRef> stroke) {
  Part part = {std::move(bent), stroke, {}, {}};
  part.grip_px = grip_px(part.part->mesh().rest, stroke.has_value());
  part.start = part.part->now().pose;
  part.pose = part.start;
  for (auto const& held : part.part->now().pins) {
    auto handle = handle_at(part, held.anchor, held.pin.position + held.beside);
    if (held.pin.turn_rad) {
      handle.start_turn_rad = handle.staged_rad = *held.pin.turn_rad - held.turn_base_rad;
      handle.kept_rad = handle.turn_rad = handle.start_turn_rad;
    }
    part.handles.push_back(handle);
  }
  part.own_handles = static_cast<int>(std::ssize(part.handles));
  return part;
}

BendRig::Handle BendRig::handle_at(Part const& part, BendAnchor const& anchor, Vec2 target) {
  Handle handle = {anchor, target, target, target};
  handle.start_turn_rad = handle.staged_rad = turn_at(part.part->mesh(), part.pose, anchor);
  return handle;
}

void BendRig::add_layers(std::vector<LayerId> const& layers, std::vector<LayerId> const& hanging,
                         BendParts const& parts, BendJoints const& joints) {
  auto const first = std::ssize(parts_);
  for (auto const layer : layers) {
    auto part = part_at_start(parts.at(layer), {});
    bool const is_held = std::find(hanging.begin(), hanging.end(), layer) == hanging.end();
    for (auto const& joint : joints.all()) {
      if (joint.limb != layer || (joint.is_laid() && is_held)) continue;
      auto const place = std::find(layers.begin(), layers.end(), joint.host) - layers.begin();
      bool const is_moving = place < std::ssize(layers);
      // A host that comes after it hangs on it: it cannot hold it.
      if (is_moving && first + place >= std::ssize(parts_)) continue;
      auto const host = is_moving ? static_cast<int>(first + place) : -1;
      add_mouth(part, joint, *parts.at(joint.host), host);
    }
    parts_.push_back(std::move(part));
  }
}

void BendRig::add_mouth(Part& part, BendJoint const& joint, BendPart const& host, int moving_host) {
  part.mouths.push_back({&joint, static_cast<int>(std::ssize(part.handles)), moving_host});
  auto const* const pose = host.is_ready() ? &host.now().pose : nullptr;
  for (int i = 0; i < std::ssize(joint.points); ++i) {
    auto const place = mouth_place(joint, i, host, pose);
    part.handles.push_back(handle_at(part, joint.anchors[i], place));
  }
}

int BendRig::hold(int root, BendAnchor const& anchor) {
  auto& part = parts_[roots_[root]];
  auto const place = place_of(part.part->mesh().rest, part.pose, anchor);
  int const index = part.own_handles++;
  part.handles.insert(part.handles.begin() + index, handle_at(part, anchor, place));
  for (auto& mouth : part.mouths) ++mouth.first_handle;
  find_whole();
  return index;
}

void BendRig::keep_within(BendArea area) {
  parts_[roots_.front()].area = std::move(area);
  find_whole();
}

Vec2 BendRig::start(int root, int handle) const {
  return parts_[roots_[root]].handles[handle].start;
}

Vec2 BendRig::end(int root, int handle) const {
  auto const& part = parts_[roots_[root]];
  return place_of(part.part->mesh().rest, part.pose, part.handles[handle].anchor);
}

void BendRig::move(int root, int handle, Vec2 target, std::optional<double> turn_rad) {
  auto& part = parts_[roots_[root]];
  auto& held = part.handles[handle];
  held.target = target;
  held.turn_rad = held.kept_rad;
  if (turn_rad) held.turn_rad = held.start_turn_rad + *turn_rad;
  part.is_settled = false;
}

void BendRig::restart() {
  for (auto& part : parts_) {
    part.pose = part.start;
    part.is_moved = false;
    part.is_settled = false;
    for (auto& handle : part.handles) {
      handle.staged = handle.start;
      handle.staged_rad = handle.start_turn_rad;
    }
  }
}

std::vector<HeldPin> BendRig::pins_after(Part const& part) {
  auto pins = part.part->now().pins;
  for (std::size_t i = 0; i < pins.size(); ++i) {
    auto& [pin, anchor, beside, turn_base_rad] = pins[i];
    auto const& handle = part.handles[i];
    if (handle.target != handle.start) {
      auto const place = place_of(part.part->mesh().rest, part.pose, anchor);
      bool const is_reached = distance(place, handle.target) <= kReachedPx;
      pin.position = (is_reached ? handle.target : place) - beside;
    }
    if (handle.turn_rad != handle.kept_rad) {
      pin.turn_rad = pin.turn_rad.value_or(0) + (*handle.turn_rad - handle.start_turn_rad);
      turn_base_rad = *pin.turn_rad - *handle.turn_rad;
    }
  }
  return pins;
}

std::vector<Command> BendRig::commands() const {
  Bend bend;
  std::vector<Command> pins;
  for (auto const& part : parts_) {
    if (part.pose == part.start) continue;
    if (part.stroke) {
      bend.lines.push_back(part.part->bent_stroke(part.pose, *part.stroke));
      continue;
    }
    bend.parts.push_back(part.part->bent_layer(part.pose));
    auto const after = pins_after(part);
    if (is_same_list(after, part.part->now().pins)) continue;
    SetBendPins set = {bend.parts.back().layer, {}};
    for (auto const& held : after) set.pins.push_back(held.pin);
    pins.emplace_back(std::move(set));
  }
  if (bend.parts.empty() && bend.lines.empty()) return {};
  std::vector<Command> commands = {std::move(bend)};
  commands.insert(commands.end(), pins.begin(), pins.end());
  return commands;
}

void BendRig::remember(Document const& result) const {
  for (int i = 0; i < std::ssize(parts_); ++i) {
    auto const& part = parts_[i];
    if (part.pose == part.start) continue;
    BendSource source;
    if (part.stroke) {
      source.stroke = stroke_of(result, *part.stroke);
    } else {
      source.layer = layer_of(result, part.part->now().source.layer->layer.id);
    }
    if (!part.part->is_bent_to(source, part.pose)) continue;
    BendVersion version = {source, part.pose, pins_after(part)};
    version.is_carried = std::find(roots_.begin(), roots_.end(), i) == roots_.end();
    part.part->remember(std::move(version));
  }
}

}  // namespace inkflate
