// SPDX-License-Identifier: Apache-2.0
#include "support/spoil_command.h"

#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "document/apply.h"

namespace inkflate::test {
namespace {

/// Spoils one value or more of a sensible command.
class Spoiler {
 public:
  explicit Spoiler(Rng& rng) : rng_(rng) {}

  void spoil(AddStroke& c) {
    if (rng_.below(4) == 0) c.stroke.samples.clear();
    for (auto& sample : c.stroke.samples) {
      spoil(sample.position);
      spoil(sample.pressure);
      spoil(sample.time_s);
    }
    spoil(c.stroke.width_px);
    spoil_index(c.stroke.group);
    spoil(c.layer);
  }
  void spoil(EraseArea& c) {
    spoil_list(c.path);
    spoil(c.radius_px);
  }
  void spoil(EraseStrokes& c) {
    if (!c.strokes.empty() && rng_.below(3) == 0) c.strokes.push_back(c.strokes.front());
    for (auto& ref : c.strokes) spoil(ref);
  }
  void spoil(Simplify& c) {
    if (!c.sets.empty() && rng_.below(4) == 0) c.sets.push_back(c.sets.front());
    for (auto& set : c.sets) {
      spoil(set.layer);
      for (int& stroke : set.strokes) spoil_index(stroke);
      if (rng_.below(4) == 0) set.shapes.clear();
      for (auto& shape : set.shapes) spoil(shape);
    }
  }
  void spoil(DeleteLayers& c) { spoil_list(c.layers); }
  void spoil(DuplicateLayer& c) {
    spoil(c.layer);
    spoil(c.offset);
  }
  void spoil(SetLayerOrder& c) { spoil_list(c.back_to_front); }
  void spoil(TransformLayers& c) {
    spoil_list(c.layers);
    for (auto* value : {&c.map.a, &c.map.b, &c.map.c, &c.map.d, &c.map.e, &c.map.f}) spoil(*value);
    if (rng_.below(3) == 0) c.map = Affine::scaling(0, 0);
  }
  void spoil(Bend& c) {
    if (!c.parts.empty() && rng_.below(4) == 0) c.parts.push_back(c.parts.front());
    if (!c.lines.empty() && rng_.below(4) == 0) c.lines.push_back(c.lines.front());
    for (auto& part : c.parts) {
      spoil(part.layer);
      spoil_list(part.outlines);
      spoil_list(part.samples);
      spoil_list(part.marks);
    }
    for (auto& line : c.lines) {
      spoil(line.stroke);
      spoil_list(line.samples);
    }
  }
  void spoil(SetBendPins& c) {
    spoil(c.layer);
    for (auto& pin : c.pins) {
      spoil(pin.position);
      if (pin.turn_rad) spoil(*pin.turn_rad);
    }
    if (!c.pins.empty() && rng_.below(4) == 0) c.pins.resize(DocumentLimits::kBendPins + 1);
  }
  void spoil(RenameLayer& c) {
    spoil(c.layer);
    c.name = rng_.below(2) == 0 ? std::string(300, 'x') : std::string("\xff\xc0\x80");
  }
  void spoil(SetThickness& c) {
    spoil(c.layer);
    spoil(c.thickness);
  }
  void spoil(SetChoice& c) {
    spoil(c.layer);
    if (c.choice.gap_px) spoil(*c.choice.gap_px);
    spoil_list(c.choice.inside);
  }
  void spoil(SetTemplate& c) { c.picture = std::make_shared<Picture const>(); }
  void spoil(SetCanvas& c) {
    spoil(c.width_px);
    spoil(c.height_px);
  }
  void spoil(AddPin& c) {
    spoil(c.pin.layer);
    spoil(c.pin.rest);
    spoil(c.pin.position);
  }
  void spoil(MovePins& c) {
    spoil_list(c.pins);
    spoil_list(c.positions);
  }
  void spoil(DeletePins& c) { spoil_list(c.pins); }
  void spoil(SetTrack& c) {
    spoil(c.track.pin);
    spoil(c.track.phase_s);
    for (auto& key : c.track.keys) {
      spoil(key.time_s);
      spoil(key.position);
    }
  }
  void spoil(SetClipLength& c) { spoil(c.length_s); }
  void spoil(Replace& c) { c.document.layers = nullptr; }
  /// What holds a layer and nothing else that could be wrong.
  template <typename OfLayer>
  void spoil(OfLayer& c) {
    spoil(c.layer);
  }

 private:
  void spoil(double& value) {
    double const hostile[] = {0,
                              -1,
                              1e300,
                              -1e300,
                              1e-300,
                              1e6 + 1,
                              std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()};
    if (rng_.below(4) == 0) value = hostile[rng_.below(8)];
  }
  void spoil(Vec2& p) {
    spoil(p.x);
    spoil(p.y);
  }
  void spoil(LayerId& id) { spoil_id(id); }
  void spoil(PinId& id) { spoil_id(id); }
  void spoil(StrokeRef& ref) {
    spoil_index(ref.index);
    spoil(ref.layer);
  }
  void spoil(Outline& outline) {
    for (auto& piece : outline.pieces) spoil(piece.curve.control[0]);
    for (auto& source : outline.sources) spoil_index(source.stroke);
  }
  void spoil(Layer& shape) {
    for (auto* list : {&shape.strokes, &shape.details, &shape.noise}) {
      for (int& stroke : *list) spoil_index(stroke);
    }
    if (rng_.below(4) == 0) shape.outlines.clear();
    for (auto& outline : shape.outlines) spoil(outline);
    spoil(shape.thickness);
  }

  template <typename Id>
  void spoil_id(Id& id) {
    int number = static_cast<int>(id);
    spoil_index(number);
    id = static_cast<Id>(number);
  }
  void spoil_index(int& index) {
    int const hostile[] = {
        -1, 0, 1'000'000, -7, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
    if (rng_.below(4) == 0) index = hostile[rng_.below(6)];
  }
  template <typename Item>
  void spoil_list(std::vector<Item>& list) {
    for (auto& item : list) spoil(item);
    if (!list.empty() && rng_.below(4) == 0) list.push_back(list.front());
    if (rng_.below(4) == 0) list.clear();
  }

  Rng& rng_;
};

}  // namespace

void spoil_command(Rng& rng, Command& command) {
  Spoiler spoiler(rng);
  std::visit([&](auto& one) { spoiler.spoil(one); }, command);
}

}  // namespace inkflate::test
