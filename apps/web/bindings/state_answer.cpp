// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/state_answer.h"

#include <array>
#include <string>
#include <utility>

#include "web/bindings/names.h"

namespace inkflate::web {
namespace {

/// "#rrggbb"
std::string hex(Colour colour) {
  static constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (unsigned const byte : {colour.r, colour.g, colour.b}) {
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}

template <typename T>
Json or_null(std::optional<T> const& value) {
  return value ? Json(*value) : Json();
}

/// The name of an action; null: none.
Json action_json(std::string const& name) { return name.empty() ? Json() : Json(name); }

Json row_json(LayerRow const& row) {
  return {{"id", row.id},
          {"name", row.name},
          {"thickness", row.thickness},
          {"fill", row.fill ? Json(hex(*row.fill)) : Json()},
          {"isHidden", row.is_hidden},
          {"isLocked", row.is_locked},
          {"isOpen", row.is_open},
          {"isSelected", row.is_selected},
          {"look", row.look}};
}

std::size_t marks_of(CloseChoice const& choice) {
  return choice.outside.size() + choice.inside.size();
}

std::size_t count_marks(Document const& document) {
  auto count = marks_of(*document.choice);
  for (auto const& layer : *document.layers) count += marks_of(layer->layer.choice);
  return count;
}

/// Of parts that are seen.
std::size_t count_pins(Document const& document) {
  std::size_t count = 0;
  for (auto const& layer : *document.layers) {
    if (!layer->layer.is_hidden) count += layer->layer.bend_pins.size();
  }
  return count;
}

Json view_json(View const& view) {
  auto const& settings = view.settings;
  return {{"mode", name_of(view.mode)},
          {"tool", name_of(view.tool)},
          {"brushPx", settings.brush_px},
          {"ink", hex(settings.ink)},
          {"smoothing", settings.smoothing},
          {"eraserPx", settings.eraser_px},
          {"bendMode", name_of(settings.bend_mode)},
          {"bendBody", settings.bend_body},
          {"bendReach", or_null(settings.bend_reach)},
          {"hasPin", view.pin.has_value()},
          {"isOverPart", view.hover != LayerId::None},
          {"hasGrid", view.has_grid},
          {"isMirrored", view.camera.is_mirrored},
          {"zoom", view.camera.zoom},
          {"shading", name_of(view.shading)}};
}

Json chords_json(std::string_view keys) {
  auto chords = Json::array();
  for (auto const& chord : parse_chords(keys).value_or(std::vector<KeyChord>())) {
    chords.push_back(chord_text(chord));
  }
  return chords;
}

Json choices_json(std::string_view choices) {
  auto result = Json::array();
  while (!choices.empty()) {
    auto const end = choices.find(' ');
    result.push_back(choices.substr(0, end));
    choices.remove_prefix(end == std::string_view::npos ? choices.size() : end + 1);
  }
  return result;
}

}  // namespace

Answer state_answer(EngineState const& state, Document const& document) {
  auto json_state = view_json(state.view);
  auto layers = Json::array();
  for (auto const& row : state.layers) layers.push_back(row_json(row));
  json_state.update({{"layers", std::move(layers)},
                     {"hasRoughStrokes", state.has_rough_strokes},
                     {"gapPx", or_null(state.choice.gap_px)},
                     {"marks", count_marks(document)},
                     {"pins", count_pins(document)},
                     {"hasTemplate", document.template_picture != nullptr},
                     {"isBlank", is_blank(document)},
                     {"undo", action_json(state.undo_name)},
                     {"redo", action_json(state.redo_name)},
                     {"isSaved", state.is_saved},
                     {"usualReach", state.usual_reach},
                     {"fileName", state.file_name},
                     {"language", name_of(state.language)},
                     {"enabled", state.enabled}});
  return BlobWriter().answer(json_state);
}

Answer actions_answer() {
  auto rows = Json::array();
  for (auto const& action : actions()) {
    rows.push_back({{"name", action.name},
                    {"menu", name_of(action.menu)},
                    {"labels", {{"en", action.english}, {"cs", action.czech}}},
                    {"chords", chords_json(action.keys)},
                    {"argument", name_of(action.argument)},
                    {"choices", choices_json(action.choices)}});
  }
  return BlobWriter().answer(rows);
}

}  // namespace inkflate::web
