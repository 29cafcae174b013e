// SPDX-License-Identifier: Apache-2.0
#include "cli/inflate_options.h"

#include <sstream>
#include <utility>

#include "cli/option_values.h"

namespace inkflate::cli {
namespace {

/// A number within a range, or the default where none was given.
Result<double> number_within(std::string const& option, std::string const& text, double least,
                             double most, double by_default) {
  if (text.empty()) return by_default;
  auto const number = parse_number(text);
  if (number && *number >= least && *number <= most) return *number;
  std::ostringstream message;
  message << option << " wants a number from " << least << " to " << most << ", not " << text;
  return Error{ErrorCode::BadOption, message.str()};
}

Result<std::optional<SolidifyOptions>> print_options(InflateWords const& words) {
  if (!words.is_print) {
    if (words.print_size.empty() && words.least.empty() && !words.has_flat_base) {
      return std::optional<SolidifyOptions>{};
    }
    return Error{ErrorCode::BadOption, "--print-size, --least and --flat-base belong to --print"};
  }
  SolidifyOptions options;
  options.has_flat_base = words.has_flat_base;
  auto const size = number_within("--print-size", words.print_size, 5, 1000, options.longest_mm);
  if (!size) return size.error();
  options.longest_mm = *size;
  auto const least = number_within("--least", words.least, 0, 20, options.least_mm);
  if (!least) return least.error();
  options.least_mm = *least;
  return std::optional<SolidifyOptions>{options};
}

}  // namespace

void add_inflate_options(CLI::App& verb, InflateWords& words) {
  verb.add_option("--thickness", words.thickness,
                  "Of all parts: 2 makes limbs round, 4 makes a disc a ball")
      ->type_name("0.1..32");
  verb.add_option("--density", words.density, "Triangles per area, times the default")
      ->type_name("0.1..10");
  verb.add_option("--duplicate", words.duplicates,
                  "Put a copy of this part behind all others (may be repeated)")
      ->type_name("PART")
      ->allow_extra_args(false);
  add_choice<OpenRuns>(
      verb, "--open", words.open,
      {{"joined", OpenRuns::Joined}, {"capped", OpenRuns::Capped}, {"holes", OpenRuns::Holes}},
      "Open ends join other parts, end flat, or stay open where nothing is");
  add_choice<Wear>(
      verb, "--wear", words.wear,
      {{"drawing", Wear::Drawing}, {"template", Wear::Template}, {"nothing", Wear::Nothing}},
      "The drawing, the project's template picture, or a plain material");
  verb.add_flag("--print", words.is_print, "One watertight shell in millimetres (.stl, .3mf)");
  verb.add_option("--print-size", words.print_size, "Longest side of the print, mm (100)")
      ->type_name("5..1000");
  verb.add_option("--least", words.least, "No part of the print is thinner, mm (1.2)")
      ->type_name("0..20");
  verb.add_flag("--flat-base", words.has_flat_base, "Cut the print flat so that it stands");
  add_simplify_options(verb, words.simplify);
}

Result<InflateChoices> inflate_choices(InflateWords const& words) {
  InflateChoices choices;
  auto simplify = simplify_options(words.simplify);
  if (!simplify) return simplify.error();
  choices.simplify = std::move(*simplify);
  if (!words.thickness.empty()) {
    auto const thickness = number_within("--thickness", words.thickness, 0.1, 32, 2);
    if (!thickness) return thickness.error();
    choices.thickness = *thickness;
  }
  auto const density = number_within("--density", words.density, 0.1, 10, 1);
  if (!density) return density.error();
  choices.inflate.assemble = {words.open, *density};
  auto const print = print_options(words);
  if (!print) return print.error();
  choices.print = *print;
  choices.duplicates = words.duplicates;
  choices.wear = words.wear;
  return choices;
}

}  // namespace inkflate::cli
