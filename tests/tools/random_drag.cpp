// SPDX-License-Identifier: Apache-2.0
#include "tools/random_drag.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "base/check.h"
#include "document/apply.h"
#include "geometry/crossings.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

constexpr int kFrames = 20;
constexpr int kStepsOfFrame = 2;     // of the body
constexpr int kWireIterations = 10;  // of a frame
constexpr int kStepsToRest = 60;
constexpr int kStepsOfRound = 4;

// Sides of one limb are nearer than this at rest, px; and at least so many times as far along the contour.
constexpr double kLimbPx = 130;
constexpr double kAround = 2;

// Who presses so near to a pin takes the pin.
constexpr double kPinReachPx = 10;

double processor_ms() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Vec2 random_place(BendMesh const& mesh, Rng& rng) {
  auto const& line = mesh.lines[0].vertices;
  return mesh.rest.points[line[rng.below(static_cast<int>(std::ssize(line)))]];
}

std::vector<BendHandle> handles_of(Bender const& bender, RandomDrag const& drag, double share) {
  std::vector<BendHandle> handles;
  for (auto const pin : drag.pins) {
    handles.push_back({bender.nearest(bender.rest_pose(), pin), pin, {}});
  }
  auto const to = lerp(drag.from, drag.to, share);
  handles.push_back({bender.nearest(bender.rest_pose(), drag.from), to, {}});
  return handles;
}

}  // namespace

RandomDrag random_drag(BendMesh const& mesh, int pins, double length_px, Rng& rng) {
  RandomDrag drag;
  for (int i = 0; i < pins; ++i) {
    bool const is_twin = i > 0 && rng.below(10) == 0;
    drag.pins.push_back(is_twin ? drag.pins.back() : random_place(mesh, rng));
  }
  auto const is_on_pin = [&](Vec2 pin) { return distance(drag.from, pin) <= kPinReachPx; };
  do {
    drag.from = random_place(mesh, rng);
  } while (std::any_of(drag.pins.begin(), drag.pins.end(), is_on_pin));
  auto const turn = sin_cos(rng.uniform(-kPi, kPi));
  drag.to = drag.from + Vec2{turn.cos, turn.sin} * length_px;
  return drag;
}

BendPose dragged_by_needle(Bender& bender, RandomDrag const& drag, BendMode mode) {
  auto pose = bender.rest_pose();
  bool const is_body = mode == BendMode::Body;
  for (int frame = 1; frame <= kFrames; ++frame) {
    auto const handles = handles_of(bender, drag, static_cast<double>(frame) / kFrames);
    bender.step(pose, {handles, {}}, is_body ? kStepsOfFrame : kWireIterations);
  }
  auto const handles = handles_of(bender, drag, 1);
  // The wire gets what the thesis gives it after a drag: five frames more.
  bender.step(pose, {handles, {}}, is_body ? kStepsToRest : 5 * kWireIterations);
  return pose;
}

DeformedPart::DeformedPart(Document document)
    : document_(std::move(document)),
      part_(std::make_shared<BendPart>(BendSource{document_.layers->front(), {}})),
      joints_(std::make_unique<BendJoints>()),
      parts_(std::make_unique<BendParts>()) {
  (*parts_)[document_.layers->front()->layer.id] = part_;
}

Result<DeformedPart> DeformedPart::make(std::vector<Outline> outlines, BendOptions const& options) {
  DocumentLayer layer;
  layer.layer.id = LayerId{1};
  layer.layer.outlines = std::move(outlines);
  auto document = empty_document();
  std::vector<Shared<DocumentLayer>> layers;
  layers.push_back(std::make_shared<DocumentLayer const>(std::move(layer)));
  document.layers = std::make_shared<std::vector<Shared<DocumentLayer>> const>(std::move(layers));
  document.next_id = 2;
  DeformedPart part(std::move(document));
  if (auto error = part.part_->make_ready(options)) return *error;
  return part;
}

void DeformedPart::drag(RandomDrag const& drag) {
  rig_ = std::make_unique<BendRig>(std::vector<BendRoot>{{part_, {}}}, std::vector<LayerId>{},
                                   *parts_, *joints_);
  auto const& rest = part_->rest_pose();
  for (auto const pin : drag.pins) {
    rig_->hold(0, part_->nearest(rest, pin));
    targets_.push_back(pin);
  }
  int const handle = rig_->hold(0, part_->nearest(rest, drag.from));
  targets_.push_back(drag.to);
  for (int frame = 1; frame <= kFrames; ++frame) {
    rig_->move(0, handle, lerp(drag.from, drag.to, static_cast<double>(frame) / kFrames), {});
    rig_->step(kStepsOfFrame);
  }
}

double DeformedPart::finish() {
  double const begun_ms = processor_ms();
  rig_->finish();
  return processor_ms() - begun_ms;
}

void DeformedPart::settle(int steps) {
  for (int done = 0; done < steps && !rig_->is_settled(); done += kStepsOfRound) {
    rig_->step(kStepsOfRound);
  }
}

double DeformedPart::farthest_handle_px() const {
  double most = 0;
  for (int i = 0; i < std::ssize(targets_); ++i) {
    most = std::max(most, distance(rig_->end(0, i), targets_[static_cast<std::size_t>(i)]));
  }
  return most;
}

BendPose DeformedPart::pose() const {
  auto const commands = rig_->commands();
  if (commands.empty()) return part_->rest_pose();
  auto const result = inkflate::apply(document_, commands);
  CHECK(result.has_value(), "a bend that the document takes");
  rig_->remember(*result);
  return part_->now().pose;
}

Contour contour_of(BendMesh const& mesh, std::vector<Vec2> const& pose) {
  Contour contour;
  for (int const v : mesh.lines[0].vertices) contour.push_back(pose[v]);
  return contour;
}

SelfCrossings self_crossings(BendMesh const& mesh, BendPose const& pose) {
  std::vector<Contour> const contours = {contour_of(mesh, pose)};
  auto const rest = contour_of(mesh, mesh.rest.points);
  std::vector<double> along = {0};
  for (std::size_t i = 0; i < rest.size(); ++i) {
    along.push_back(along.back() + distance(rest[i], rest[(i + 1) % rest.size()]));
  }
  SelfCrossings result;
  for (auto const& crossing : find_crossings(contours, 1000)) {
    auto const a = static_cast<std::size_t>(crossing.edge_a);
    auto const b = static_cast<std::size_t>(crossing.edge_b);
    double const apart = distance(rest[a], rest[b]);
    double const one_way = std::abs(along[a] - along[b]);
    bool const is_one_side = std::min(one_way, along.back() - one_way) < kAround * apart;
    bool const is_inside = winding_number(rest, lerp(rest[a], rest[b], 0.5)) != 0;
    if (apart >= kLimbPx) {
      result.has_limbs = true;
    } else if (is_one_side) {
      result.has_kinks = true;
    } else {
      (is_inside ? result.has_sides : result.has_limbs) = true;
    }
  }
  return result;
}

}  // namespace inkflate
