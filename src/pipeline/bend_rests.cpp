// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_rests.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace inkflate {
namespace {

// Rough strokes whose rest is known; others begin a new one.
constexpr std::size_t kStrokes = 64;

// Of the longer side of all that is drawn: a limb that is a part by itself need not be bent more finely than one that is not.
constexpr double kLeastEdge = 1.0 / 200;

// Meshes of so many vertices wait for a press, about 1 kB each: those of 30 large parts or of hundreds of small ones.
constexpr std::ptrdiff_t kPreparedVertices = 48'000;

bool has_outline(Layer const& layer) {
  return !layer.outlines.empty() && !layer.outlines.front().pieces.empty();
}

Error not_there() { return {ErrorCode::BadInput, "there is no such part or stroke to bend"}; }

std::optional<Error> fault_of(Layer const& layer) {
  auto const index = static_cast<long long>(layer.id);
  if (layer.is_locked)
    return Error{ErrorCode::BadInput, "the part is locked: unlock it first", index};
  if (layer.is_hidden)
    return Error{ErrorCode::BadInput, "the part is hidden: show it first", index};
  return std::nullopt;
}

double longer_side_px(Document const& document) {
  Rect box;
  for (auto const& layer : *document.layers) {
    for (auto const& outline : layer->layer.outlines) {
      for (auto const& piece : outline.pieces) box = united(box, bounds(piece.curve.control));
    }
  }
  return box.is_empty() ? 0 : box.longer_side();
}

}  // namespace

std::optional<Error> BendRests::make_ready(BendPart& part, BendOptions options) const {
  options.least_edge_px = least_edge_px_;
  return part.make_ready(options);
}

bool BendRests::prepare_one(Document const& document, BendParts const& parts,
                            BendOptions const& options) const {
  std::ptrdiff_t vertices = 0;
  for (auto layer = document.layers->rbegin(); layer != document.layers->rend(); ++layer) {
    auto const part = parts.find((*layer)->layer.id);
    if (part == parts.end() || fault_of((*layer)->layer)) continue;
    if (vertices > kPreparedVertices) break;
    if (part->second->is_ready()) vertices += std::ssize(part->second->mesh().rest.points);
    if (part->second->is_tried(options)) continue;
    make_ready(*part->second, options);
    return true;
  }
  return false;
}

bool BendRests::prepare(Document const& document, BendOptions const& options) {
  if (prepare_one(document, parts_, options)) return true;
  joints_.anchor(parts_);
  if (joints_.find(document)) return true;
  return prepare_anew(document, options);
}

/// The same for the press that takes another place than the last one.
bool BendRests::prepare_anew(Document const& document, BendOptions const& options) {
  for (auto const& stroke : strokes_) {
    if (!stroke->is_left_loose({}) || stroke->begun_anew()->is_tried(options)) continue;
    make_ready(*stroke->begun_anew(), options);
    return true;
  }
  Joined anew = {parts_, joints_};
  for (auto& [layer, part] : anew.parts) {
    if (part->is_left_loose({})) part = std::shared_ptr(part->begun_anew());
  }
  bool const is_known = anew_ && anew_->parts == anew.parts;
  if (is_known || anew.parts == parts_) return false;
  if (prepare_one(document, anew.parts, options)) return true;
  anew.joints.meet(document, anew.parts);
  anew.joints.anchor(anew.parts);
  anew_ = std::move(anew);
  return true;
}

void BendRests::meet(Document const& document, BendRests const& copy) {
  // As at the first time, or meshes would depend on what was bent before them.
  if (parts_.empty()) least_edge_px_ = kLeastEdge * longer_side_px(document);
  std::set<LayerId> there;
  for (auto const& layer : *document.layers) {
    if (!has_outline(layer->layer)) continue;
    there.insert(layer->layer.id);
    BendSource const source = {layer, {}};
    auto& part = parts_[layer->layer.id];
    if (part && part->meet(source)) continue;
    auto const spare = copy.parts_.find(layer->layer.id);
    bool const has_spare = spare != copy.parts_.end() && spare->second &&
                           copy.least_edge_px_ == least_edge_px_ && spare->second->meet(source);
    part = has_spare ? spare->second : std::make_shared<BendPart>(source);
  }
  // Or what somebody duplicates and deletes would pile up.
  std::erase_if(parts_, [&](auto const& part) { return there.count(part.first) == 0; });
  anew_.reset();
  joints_.meet(document, parts_);
}

void BendRests::set_loose_ends(Document const& document, BendSource const& held,
                               std::optional<Vec2> by) {
  auto const set = [&](std::shared_ptr<BendPart>& part) {
    auto const& source = part->now().source;
    bool const is_held = source == held;
    if (is_held ? part->is_left_loose(by) : part->is_left_loose({})) {
      part = std::shared_ptr(part->begun_anew());
    }
  };
  for (auto& [layer, part] : parts_) set(part);
  for (auto& part : strokes_) set(part);
  if (anew_ && anew_->parts == parts_) joints_ = std::move(anew_->joints);
  anew_.reset();
  // Joints lie in meshes: those of a part that has begun anew are found anew.
  joints_.meet(document, parts_);
}

Result<BendRoot> BendRests::root(Document const& document, LayerId layer,
                                 BendOptions const& options) {
  auto const found = layer_of(document, layer);
  if (!found) return not_there();
  if (auto const fault = fault_of(found->layer)) return *fault;
  auto const part = parts_.find(layer);
  if (part == parts_.end()) {
    return Error{ErrorCode::NothingThere, "the part has no outline yet: close it first",
                 static_cast<long long>(layer)};
  }
  if (auto const fault = make_ready(*part->second, options)) return *fault;
  return BendRoot{part->second, {}};
}

Result<BendRoot> BendRests::root(Document const& document, StrokeRef const& stroke,
                                 BendOptions const& options) {
  auto const found = stroke_of(document, stroke);
  if (!found) return not_there();
  if (auto const layer = layer_of(document, stroke.layer)) {
    if (auto const fault = fault_of(layer->layer)) return *fault;
    if (has_outline(layer->layer)) return root(document, stroke.layer, options);
    if (!layer->layer.is_open) return not_there();
  }
  BendSource const source = {{}, found};
  auto known = std::find_if(strokes_.begin(), strokes_.end(),
                            [&](auto const& part) { return part->meet(source); });
  auto const part = known != strokes_.end() ? *known : std::make_shared<BendPart>(source);
  if (auto const fault = make_ready(*part, options)) return *fault;
  if (known != strokes_.end()) strokes_.erase(known);
  strokes_.push_back(part);
  if (strokes_.size() > kStrokes) strokes_.erase(strokes_.begin());
  return BendRoot{part, stroke};
}

BendRig BendRests::rig(Document const& document, std::vector<BendRoot> const& roots,
                       BendOptions const& options) {
  std::vector<LayerId> layers;
  for (auto const& root : roots) {
    if (!root.stroke) layers.push_back(root.part->now().source.layer->layer.id);
  }
  std::set<LayerId> locked;
  for (auto const& layer : *document.layers) {
    if (layer->layer.is_locked) locked.insert(layer->layer.id);
  }
  auto hanging = hanging_layers(layers, joints_, locked);
  std::erase_if(hanging,
                [&](LayerId layer) { return make_ready(*parts_.at(layer), options).has_value(); });
  joints_.anchor(parts_);
  return BendRig(roots, hanging, parts_, joints_);
}

}  // namespace inkflate
