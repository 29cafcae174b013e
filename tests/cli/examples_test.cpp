// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/load_project.h"
#include "inflate/inflate.h"
#include "mesh/check_mesh.h"
#include "pipeline/run_inflate.h"

namespace inkflate {
namespace {

std::vector<std::string> example_files() {
  std::vector<std::string> files;
  for (std::string const folder : {"sketches", "characters"}) {
    auto const path = std::filesystem::path(INKFLATE_SOURCE_DIR) / "examples" / folder;
    for (auto const& entry : std::filesystem::directory_iterator(path)) {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Each layer alone is a sphere with a handle for each of its holes; each joint takes a disc from both that it joins.
long long predicted_euler(FlatModel const& model, Drawing const& drawing) {
  long long euler = 0;
  for (auto const& layer : drawing.layers) {
    euler += 2 - 2 * (static_cast<long long>(std::ssize(layer.outlines)) - 1);
  }
  return euler - 2 * static_cast<long long>(std::ssize(model.joints));
}

class Example : public testing::TestWithParam<std::string> {};

TEST_P(Example, BecomesASoundModelOfThePredictedShape) {
  RunSimplifyOptions options;
  options.simplify.parts = Parts::Groups;
  Progress const quiet = {[](std::string_view) {}, {}};
  auto const project = cli::load_project({}, GetParam(), options, quiet);
  ASSERT_TRUE(project.has_value()) << project.error().message;
  auto const flat = assemble(project->drawing);
  ASSERT_TRUE(flat.has_value()) << flat.error().message;
  auto const model = inflate(*flat);
  ASSERT_TRUE(model.has_value());
  auto const found = check_mesh(model->mesh);
  EXPECT_TRUE(found.is_sound());
  EXPECT_EQ(found.euler, predicted_euler(*flat, project->drawing));
}

INSTANTIATE_TEST_SUITE_P(Examples, Example, testing::ValuesIn(example_files()),
                         [](auto const& file) {
                           return std::filesystem::path(file.param).stem().string();
                         });

}  // namespace
}  // namespace inkflate
