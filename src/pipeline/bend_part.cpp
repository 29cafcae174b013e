// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_part.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "pipeline/bend_hook.h"

namespace inkflate {
namespace {

// As many steps back find the rest pose again. Farther ones begin a new one, which nobody sees.
constexpr std::size_t kVersions = 64;

// A hand that takes hold as near as this to where it let go means the same place.
constexpr double kSamePlaceEdges = 3;

bool has_same_places(Stroke const& a, Stroke const& b) {
  return std::equal(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(),
                    [](Sample const& p, Sample const& q) { return p.position == q.position; });
}

bool has_same_places(StrokeList const& a, StrokeList const& b) {
  if (a.is_same(b)) return true;
  if (a.size() != b.size()) return false;
  auto const all = a.to_vector();
  auto const others = b.to_vector();
  return std::equal(all.begin(), all.end(), others.begin(),
                    [](Shared<KeptStroke> const& p, Shared<KeptStroke> const& q) {
                      return p == q || has_same_places(p->stroke, q->stroke);
                    });
}

Polyline line_of(Stroke const& stroke) {
  Polyline line;
  line.reserve(stroke.samples.size());
  for (auto const& sample : stroke.samples) line.push_back(sample.position);
  return line;
}

/// Strokes first, then the marks outside, then those inside.
BendShape shape_of(BendSource const& source) {
  if (!source.layer) return {{}, {line_of(source.stroke->stroke)}};
  auto const& layer = source.layer->layer;
  BendShape shape = {layer.outlines, {}};
  source.layer->strokes.for_each(
      [&](Shared<KeptStroke> const& kept) { shape.lines.push_back(line_of(kept->stroke)); });
  for (auto const* const marks : {&layer.choice.outside, &layer.choice.inside}) {
    for (auto const mark : *marks) shape.lines.push_back({mark});
  }
  return shape;
}

}  // namespace

Shared<DocumentLayer> layer_of(Document const& document, LayerId layer) {
  auto const index = layer_index(document, layer);
  return index ? (*document.layers)[static_cast<std::size_t>(*index)] : nullptr;
}

Shared<KeptStroke> stroke_of(Document const& document, StrokeRef const& stroke) {
  auto const layer = layer_of(document, stroke.layer);
  if (stroke.layer != LayerId::None && !layer) return nullptr;
  auto const& strokes = layer ? layer->strokes : document.loose;
  return stroke.index >= 0 && stroke.index < strokes.size() ? strokes[stroke.index] : nullptr;
}

bool has_same_shape(BendSource const& a, BendSource const& b) {
  if (a == b) return true;
  if (!a.layer || !b.layer) {
    return a.stroke && b.stroke && has_same_places(a.stroke->stroke, b.stroke->stroke);
  }
  auto const& first = a.layer->layer;
  auto const& second = b.layer->layer;
  return first.outlines == second.outlines && first.choice.outside == second.choice.outside &&
         first.choice.inside == second.choice.inside &&
         has_same_places(a.layer->strokes, b.layer->strokes);
}

BendPart::BendPart(BendSource source) : versions_{{source}}, now_{std::move(source)} {}

bool BendPart::meet(BendSource const& source) {
  // The newest first: it is nearly always the one.
  auto const find = [&](auto const& is_it) {
    return std::find_if(versions_.rbegin(), versions_.rend(),
                        [&](BendVersion const& version) { return is_it(version.source); });
  };
  auto known = find([&](BendSource const& other) { return other == source; });
  if (known == versions_.rend()) {
    known = find([&](BendSource const& other) { return has_same_shape(other, source); });
  }
  if (known == versions_.rend()) return false;
  auto version = *known;
  version.source = source;
  remember(std::move(version));
  return true;
}

void BendPart::remember(BendVersion version) {
  now_ = std::move(version);
  if (bender_ && now_.pose.empty()) now_.pose = rest_pose();
  if (bender_) anchor_pins();
  auto const is_it = [&](BendVersion const& known) { return known.source == now_.source; };
  auto const known = std::find_if(versions_.begin(), versions_.end(), is_it);
  if (known != versions_.end()) {
    *known = now_;
    return;
  }
  if (versions_.size() >= kVersions) versions_.erase(versions_.begin() + 1);
  versions_.push_back(now_);
}

BendAnchor BendPart::held_at(Vec2 place, bool is_inside) const {
  auto const under = is_inside ? bender_->under(now_.pose, place) : std::nullopt;
  return under ? *under : nearest(now_.pose, place);
}

void BendPart::leave_loose(BendAnchor const& place, BendPose from) {
  auto version = now_;
  version.loose_end = place;
  version.loose_from = std::move(from);
  remember(std::move(version));
}

bool BendPart::is_left_loose(std::optional<Vec2> place) const {
  if (!now_.loose_end) return false;
  auto const end = place_of(mesh().rest, now_.pose, *now_.loose_end);
  return !place || distance(*place, end) > kSamePlaceEdges * mesh().edge_px;
}

std::shared_ptr<BendPart> const& BendPart::begun_anew() {
  if (!anew_ || !anew_->meet(now_.source)) anew_ = std::make_shared<BendPart>(now_.source);
  return anew_;
}

std::optional<Error> BendPart::make_ready(BendOptions const& options) {
  if (!is_tried(options)) {
    auto made = Bender::make(shape_of(versions_.front().source), options);
    options_ = options;
    fault_.reset();
    if (made) {
      bender_ = std::move(made).value();
    } else {
      fault_ = made.error();
    }
  }
  if (fault_) return fault_;
  remember(now_);
  return std::nullopt;
}

void BendPart::anchor_pins() {
  if (!now_.source.layer) return;
  auto const known = std::exchange(now_.pins, {});
  auto const& pose = now_.pose.empty() ? rest_pose() : now_.pose;
  for (auto const& pin : now_.source.layer->layer.bend_pins) {
    auto const is_it = [&](HeldPin const& held) { return held.pin == pin; };
    auto const found = std::find_if(known.begin(), known.end(), is_it);
    if (found != known.end()) {
      now_.pins.push_back(*found);
      continue;
    }
    HeldPin held = {pin, bender_->nearest(pose, pin.position), {}, 0};
    held.beside = place_of(mesh().rest, pose, held.anchor) - pin.position;
    held.turn_base_rad = pin.turn_rad.value_or(0) - turn_at(mesh(), pose, held.anchor);
    now_.pins.push_back(held);
  }
}

Bend::Part BendPart::bent_layer(BendPose const& pose) const {
  auto bent = bender_->bent_on_grid(pose);
  auto const& source = *now_.source.layer;
  Bend::Part part = {source.layer.id, std::move(bent.outlines), {}, {}};
  for (std::size_t i = 0; i < bent.lines.size(); ++i) {
    auto& points = static_cast<int>(i) < source.strokes.size() ? part.samples : part.marks;
    points.insert(points.end(), bent.lines[i].begin(), bent.lines[i].end());
  }
  return part;
}

Bend::Line BendPart::bent_stroke(BendPose const& pose, StrokeRef const& stroke) const {
  return {stroke, bender_->bent_on_grid(pose).lines.front()};
}

bool BendPart::is_bent_to(BendSource const& source, BendPose const& pose) const {
  if (source.stroke) return line_of(source.stroke->stroke) == bent_stroke(pose, {}).samples;
  if (!source.layer) return false;
  auto const part = bent_layer(pose);
  std::vector<Vec2> samples;
  source.layer->strokes.for_each([&](Shared<KeptStroke> const& kept) {
    for (auto const& sample : kept->stroke.samples) samples.push_back(sample.position);
  });
  return source.layer->layer.outlines == part.outlines && samples == part.samples;
}

}  // namespace inkflate
