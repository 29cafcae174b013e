// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_joints.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>

#include "assemble/joined_runs.h"
#include "pipeline/laid_parts.h"

namespace inkflate {
namespace {

// So many stretches of a mouth: between two of them even a wide one follows its host to half a pixel.
constexpr std::size_t kStretches = 24;

/// Points of a finely sampled run, both ends among them.
Polyline coarse(Polyline const& run) {
  Polyline points;
  std::size_t const last = run.size() - 1;
  std::size_t const stretches = std::clamp<std::size_t>(last, 1, kStretches);
  for (std::size_t k = 0; k <= stretches; ++k) points.push_back(run[k * last / stretches]);
  return points;
}

enum class Among { Seen, All };

/// The drawing that is inflated, or all of it: parts that are not seen join what they would join.
std::vector<JoinedRun> runs_of(Document const& document, Among which) {
  Drawing drawing;
  for (auto const& layer : *document.layers) {
    bool const is_out = which == Among::Seen && layer->layer.is_hidden;
    // Without outlines it keeps its place and joins nothing.
    drawing.layers.push_back(is_out ? Layer{} : layer->layer);
  }
  return joined_runs(drawing);
}

BendJoint joint_of(LayerId limb, LayerId host, Polyline points) {
  BendJoint joint;
  joint.limb = limb;
  joint.host = host;
  joint.points = std::move(points);
  return joint;
}

/// The joints of a document: limbs that are seen join parts that are seen.
std::vector<BendJoint> joints_of(Document const& document) {
  auto const& layers = *document.layers;
  auto runs = runs_of(document, Among::Seen);
  bool const is_all_seen =
      std::none_of(layers.begin(), layers.end(), [](auto const& l) { return l->layer.is_hidden; });
  if (!is_all_seen) {
    for (auto& run : runs_of(document, Among::All)) {
      if (layers[run.limb]->layer.is_hidden) runs.push_back(std::move(run));
    }
  }
  std::vector<BendJoint> joints;
  for (auto const& run : runs) {
    if (run.points.empty()) continue;
    joints.push_back(
        joint_of(layers[run.limb]->layer.id, layers[run.host]->layer.id, coarse(run.points)));
  }
  return joints;
}

BendPart const* ready_part(BendParts const& parts, LayerId layer) {
  auto const found = parts.find(layer);
  return found != parts.end() && found->second->is_ready() ? found->second.get() : nullptr;
}

void anchor_host(BendJoint& joint, BendPart const& host) {
  auto const& pose = host.now().pose;
  for (auto const point : joint.points) {
    joint.hooks.push_back(hook_at(host.mesh(), pose, point));
    joint.starts.push_back(place_of(host.mesh(), pose, joint.hooks.back()));
  }
}

void anchor_limb(BendJoint& joint, BendPart const& limb) {
  auto const& pose = limb.now().pose;
  for (auto const point : joint.points) {
    joint.anchors.push_back(limb.nearest(pose, point));
    joint.beside.push_back(place_of(limb.mesh().rest, pose, joint.anchors.back()) - point);
  }
}

/// Whether nothing but its host has moved a laid part since.
bool lies_still(BendJoint const& joint, BendPart const& limb) {
  return limb.now().is_carried || limb.now().source.layer == joint.laid_as;
}

}  // namespace

Vec2 mouth_place(BendJoint const& joint, int point, BendPart const& host, BendPose const* pose) {
  auto const beside = joint.beside.empty() ? Vec2{} : joint.beside[point];
  if (pose == nullptr || joint.hooks.empty()) return joint.points[point] + beside;
  // By its way, so that a host that has not moved is the same to the last bit as one that has no mesh yet.
  auto const way = place_of(host.mesh(), *pose, joint.hooks[point]) - joint.starts[point];
  return joint.points[point] + way + beside;
}

bool BendJoints::find(Document const& document) {
  if (found_in_ == document.layers) return false;
  found_ = joints_of(document);
  found_in_ = document.layers;
  return true;
}

bool BendJoints::is_limb(Document const& document, LayerId layer) {
  find(document);
  return std::any_of(found_.begin(), found_.end(),
                     [&](BendJoint const& joint) { return joint.limb == layer; });
}

void BendJoints::meet(Document const& document, BendParts const& parts) {
  std::vector<Known> met;
  for (auto const& layer : *document.layers) {
    auto const part = parts.find(layer->layer.id);
    if (part != parts.end()) met.push_back({part->first, part->second, layer->layer.is_hidden});
  }
  if (met == known_ && laid_in_ == document.layers) return;
  std::set<LayerId> old;
  for (auto const& known : known_) {
    if (std::find(met.begin(), met.end(), known) != met.end()) old.insert(known.layer);
  }
  std::erase_if(joints_, [&](BendJoint const& joint) {
    return old.count(joint.limb) == 0 || old.count(joint.host) == 0;
  });
  if (met != known_) join(document, old);
  lay(document, parts);
  known_ = std::move(met);
  laid_in_ = document.layers;
}

/// Finds the joints of all but the parts that were known before, of which there are all.
void BendJoints::join(Document const& document, std::set<LayerId> const& old) {
  find(document);
  for (auto const& joint : found_) {
    if (old.count(joint.limb) == 0 || old.count(joint.host) == 0) joints_.push_back(joint);
  }
}

/// Unlike a mouth, what lies on a part can be moved over it: then it lies where it is now.
void BendJoints::lay(Document const& document, BendParts const& parts) {
  auto const first_laid = std::stable_partition(
      joints_.begin(), joints_.end(), [](BendJoint const& joint) { return !joint.is_laid(); });
  std::vector<BendJoint> before(std::make_move_iterator(first_laid),
                                std::make_move_iterator(joints_.end()));
  joints_.erase(first_laid, joints_.end());
  std::set<LayerId> joined;
  for (auto const& joint : joints_) joined.insert(joint.limb);
  for (auto& laid : laid_parts(document, joined)) {
    auto const known = std::find_if(before.begin(), before.end(), [&](BendJoint const& joint) {
      return joint.limb == laid.part && joint.host == laid.host &&
             lies_still(joint, *parts.at(joint.limb));
    });
    if (known != before.end()) {
      joints_.push_back(std::move(*known));
    } else {
      joints_.push_back(joint_of(laid.part, laid.host, std::move(laid.rim)));
      joints_.back().laid_as = layer_of(document, laid.part);
    }
  }
}

void BendJoints::anchor(BendParts const& parts) {
  for (auto& joint : joints_) {
    auto const* const limb = ready_part(parts, joint.limb);
    auto const* const host = ready_part(parts, joint.host);
    if (host != nullptr && joint.hooks.empty()) anchor_host(joint, *host);
    if (limb != nullptr && joint.anchors.empty()) anchor_limb(joint, *limb);
  }
}

std::vector<LayerId> hanging_layers(std::vector<LayerId> const& layers, BendJoints const& joints,
                                    std::set<LayerId> const& locked) {
  auto reached = layers;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (auto const& joint : joints.all()) {
      bool const hangs = joint.host == reached[i] && locked.count(joint.limb) == 0 &&
                         std::find(reached.begin(), reached.end(), joint.limb) == reached.end();
      if (hangs) reached.push_back(joint.limb);
    }
  }
  return {reached.begin() + std::ssize(layers), reached.end()};
}

std::vector<LayerId> hosts_first(std::vector<LayerId> layers, BendJoints const& joints) {
  std::vector<LayerId> ordered;
  while (!layers.empty()) {
    auto const is_waiting = [&](LayerId layer) {
      return std::find(layers.begin(), layers.end(), layer) != layers.end();
    };
    auto const is_free = [&](LayerId layer) {
      return std::none_of(joints.all().begin(), joints.all().end(), [&](BendJoint const& joint) {
        return joint.limb == layer && is_waiting(joint.host);
      });
    };
    auto next = std::find_if(layers.begin(), layers.end(), is_free);
    if (next == layers.end()) next = layers.begin();
    ordered.push_back(*next);
    layers.erase(next);
  }
  return ordered;
}

}  // namespace inkflate
