// SPDX-License-Identifier: Apache-2.0
#include "document/check_values.h"

#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>

#include "document/apply.h"

namespace inkflate {
namespace {

using Limits = DocumentLimits;

constexpr double kAnyNumber = std::numeric_limits<double>::max();
constexpr std::size_t kLongestNameBytes = 200;

Error bad_input(std::string message) { return {ErrorCode::BadInput, std::move(message)}; }
Error bad_option(std::string message) { return {ErrorCode::BadOption, std::move(message)}; }
Error too_large(std::string message) { return {ErrorCode::TooLarge, std::move(message)}; }

Error off_sheet(std::string const& what) {
  return bad_input(what + " is no number or lies farther than 1 000 000 px from the canvas");
}

Error not_utf8() { return bad_option("the name is no text in UTF-8"); }

bool are_indices(std::vector<int> const& indices, int count) {
  for (int const index : indices) {
    if (index < 0 || index >= count) return false;
  }
  return true;
}

Fault outline_fault(Outline const& outline, int stroke_count) {
  Vec2 end = outline.pieces.empty() ? Vec2{} : outline.pieces.back().curve.end();
  for (auto const& piece : outline.pieces) {
    for (auto const p : piece.curve.control) {
      if (!is_on_sheet(p)) return off_sheet("a point of an outline");
    }
    if (piece.curve.start() != end) return bad_input("the pieces of an outline do not join");
    end = piece.curve.end();
  }
  for (auto const& source : outline.sources) {
    if (source.stroke < -1 || source.stroke >= stroke_count) {
      return bad_input("an outline has a source that is no stroke");
    }
    for (double const value : {source.from, source.to, source.sample_from, source.sample_to}) {
      if (!std::isfinite(value)) return bad_input("a source of an outline is no number");
    }
  }
  return {};
}

/// How many bytes the character has that starts with this one; 0: none does.
std::size_t utf8_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

}  // namespace

bool is_within(double value, double least, double most) { return value >= least && value <= most; }

bool is_on_sheet(Vec2 p) {
  return is_within(p.x, -Limits::kFarthestPx, Limits::kFarthestPx) &&
         is_within(p.y, -Limits::kFarthestPx, Limits::kFarthestPx);
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    auto const byte = [&](std::size_t k) { return static_cast<unsigned char>(text[i + k]); };
    std::size_t const length = utf8_length(byte(0));
    if (length == 0 || i + length > text.size()) return false;
    for (std::size_t k = 1; k < length; ++k) {
      if (byte(k) < 0x80 || byte(k) > 0xbf) return false;
    }
    // Characters that are written longer than they need, halves of pairs, and those beyond the last.
    if (byte(0) == 0xe0 && byte(1) < 0xa0) return false;
    if (byte(0) == 0xed && byte(1) > 0x9f) return false;
    if (byte(0) == 0xf0 && byte(1) < 0x90) return false;
    if (byte(0) == 0xf4 && byte(1) > 0x8f) return false;
    i += length;
  }
  return true;
}

Fault stroke_fault(Stroke const& stroke, int group_count) {
  if (std::ssize(stroke.samples) > Limits::kSamplesOfStroke) {
    return too_large("a stroke of more than 1 000 000 samples; lift the pen now and then");
  }
  for (auto const& sample : stroke.samples) {
    if (!is_on_sheet(sample.position)) return off_sheet("a place of the stroke");
    if (!is_within(sample.pressure, 0, 1)) return bad_input("a pressure is not within 0 to 1");
    if (!is_within(sample.time_s, 0, kAnyNumber)) {
      return bad_input("a time of the stroke is no number from 0 on");
    }
  }
  if (!is_within(stroke.width_px, 0, Limits::kFarthestPx)) {
    return bad_input("the stroke's width is not within 0 to 1 000 000 px");
  }
  if (stroke.group < -1 || stroke.group >= group_count) {
    return bad_input("the stroke names a group that there is not");
  }
  return {};
}

Fault choice_fault(CloseChoice const& choice) {
  if (choice.gap_px && !(*choice.gap_px > 0 && *choice.gap_px <= Limits::kFarthestPx)) {
    return bad_option("the widest gap has to be above 0 and at most 1 000 000 px");
  }
  for (auto const* marks : {&choice.outside, &choice.inside}) {
    if (std::ssize(*marks) > Limits::kMarks) {
      return too_large("more than 1024 marks of one kind; remove some");
    }
    for (auto const p : *marks) {
      if (!is_on_sheet(p)) return off_sheet("a mark");
    }
  }
  return {};
}

Fault thickness_fault(double thickness) {
  if (is_within(thickness, kLeastThickness, kLargestThickness)) return {};
  return bad_option("the thickness has to be from 0.1 to 32");
}

Fault name_fault(std::string_view name) {
  if (name.size() > kLongestNameBytes) return bad_option("a name of more than 200 bytes");
  if (!is_utf8(name)) return not_utf8();
  return {};
}

Fault bend_pins_fault(std::vector<BendPin> const& pins) {
  if (std::ssize(pins) > Limits::kBendPins) {
    return too_large("more than 256 pins that hold a part while it is bent; remove some");
  }
  for (auto const& pin : pins) {
    if (!is_on_sheet(pin.position)) return off_sheet("a pin");
    if (pin.turn_rad && !is_within(*pin.turn_rad, -Limits::kBendTurnRad, Limits::kBendTurnRad)) {
      return bad_option("a pin's turn is no number or more than 1000 rad");
    }
  }
  return {};
}

Fault layer_fault(Layer const& layer, int stroke_count) {
  for (auto const* indices : {&layer.strokes, &layer.details, &layer.noise}) {
    if (!are_indices(*indices, stroke_count)) {
      return bad_input("a layer names a stroke that is not its own");
    }
  }
  for (auto const& outline : layer.outlines) {
    if (auto fault = outline_fault(outline, stroke_count)) return fault;
  }
  if (auto fault = thickness_fault(layer.thickness)) return fault;
  if (!is_utf8(layer.name)) return not_utf8();
  if (auto fault = bend_pins_fault(layer.bend_pins)) return fault;
  return choice_fault(layer.choice);
}

Fault pin_fault(Pin const& pin) {
  if (is_on_sheet(pin.rest) && is_on_sheet(pin.position)) return {};
  return off_sheet("a pin");
}

Fault clip_length_fault(double length_s) {
  if (is_within(length_s, 0, Limits::kClipS)) return {};
  return bad_option("a clip lasts from 0 s to a day");
}

Fault track_fault(Track const& track, double length_s) {
  if (std::ssize(track.keys) > Limits::kKeys) {
    return too_large("a track of more than 100 000 keys; record a shorter motion");
  }
  if (!is_within(track.phase_s, -Limits::kClipS, Limits::kClipS)) {
    return bad_option("the phase of a track is no number or more than a day");
  }
  double before_s = -1;
  for (auto const& key : track.keys) {
    if (!is_within(key.time_s, 0, length_s)) {
      return bad_input("a key lies outside of the clip; make the clip longer");
    }
    if (key.time_s <= before_s) return bad_input("the keys of a track do not follow in time");
    if (!is_on_sheet(key.position)) return off_sheet("a key");
    before_s = key.time_s;
  }
  return {};
}

}  // namespace inkflate
