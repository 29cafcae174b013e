// SPDX-License-Identifier: Apache-2.0
#include "support/random_commands.h"

#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "document/transform.h"
#include "support/random_document.h"
#include "support/spoil_command.h"

namespace inkflate::test {
namespace {

Stroke walk(Rng& rng, int group_count) {
  Stroke stroke;
  Vec2 position = point_on_sheet(rng);
  bool const has_time = rng.below(2) == 0;
  for (int i = 0, count = 1 + rng.below(10); i < count; ++i) {
    stroke.samples.push_back({position, rng.uniform(), has_time ? 0.01 * i : 0});
    position += Vec2{rng.uniform(-20, 20), rng.uniform(-20, 20)};
  }
  stroke.kind = rng.below(4) == 0 ? StrokeKind::HelpLine : StrokeKind::Ink;
  stroke.width_px = rng.uniform(0.5, 9);
  stroke.colour.r = static_cast<std::uint8_t>(rng.below(256));
  stroke.depth = rng.below(3) == 0 ? StrokeDepth::Far : StrokeDepth::Near;
  stroke.group = rng.below(group_count + 1) - 1;
  return stroke;
}

/// A shape of bent sides that names strokes of the chosen ones.
Layer random_shape(Rng& rng, std::vector<int> const& chosen) {
  Layer shape;
  shape.name = "shape " + std::to_string(rng.below(100));
  shape.thickness = rng.uniform(kLeastThickness, kLargestThickness);
  shape.choice = random_choice(rng);
  Vec2 const corner = point_on_sheet(rng);
  double const side_px = rng.uniform(5, 100);
  Vec2 const corners[] = {corner, corner + Vec2{side_px, 0}, corner + Vec2{side_px, side_px}};
  Outline outline;
  for (int i = 0; i < 3; ++i) {
    Cubic curve = line_cubic(corners[i], corners[(i + 1) % 3]);
    curve.control[1] += Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)};
    outline.pieces.push_back({curve, static_cast<RunKind>(rng.below(3))});
  }
  for (int const stroke : chosen) {
    std::vector<int>* const lists[] = {&shape.strokes, &shape.details, &shape.noise};
    int const list = rng.below(4);  // 3: none
    if (list < 3) lists[list]->push_back(stroke);
    if (list == 0) outline.sources.push_back({0, rng.uniform(0.1, 3), stroke, 1, 0});
  }
  shape.outlines.push_back(std::move(outline));
  return shape;
}

Affine random_shear(Rng& rng) {
  return {1, rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), 1, rng.uniform(-9, 9), 2};
}

std::vector<Vec2> places(KeptStroke const& kept, Affine const& map) {
  std::vector<Vec2> positions;
  for (auto const& sample : kept.stroke.samples) positions.push_back(map(sample.position));
  return positions;
}

Bend::Part bent(DocumentLayer const& layer, Affine const& map) {
  auto const moved = transformed(layer.layer, map);
  Bend::Part part = {moved.id, moved.outlines, {}, moved.choice.outside};
  part.marks.insert(part.marks.end(), moved.choice.inside.begin(), moved.choice.inside.end());
  layer.strokes.for_each([&](Shared<KeptStroke> const& kept) {
    auto const samples = places(*kept, map);
    part.samples.insert(part.samples.end(), samples.begin(), samples.end());
  });
  return part;
}

/// Picks what a sensible command of each kind needs from a document. Where there is nothing to pick from, the command will be refused.
class Sensible {
 public:
  Sensible(Rng& rng, Document const& document) : rng_(rng), document_(document) {}

  AddStroke make(AddStroke*) {
    int const group_count = static_cast<int>(std::ssize(*document_.groups));
    return {walk(rng_, group_count), rng_.below(3) == 0 ? open_layer() : LayerId::None};
  }

  EraseArea make(EraseArea*) {
    EraseArea command = {{point_on_sheet(rng_)}, rng_.uniform(1, 30)};
    for (int i = rng_.below(4); i > 0; --i) command.path.push_back(point_on_sheet(rng_));
    return command;
  }

  EraseStrokes make(EraseStrokes*) {
    auto const layer = rng_.below(2) == 0 ? open_layer() : LayerId::None;
    auto const* const kept = find_layer(document_, layer);
    int const count = kept == nullptr ? document_.loose.size() : kept->strokes.size();
    EraseStrokes command;
    for (int const index : some_of(count)) {
      command.strokes.push_back({kept == nullptr ? LayerId::None : layer, index});
    }
    return command;
  }

