// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/trig.h"
#include "pipeline/bend_rig.h"

namespace inkflate {
namespace {

// What a handle aims at goes this far in a step, in edges of the mesh, and turns by this much: drawn from farther away a shape
// would first be pulled out thin. Of a very long way it goes a share, so that it comes to an end.
constexpr double kEdgesPerStep = 10;
constexpr double kShareOfWay = 0.125;
constexpr double kTurnPerStep = 0.25;

// Iterations of the wire that take about as long as a step of the body.
constexpr int kWireIterations = 10;

// How firmly a host takes along what lies on it: an eye keeps its shape nearly, and a wing bends with the back below it.
constexpr double kLaidFirmness = 5e-5;

// At the end of a drag: what is not still after so many steps of a vertex (half a microsecond each) stays as it is. But a few
// rounds are always made.
constexpr int kStepsOfRound = 4;
constexpr int kMostVertexSteps = 70'000;
constexpr int kLeastRounds = 3;
constexpr int kMostRounds = 40;

// Less than this from where it was nobody sees.
constexpr double kSnapPx = 0.1;

double farthest(BendPose const& a, BendPose const& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, squared_norm(a[i] - b[i]));
  return std::sqrt(most);
}

bool stays_somewhere(BendArea const& area) {
  return std::any_of(area.is_fixed.begin(), area.is_fixed.end(), [](char is) { return is != 0; }) ||
         std::any_of(area.tethers.begin(), area.tethers.end(), [](double k) { return k > 0; });
}

}  // namespace

/// Which parts move as a whole, and with which one: those that are held by a single handle, and what hangs on such a part alone.
void BendRig::find_whole() {
  for (int i = 0; i < std::ssize(parts_); ++i) parts_[i].whole_with = whole_of(parts_[i], i);
}

int BendRig::whole_of(Part const& part, int index) const {
  if (stays_somewhere(part.area)) return -1;
  if (part.mouths.empty()) return part.own_handles == 1 ? index : -1;
  if (part.own_handles > 0 || part.mouths.front().host < 0) return -1;
  int const whole = parts_[part.mouths.front().host].whole_with;
  bool const is_shared =
      std::all_of(part.mouths.begin(), part.mouths.end(), [&](Mouth const& mouth) {
        return mouth.host >= 0 && parts_[mouth.host].whole_with == whole;
      });
  return is_shared ? whole : -1;
}

RigidMotion BendRig::motion_of(Part const& root) const {
  auto const& handle = root.handles.front();
  RigidMotion motion = {1, 0, handle.start, handle.target};
  if (handle.turn_rad && *handle.turn_rad != handle.start_turn_rad) {
    auto const turn = sin_cos(*handle.turn_rad - handle.start_turn_rad);
    motion.cos = turn.cos;
    motion.sin = turn.sin;
  }
  return motion;
}

void BendRig::move_whole(Part& part) const {
  auto const motion = motion_of(parts_[part.whole_with]);
  part.pose = part.start;
  if (!motion.is_still()) {
    for (auto& p : part.pose) p = motion(p);
  }
  part.is_settled = true;
}

void BendRig::follow_hosts(Part& part) const {
  for (auto const& mouth : part.mouths) {
    if (mouth.host < 0) continue;
    auto const& host = parts_[mouth.host];
    for (int i = 0; i < std::ssize(mouth.joint->points); ++i) {
      auto& target = part.handles[mouth.first_handle + i].target;
      auto const place = mouth_place(*mouth.joint, i, *host.part, &host.pose);
      if (place != target) part.is_settled = false;
      target = place;
    }
  }
}

/// Whether anything draws at it that did not at the start. What nothing draws at stays, settled or not.
bool BendRig::is_pulled(Part const& part) {
  return part.is_moved ||
         std::any_of(part.handles.begin(), part.handles.end(), [](Handle const& handle) {
           return handle.target != handle.start || handle.turn_rad != handle.kept_rad;
         });
}

