// SPDX-License-Identifier: Apache-2.0
#include "cli/output_plan.h"

#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "cli/files.h"

namespace inkflate::cli {
namespace {

namespace fs = std::filesystem;

bool names_folder(std::string const& name) {
  std::error_code error;  // what cannot be looked at is no folder
  return name.ends_with('/') || fs::is_directory(name, error);
}

std::string stem_of(std::string const& input) {
  return input == kStandardStream ? "standard-input" : fs::path(input).stem().string();
}

bool is_file_name(std::string const& path) { return !path.empty() && path != kStandardStream; }

// The entry of the folder that the name means, without following a link at its end: that is what gets replaced.
std::string entry_of(std::string const& name) {
  std::error_code error;
  fs::path const path(name);
  auto const parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
  auto const folder = fs::weakly_canonical(parent, error);
  return (error ? parent : folder) / path.filename();
}

}  // namespace

Result<std::vector<std::string>> plan_outputs(std::vector<std::string> const& inputs,
                                              OutputRule const& rule) {
  std::vector<std::string> outputs(inputs.size(), rule.name);
  if (rule.name.empty()) return outputs;
  if (!names_folder(rule.name)) {
    if (inputs.size() == 1) return outputs;
    return Error{ErrorCode::BadOption, "several inputs need a folder: " + rule.option + " FOLDER/"};
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    outputs[i] = (fs::path(rule.name) / (stem_of(inputs[i]) + rule.extension)).string();
  }
  return outputs;
}

std::string lower_extension(std::string const& path) {
  auto extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  return extension;
}

std::optional<Error> make_folder(std::string const& name) {
  if (!name.ends_with('/')) return std::nullopt;
  std::error_code error;
  fs::create_directories(name, error);
  if (!error) return std::nullopt;
  return Error{ErrorCode::FileSystem, "cannot make " + name + ": " + error.message()};
}

std::optional<Error> find_collision(std::vector<std::string> const& inputs,
                                    std::vector<std::string> const& outputs) {
  std::set<std::string> taken;
  for (auto const& input : inputs) {
    if (!is_file_name(input)) continue;
    std::error_code error;
    taken.insert(entry_of(input));
    taken.insert(fs::weakly_canonical(input, error).string());
  }
  for (auto const& output : outputs) {
    if (is_file_name(output) && !taken.insert(entry_of(output)).second) {
      return Error{ErrorCode::BadOption,
                   output + " is also an input, or would be written twice; choose another name"};
    }
  }
  return std::nullopt;
}

Result<OutputPaths> plan_files_and_pictures(std::vector<std::string> const& inputs,
                                            OutputRule const& files, std::string const& picture,
                                            std::vector<std::string> const& others) {
  auto outputs = plan_outputs(inputs, files);
  if (!outputs) return outputs.error();
  auto pictures = plan_outputs(inputs, {"--picture", picture, ".png"});
  if (!pictures) return pictures.error();
  auto all = *outputs;
  all.insert(all.end(), pictures->begin(), pictures->end());
  all.insert(all.end(), others.begin(), others.end());
  if (auto error = find_collision(inputs, all)) return *std::move(error);
  return OutputPaths{std::move(*outputs), std::move(*pictures)};
}

}  // namespace inkflate::cli
