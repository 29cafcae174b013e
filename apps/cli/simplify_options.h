// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/run_simplify.h"

namespace inkflate::cli {

/// How strokes are closed, as the user wrote it: for every verb that may start from a rough sketch.
struct SimplifyWords {
  std::string gap = "auto";
  std::vector<std::string> outside;
  std::vector<std::string> inside;
  std::string smooth;
  std::string size;
  bool fits = false;
  SimplifyMethod method = SimplifyMethod::Cut;
  Holes holes = Holes::Keep;
  Parts parts = Parts::All;
};

void add_simplify_options(CLI::App& verb, SimplifyWords& words);

/// BadOption names the option and its range.
Result<RunSimplifyOptions> simplify_options(SimplifyWords const& words);

template <typename Choice>
using Choices = std::map<std::string, Choice>;

/// An option that takes one of a few words.
template <typename Choice>
void add_choice(CLI::App& verb, std::string const& name, Choice& choice,
                Choices<Choice> const& choices, std::string const& description) {
  std::string words;
  for (auto const& [word, value] : choices) words += (words.empty() ? "" : "|") + word;
  auto const choose = [&choice, choices](std::string const& word) { choice = choices.at(word); };
  verb.add_option_function<std::string>(name, choose, description)
      ->check(CLI::IsMember(choices).description(""))
      ->type_name(words);
}

}  // namespace inkflate::cli
