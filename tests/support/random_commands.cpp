// SPDX-License-Identifier: Apache-2.0
#include "support/random_commands.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "base/check.h"
#include "support/random_drawing.h"

namespace inkflate::test {
namespace {

constexpr double kSheetPx = 300;

Vec2 point_on_sheet(Rng& rng) { return {rng.uniform(0, kSheetPx), rng.uniform(0, kSheetPx)}; }

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

CloseChoice random_choice(Rng& rng) {
  CloseChoice choice;
  if (rng.below(2) == 0) choice.gap_px = rng.uniform(0.5, 50);
  for (auto* marks : {&choice.outside, &choice.inside}) {
    for (int i = rng.below(3); i > 0; --i) marks->push_back(point_on_sheet(rng));
  }
  return choice;
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
    if (!loose.empty()) {
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
    for (auto& ref : c.strokes) {
      spoil_index(ref.index);
      spoil(ref.layer);
    }
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
  void spoil(Layer& shape) {
    for (auto* list : {&shape.strokes, &shape.details, &shape.noise}) {
      for (int& stroke : *list) spoil_index(stroke);
    }
    if (rng_.below(4) == 0) shape.outlines.clear();
    for (auto& outline : shape.outlines) {
      for (auto& piece : outline.pieces) spoil(piece.curve.control[0]);
      for (auto& source : outline.sources) spoil_index(source.stroke);
    }
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

/// Pins, a clip and states of the layers for what random_drawing has made.
void dress(Rng& rng, Project& project) {
  for (auto& layer : project.drawing.layers) {
    layer.id = static_cast<LayerId>(project.next_id++);
    layer.is_open = rng.below(3) == 0;
    layer.is_locked = rng.below(6) == 0;
    layer.is_hidden = rng.below(6) == 0;
    layer.choice = random_choice(rng);
    if (!layer.details.empty() && rng.below(2) == 0) {
      layer.noise.push_back(layer.details.back());
      layer.details.pop_back();
    }
  }
  project.drawing.choice = random_choice(rng);
  project.clip.length_s = rng.below(2) == 0 ? 0 : rng.uniform(0.5, 5);
  int const layer_count = static_cast<int>(std::ssize(project.drawing.layers));
  for (int i = layer_count > 0 ? rng.below(4) : 0; i > 0; --i) {
    auto const& layer = project.drawing.layers[static_cast<std::size_t>(rng.below(layer_count))];
    auto const id = static_cast<PinId>(project.next_id++);
    project.pins.push_back({id, layer.id, rng.below(2) == 0 ? Side::Front : Side::Back,
                            point_on_sheet(rng), point_on_sheet(rng)});
    if (rng.below(2) == 0) {
      project.clip.tracks.push_back({id, {{0, point_on_sheet(rng)}}, rng.uniform(-1, 1)});
    }
  }
  if (rng.below(3) == 0) project.template_picture = Picture(2, 3, Colour{1, 2, 3});
}

}  // namespace

Document random_document(Rng& rng) {
  Project project = {random_drawing(rng)};
  dress(rng, project);
  auto document = make_document(project);
  CHECK(document.has_value(), "a random document is a document");
  return std::move(document).value();
}

Command random_command(Rng& rng, Document const& document, int kind, Wish wish) {
  Sensible sensible(rng, document);
  auto command =
      sensible_command(sensible, kind, std::make_index_sequence<std::variant_size_v<Command>>());
  if (wish == Wish::Hostile) {
    Spoiler spoiler(rng);
    std::visit([&](auto& one) { spoiler.spoil(one); }, command);
  }
  return command;
}

Command random_command(Rng& rng, Document const& document) {
  auto const wish = rng.below(10) == 0 ? Wish::Hostile : Wish::Sensible;
  // Strokes are what all else is made of.
  int const kind = rng.below(kCommandKinds + 10);
  return random_command(rng, document, kind < kCommandKinds ? kind : 0, wish);
}

}  // namespace inkflate::test
