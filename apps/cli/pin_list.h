// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "deform/bend_options.h"
#include "geometry/vec2.h"

namespace inkflate::cli {

/// A place by which a part is bent, as the user wrote it.
struct PinWords {
  std::string source;  // what errors call it: "pins.json: pin 2"
  std::string part;    // its name, or its number in digits; empty: the one whose line is nearest
  Vec2 at;             // canvas px; finite, as all below
  std::optional<Vec2> to = {};          // none: it stays
  std::optional<double> turn_deg = {};  // clockwise; none: the line around it turns as it likes
};

/// What --pins names.
struct PinFile {
  std::vector<PinWords> pins;
  std::optional<BendMode> mode = {};
  std::optional<double> body = {};  // BendOptions::kLeastBody .. 1
};

/// No file names more pins than this.
inline constexpr int kMaxPins = 1024;

/// Reads {"pins": [{"part", "at": [x, y], "to": [x, y], "turn": degrees}], "mode", "body"}; all but "pins" and "at" may be missing, and what is not
/// listed is refused.
///
/// in      name: of the file, for errors
/// errors  BadInput (index: the pin from 0), TooLarge (JsonLimits, kMaxPins)
Result<PinFile> read_pins(std::string_view text, std::string const& name);

/// "PART:X,Y:X,Y:DEGREES"; "PART:X,Y" stays, and before ":X,Y" PART may be left out. A name may hold colons.
///
/// in      number: of the pins on the command line, from 1
/// errors  BadOption
Result<PinWords> parse_pin(std::string const& text, int number);

/// A number for --body or "body". BadOption: it is none, or out of its range.
Result<double> checked_body(std::string const& what, std::optional<double> body);

}  // namespace inkflate::cli