  Simplify make(Simplify*) {
    Simplify command;
    if (auto const layer = open_layer(); layer != LayerId::None) {
      auto const* const kept = find_layer(document_, layer);
      std::vector<int> all(static_cast<std::size_t>(kept->strokes.size()));
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
      command.sets.push_back({layer, {}, StrokeDepth::Near, {random_shape(rng_, all)}});
    }
    auto const loose = some_of(document_.loose.size());
    if (!loose.empty() && rng_.below(3) == 0) {
      command.details.push_back({layer(), loose});
    } else if (!loose.empty()) {
      auto const depth = rng_.below(2) == 0 ? StrokeDepth::Near : StrokeDepth::Far;
      command.sets.push_back({LayerId::None, loose, depth, {random_shape(rng_, loose)}});
      if (rng_.below(2) == 0) command.sets.back().shapes.push_back(random_shape(rng_, loose));
    }
    return command;
  }

  OpenLayer make(OpenLayer*) { return {layer()}; }
  RedrawLayer make(RedrawLayer*) { return {layer()}; }
  CloseLayer make(CloseLayer*) { return {open_layer()}; }
  DeleteLayers make(DeleteLayers*) { return {some_layers()}; }

  DuplicateLayer make(DuplicateLayer*) {
    auto const end = rng_.below(2) == 0 ? OrderEnd::Back : OrderEnd::Front;
    return {layer(), end, rng_.below(2) == 0 ? Vec2{} : Vec2{rng_.uniform(-9, 9), 5}};
  }

  SetLayerOrder make(SetLayerOrder*) {
    SetLayerOrder command;
    for (auto const& each : *document_.layers) command.back_to_front.push_back(each->layer.id);
    auto& order = command.back_to_front;
    for (int i = static_cast<int>(std::ssize(order)) - 1; i > 0; --i) {
      std::swap(order[static_cast<std::size_t>(i)],
                order[static_cast<std::size_t>(rng_.below(i + 1))]);
    }
    return command;
  }

  TransformLayers make(TransformLayers*) {
    Affine const maps[] = {Affine::translation({rng_.uniform(-30, 30), rng_.uniform(-30, 30)}),
                           Affine::scaling(rng_.uniform(0.7, 1.4), rng_.uniform(0.7, 1.4)),
                           {-1, 0, 0, 1, kSheetPx, 0},
                           {0.8, 0.6, -0.6, 0.8, 3, -2}};
    TransformLayers command = {{}, maps[rng_.below(4)]};
    if (rng_.below(3) != 0) command.layers = some_layers();
    return command;
  }

  Bend make(Bend*) {
    Bend command;
    for (auto const id : some_layers()) {
      command.parts.push_back(bent(*find_layer(document_, id), random_shear(rng_)));
    }
    if (document_.loose.is_empty() || rng_.below(2) == 0) return command;
    auto const map = random_shear(rng_);
    for (int const index : some_of(document_.loose.size())) {
      command.lines.push_back({{LayerId::None, index}, places(*document_.loose[index], map)});
    }
    return command;
  }
  SetBendPins make(SetBendPins*) {
    SetBendPins command = {layer(), {}};
    for (int i = rng_.below(4); i > 0; --i) command.pins.push_back({point_on_sheet(rng_)});
    if (!command.pins.empty()) command.pins.back().turn_rad = rng_.uniform(-3, 3);
    return command;
  }

  RenameLayer make(RenameLayer*) { return {layer(), "name " + std::to_string(rng_.bits())}; }
  SetThickness make(SetThickness*) {
    return {layer(), rng_.uniform(kLeastThickness, kLargestThickness)};
  }
  SetFill make(SetFill*) {
    SetFill command = {layer(), {}};
    if (rng_.below(3) != 0) command.fill = Colour{9, static_cast<std::uint8_t>(rng_.below(256)), 7};
    return command;
  }
  SetHidden make(SetHidden*) { return {layer(), rng_.below(2) == 0}; }
  SetLocked make(SetLocked*) { return {layer(), rng_.below(4) == 0}; }
  SetChoice make(SetChoice*) {
    return {rng_.below(2) == 0 ? layer() : LayerId::None, random_choice(rng_)};
  }
  SetTemplate make(SetTemplate*) {
    if (rng_.below(2) == 0) return {};
    Colour const colour = {static_cast<std::uint8_t>(rng_.below(256))};
    return {std::make_shared<Picture const>(1 + rng_.below(4), 1 + rng_.below(4), colour)};
  }
  SetCanvas make(SetCanvas*) { return {rng_.uniform(1, 2000), 1.0 + rng_.below(16384)}; }

