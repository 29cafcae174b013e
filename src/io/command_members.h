// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "document/command.h"

namespace inkflate {

/// The name of each command in JSON and its members: one list for the writer and the reader. `each` is called with the name and
/// the member; both are templates, so that a writer sees members that it cannot change.
template <typename C>
struct CommandText;

inline std::string_view word(OrderEnd end) { return end == OrderEnd::Back ? "back" : "front"; }

template <>
struct CommandText<AddStroke> {
  static constexpr std::string_view kName = "add_stroke";
  static void members(auto& each, auto& command) {
    each("layer", command.layer);
    each("stroke", command.stroke);
  }
};

template <>
struct CommandText<EraseArea> {
  static constexpr std::string_view kName = "erase_area";
  static void members(auto& each, auto& command) {
    each("radius", command.radius_px);
    each("path", command.path);
  }
};

template <>
struct CommandText<EraseStrokes> {
  static constexpr std::string_view kName = "erase_strokes";
  static void members(auto& each, auto& command) { each("strokes", command.strokes); }
};

template <>
struct CommandText<Simplify> {
  static constexpr std::string_view kName = "simplify";
  static void members(auto& each, auto& command) {
    each("sets", command.sets);
    each("details", command.details);
  }
};

/// Of the commands that have nothing but a layer.
struct LayerMember {
  static void members(auto& each, auto& command) { each("layer", command.layer); }
};
template <>
struct CommandText<OpenLayer> : LayerMember {
  static constexpr std::string_view kName = "open_layer";
};
template <>
struct CommandText<RedrawLayer> : LayerMember {
  static constexpr std::string_view kName = "redraw_layer";
};
template <>
struct CommandText<CloseLayer> : LayerMember {
  static constexpr std::string_view kName = "close_layer";
};

template <>
struct CommandText<DeleteLayers> {
  static constexpr std::string_view kName = "delete_layers";
  static void members(auto& each, auto& command) { each("layers", command.layers); }
};

template <>
struct CommandText<DuplicateLayer> {
  static constexpr std::string_view kName = "duplicate_layer";
  static void members(auto& each, auto& command) {
    each("layer", command.layer);
    each("end", command.end);
    each("offset", command.offset);
  }
};

template <>
struct CommandText<SetLayerOrder> {
  static constexpr std::string_view kName = "set_layer_order";
  static void members(auto& each, auto& command) { each("layers", command.back_to_front); }
};

template <>
struct CommandText<TransformLayers> {
  static constexpr std::string_view kName = "transform_layers";
  static void members(auto& each, auto& command) {
    each("layers", command.layers);
    each("map", command.map);
  }
};

template <>
struct CommandText<Bend> {
  static constexpr std::string_view kName = "bend";
  static void members(auto& each, auto& command) {
    each("parts", command.parts);
    each("lines", command.lines);
  }
};

template <>
struct CommandText<SetBendPins> {
  static constexpr std::string_view kName = "set_bend_pins";
  static void members(auto& each, auto& command) {
    each("layer", command.layer);
    each("pins", command.pins);
  }
};

template <>
struct CommandText<RenameLayer> {
  static constexpr std::string_view kName = "rename_layer";
  static void members(auto& each, auto& command) {
    each("layer", command.layer);
    each("name", command.name);
  }
};

template <>
struct CommandText<SetThickness> {
  static constexpr std::string_view kName = "set_thickness";
  static void members(auto& each, auto& command) {
    each("layer", command.layer);
    each("thickness", command.thickness);
  }
};

template <>
struct CommandText<SetFill> {
  static constexpr std::string_view kName = "set_fill";
  static void members(auto& each, auto& command) {
    each("layer", command.layer);
    each("fill", command.fill);
  }
};

template <>
struct CommandText<SetHidden> {
  static constexpr std::string_view kName = "set_hidden";
  static void members(auto& each, auto& command) {
    each("layer", command.layer);
    each("hidden", command.is_hidden);
  }
};

template <>
struct CommandText<SetLocked> {
  static constexpr std::string_view kName = "set_locked";
  static void members(auto& each, auto& command) {
    each("layer", command.layer);
    each("locked", command.is_locked);
  }
};

template <>
struct CommandText<SetChoice> {
  static constexpr std::string_view kName = "set_choice";
  static void members(auto& each, auto& command) {
    each("layer", command.layer);
    each("choice", command.choice);
  }
};

template <>
struct CommandText<SetTemplate> {
  static constexpr std::string_view kName = "set_template";
  static void members(auto& each, auto& command) { each("picture", command.picture); }
};

template <>
struct CommandText<SetCanvas> {
  static constexpr std::string_view kName = "set_canvas";
  static void members(auto& each, auto& command) {
    each("width", command.width_px);
    each("height", command.height_px);
  }
};

template <>
struct CommandText<AddPin> {
  static constexpr std::string_view kName = "add_pin";
  static void members(auto& each, auto& command) { each("pin", command.pin); }
};

template <>
struct CommandText<MovePins> {
  static constexpr std::string_view kName = "move_pins";
  static void members(auto& each, auto& command) {
    each("pins", command.pins);
    each("positions", command.positions);
  }
};

template <>
struct CommandText<DeletePins> {
  static constexpr std::string_view kName = "delete_pins";
  static void members(auto& each, auto& command) { each("pins", command.pins); }
};

template <>
struct CommandText<SetTrack> {
  static constexpr std::string_view kName = "set_track";
  static void members(auto& each, auto& command) { each("track", command.track); }
};

template <>
struct CommandText<SetClipLength> {
  static constexpr std::string_view kName = "set_clip_length";
  static void members(auto& each, auto& command) { each("length", command.length_s); }
};

template <>
struct CommandText<Replace> {
  static constexpr std::string_view kName = "replace";
  static void members(auto& each, auto& command) { each("document", command.document); }
};

}  // namespace inkflate