/// A limb that nothing holds but its mouths goes with them as a whole first, so that it need not be bent for what is only a motion.
void BendRig::go_along(Part& part) {
  std::vector<Vec2> places;
  std::vector<Vec2> targets;
  for (auto const& handle : part.handles) {
    places.push_back(place_of(part.part->mesh().rest, part.pose, handle.anchor));
    targets.push_back(handle.target);
  }
  auto const motion = best_motion(places, targets);
  for (auto& p : part.pose) p = motion(p);
  for (auto& handle : part.handles) handle.staged = motion(handle.staged);
}

/// What the handles aim at in the next step. True: their targets.
bool BendRig::advance(Part& part) {
  double const least_px = kEdgesPerStep * part.part->mesh().edge_px;
  bool has_arrived = true;
  for (auto& handle : part.handles) {
    auto const way = handle.target - handle.staged;
    double const far = norm(way);
    double const most_px = std::max(least_px, kShareOfWay * far);
    bool const is_near = far <= most_px;
    handle.staged = is_near ? handle.target : handle.staged + way * (most_px / far);
    has_arrived = has_arrived && is_near;
    if (!handle.turn_rad) continue;
    double const turn = *handle.turn_rad - handle.staged_rad;
    bool const is_turned = std::abs(turn) <= kTurnPerStep;
    handle.staged_rad =
        is_turned ? *handle.turn_rad : handle.staged_rad + std::copysign(kTurnPerStep, turn);
    has_arrived = has_arrived && is_turned;
  }
  return has_arrived;
}

void BendRig::bend(Part& part, int steps) {
  part.is_moved = true;
  bool const hangs = part.own_handles == 0 && part.area.is_fixed.empty();
  if (hangs) go_along(part);
  auto const& area = part.area;
  // What is dragged on comes back to where it was before the first of the drags.
  auto const& known = part.part->now();
  auto const& from = known.loose_end ? known.loose_from : part.start;
  auto& bender = part.part->bender();
  bool const is_laid = !part.mouths.empty() && part.mouths.front().joint->is_laid();
  int const iterations = part.part->options().mode == BendMode::Wire ? kWireIterations : 1;
  for (int i = 0; i < steps && !part.is_settled; ++i) {
    bool const has_arrived = advance(part);
    std::vector<BendHandle> handles;
    for (auto const& handle : part.handles) {
      bool const is_by_hand = std::ssize(handles) < part.own_handles;
      handles.push_back({handle.anchor, handle.staged, {}, is_by_hand ? part.grip_px : 0});
      if (is_laid && !is_by_hand) handles.back().firmness = kLaidFirmness;
      if (handle.turn_rad) handles.back().turn_rad = handle.staged_rad;
    }
    auto const progress = bender.step(
        part.pose, {handles, area.is_fixed, area.stiffening, area.tethers, from}, iterations);
    part.is_settled = has_arrived && progress.is_settled;
  }
}

void BendRig::step(int steps) {
  for (auto& part : parts_) {
    follow_hosts(part);
    if (part.whole_with >= 0) {
      move_whole(part);
    } else if (!is_pulled(part)) {
      part.is_settled = true;
    } else if (!part.is_settled) {
      bend(part, part.own_handles > 0 ? steps : std::max(1, steps / 2));
    }
  }
}

bool BendRig::is_settled() const {
  return std::all_of(parts_.begin(), parts_.end(),
                     [](Part const& part) { return part.is_settled; });
}

void BendRig::finish() {
  int vertices = 1;
  for (auto const& part : parts_) {
    if (part.whole_with < 0 && is_pulled(part)) vertices += static_cast<int>(std::ssize(part.pose));
  }
  int const rounds =
      std::clamp(kMostVertexSteps / (kStepsOfRound * vertices), kLeastRounds, kMostRounds);
  for (int i = 0; i < rounds && !is_settled(); ++i) step(kStepsOfRound);
  snap();
}

void BendRig::snap() {
  for (auto& part : parts_) {
    if (!part.is_moved || part.whole_with >= 0) continue;
    auto const& rest = part.part->rest_pose();
    if (farthest(part.pose, part.start) <= kSnapPx) {
      part.pose = part.start;
    } else if (farthest(part.pose, rest) <= kSnapPx) {
      part.pose = rest;
    }
  }
}

}  // namespace inkflate
