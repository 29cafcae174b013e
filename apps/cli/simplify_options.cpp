// SPDX-License-Identifier: Apache-2.0
#include "cli/simplify_options.h"

#include "cli/option_values.h"

namespace inkflate::cli {
namespace {

Error bad_value(std::string const& option, std::string const& range, std::string const& text) {
  return {ErrorCode::BadOption, option + " wants " + range + ", not " + text};
}

void add_marks(CLI::App& verb, std::string const& name, std::vector<std::string>& marks,
               std::string const& description) {
  verb.add_option(name, marks, description)->type_name("X,Y")->allow_extra_args(false);
}

}  // namespace

void add_simplify_options(CLI::App& verb, SimplifyWords& words) {
  verb.add_option("--gap", words.gap, "Largest gap to close, px of the output canvas")
      ->type_name("auto|PX");
  add_marks(verb, "--outside", words.outside, "This place is background (may be repeated)");
  add_marks(verb, "--inside", words.inside, "This place belongs to the shape (may be repeated)");
  add_choice<SimplifyMethod>(verb, "--method", words.method,
                             {{"cut", SimplifyMethod::Cut}, {"grid", SimplifyMethod::Grid}},
                             "Where the cut is made: between strokes, or on pixels");
  add_choice<Holes>(verb, "--holes", words.holes, {{"keep", Holes::Keep}, {"fill", Holes::Fill}},
                    "Whether enclosed white stays open");
  add_choice<Parts>(verb, "--parts", words.parts,
                    {{"all", Parts::All}, {"groups", Parts::Groups}, {"one", Parts::One}},
                    "Every piece, one part for each group, or the largest piece");
  verb.add_option("--smooth", words.smooth, "How far contours may leave the pen's jitter")
      ->type_name("0..1");
  verb.add_option("--size", words.size, "Longer side of the output canvas, px")->type_name("N");
  verb.add_flag("--fit", words.fits, "Centre the strokes on a square canvas, 0.86 of its size");
}

Result<RunSimplifyOptions> simplify_options(SimplifyWords const& words) {
  RunSimplifyOptions options;
  options.simplify.method = words.method;
  options.simplify.holes = words.holes;
  options.simplify.parts = words.parts;
  options.place.mode = words.fits ? PlaceMode::FitStrokes : PlaceMode::WholeCanvas;
  if (words.gap != "auto") {
    auto const gap_px = parse_number(words.gap);
    if (!gap_px || *gap_px <= 0) return bad_value("--gap", "auto or a length over 0", words.gap);
    options.simplify.gap_px = gap_px;
  }
  if (!words.smooth.empty()) {
    auto const smooth = parse_number(words.smooth);
    bool const is_legal = smooth && *smooth >= 0 && *smooth <= 1;
    if (!is_legal) return bad_value("--smooth", "a number from 0 to 1", words.smooth);
    options.simplify.smooth = *smooth;
  }
  if (!words.size.empty()) {
    auto const size_px = parse_number(words.size);
    bool const is_legal = size_px && *size_px >= 1 && *size_px <= PlaceOptions::kMaxSizePx;
    if (!is_legal) return bad_value("--size", "1 to 16384 px", words.size);
    options.place.size_px = size_px;
  }
  auto const outside = parse_points("--outside", words.outside);
  if (!outside) return outside.error();
  auto const inside = parse_points("--inside", words.inside);
  if (!inside) return inside.error();
  options.simplify.outside = *outside;
  options.simplify.inside = *inside;
  return options;
}

}  // namespace inkflate::cli