  AddPin make(AddPin*) {
    auto const side = rng_.below(2) == 0 ? Side::Front : Side::Back;
    return {{PinId::None, layer(), side, point_on_sheet(rng_), point_on_sheet(rng_)}};
  }
  MovePins make(MovePins*) {
    MovePins command = {some_pins(), {}};
    for (std::size_t i = 0; i < command.pins.size(); ++i) {
      command.positions.push_back(point_on_sheet(rng_));
    }
    return command;
  }
  DeletePins make(DeletePins*) { return {some_pins()}; }
  SetTrack make(SetTrack*) {
    SetTrack command = {{pin(), {}, rng_.uniform(-1, 1)}};
    double const length_s = document_.clip->length_s;
    for (int i = 0, count = rng_.below(6); i < count; ++i) {
      double const time_s = length_s * i / count;
      if (i == 0 || time_s > command.track.keys.back().time_s) {
        command.track.keys.push_back({time_s, point_on_sheet(rng_)});
      }
    }
    return command;
  }
  SetClipLength make(SetClipLength*) { return {rng_.uniform(0, 10)}; }
  Replace make(Replace*) { return {random_document(rng_)}; }

 private:
  /// Ascending; a third of them, at least one where there is any.
  std::vector<int> some_of(int count) {
    std::vector<int> chosen;
    for (int i = 0; i < count; ++i) {
      if (rng_.below(3) == 0) chosen.push_back(i);
    }
    if (chosen.empty() && count > 0) chosen.push_back(rng_.below(count));
    return chosen;
  }

  std::vector<LayerId> some_layers() {
    std::vector<LayerId> ids;
    for (int const i : some_of(static_cast<int>(std::ssize(*document_.layers)))) {
      auto const& chosen = (*document_.layers)[static_cast<std::size_t>(i)]->layer;
      if (!chosen.is_locked) ids.push_back(chosen.id);
    }
    return ids;
  }

  std::vector<PinId> some_pins() {
    std::vector<PinId> ids;
    for (int const i : some_of(static_cast<int>(std::ssize(*document_.pins)))) {
      ids.push_back((*document_.pins)[static_cast<std::size_t>(i)].id);
    }
    return ids;
  }

  LayerId layer() {
    auto const& layers = *document_.layers;
    if (layers.empty()) return LayerId::None;
    return layers[static_cast<std::size_t>(rng_.below(static_cast<int>(std::ssize(layers))))]
        ->layer.id;
  }

  LayerId open_layer() {
    std::vector<LayerId> open;
    for (auto const& each : *document_.layers) {
      if (each->layer.is_open && !each->layer.is_locked) open.push_back(each->layer.id);
    }
    if (open.empty()) return LayerId::None;
    return open[static_cast<std::size_t>(rng_.below(static_cast<int>(std::ssize(open))))];
  }

  PinId pin() {
    auto const pins = some_pins();
    return pins.empty() ? PinId::None : pins.front();
  }

  Rng& rng_;
  Document const& document_;
};

/// The command of this kind, made by make(); loops over the kinds by an index sequence.
template <std::size_t... Kinds>
Command sensible_command(Sensible& sensible, int kind, std::index_sequence<Kinds...> /*all*/) {
  Command command;
  auto const make = [&](auto kind_constant) {
    using Kind = std::variant_alternative_t<decltype(kind_constant)::value, Command>;
    if (static_cast<int>(decltype(kind_constant)::value) != kind) return;
    command = sensible.make(static_cast<Kind*>(nullptr));
  };
  (make(std::integral_constant<std::size_t, Kinds>()), ...);
  return command;
}

}  // namespace

Command random_command(Rng& rng, Document const& document, int kind, Wish wish) {
  Sensible sensible(rng, document);
  auto command =
      sensible_command(sensible, kind, std::make_index_sequence<std::variant_size_v<Command>>());
  if (wish == Wish::Hostile) spoil_command(rng, command);
  return command;
}

Command random_command(Rng& rng, Document const& document) {
  auto const wish = rng.below(10) == 0 ? Wish::Hostile : Wish::Sensible;
  // Strokes are what all else is made of.
  int const kind = rng.below(kCommandKinds + 10);
  return random_command(rng, document, kind < kCommandKinds ? kind : 0, wish);
}

}  // namespace inkflate::test
