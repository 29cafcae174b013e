// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "house/include_rules.h"
#include "house/source_files.h"

namespace inkflate::house {
namespace {

TEST(Includes, OnlyPointDownward) {
  int checked = 0;
  for (auto const& file : source_files()) {
    bool const is_ours = file.path.starts_with("src/") || file.path.starts_with("apps/");
    if (!is_ours || !has_extension(file, {".h", ".cpp"})) continue;
    ++checked;
    for (auto const& fault : include_faults(file.path, file.text)) ADD_FAILURE() << fault;
  }
  EXPECT_GT(checked, 20);  // else the walk looked in the wrong place
}

// A header that its own .cpp includes first is known to compile on its own; the build compiles the others alone.
TEST(Includes, EverySourceIncludesItsOwnHeaderFirst) {
  auto const files = source_files();
  for (auto const& header : files) {
    if (!header.path.starts_with("src/") || !has_extension(header, {".h"})) continue;
    std::string const source = header.path.substr(0, header.path.size() - 2) + ".cpp";
    std::string const own = '"' + header.path.substr(4) + '"';
    for (auto const& file : files) {
      if (file.path != source) continue;
      auto const includes = includes_of(file.text);
      EXPECT_TRUE(!includes.empty() && includes.front() == own) << file.path;
    }
  }
}

struct PlantedEdge {
  char const* path;
  char const* line;
};

class PlantedFault : public testing::TestWithParam<PlantedEdge> {};

TEST_P(PlantedFault, IsCaught) {
  auto const [path, line] = GetParam();
  EXPECT_EQ(include_faults(path, line).size(), 1U) << path << ": " << line;
}

INSTANTIATE_TEST_SUITE_P(
    Includes, PlantedFault,
    testing::Values(PlantedEdge{"src/base/result.h", "#include \"geometry/vec2.h\""},
                    PlantedEdge{"src/model/drawing.h", "  #  include \"simplify/simplify.h\""},
                    PlantedEdge{"src/simplify/cut.cpp", "#include \"ink/trace_scan.h\""},
                    PlantedEdge{"src/io/read_svg.cpp", "#include \"pipeline/run_simplify.h\""},
                    PlantedEdge{"src/image/grid2.h", "#include \"mesh/tri_mesh.h\""},
                    PlantedEdge{"apps/cli/main.cpp", "#include \"desktop/window.h\""},
                    PlantedEdge{"src/model/drawing.h", "#include \"stroke.h\""},
                    PlantedEdge{"src/model/drawing.h", "#include \"../base/result.h\""},
                    PlantedEdge{"src/cellar/x.h", "#include \"base/result.h\""},
                    PlantedEdge{"src/simplify/cut.cpp", "#include <Eigen/Sparse>"},
                    PlantedEdge{"src/render/rasterise.cpp", "#include \"stb_image_write.h\""},
                    PlantedEdge{"src/model/drawing.h", "#include <nlohmann/json.hpp>"},
                    PlantedEdge{"src/io/read_svg.cpp", "#include <CLI/CLI.hpp>"},
                    PlantedEdge{"src/base/rng.h", "#include <emscripten.h>"},
                    PlantedEdge{"src/base/rng.h", "#include <gtest/gtest.h>"}));

TEST(Includes, DownwardEdgesAndOwnFolderAreFine) {
  EXPECT_TRUE(include_faults("src/model/drawing.h",
                             "#include <vector>\n#include \"model/stroke.h\"\n"
                             "#include \"geometry/cubic.h\"\n")
                  .empty());
  EXPECT_TRUE(include_faults("src/solvers/sparse.cpp", "#include <Eigen/Sparse>").empty());
  EXPECT_TRUE(include_faults("src/io/write_png.cpp", "#include <stb_image_write.h>").empty());
  EXPECT_TRUE(include_faults("apps/cli/main.cpp", "#include <CLI/CLI.hpp>").empty());
}

}  // namespace
}  // namespace inkflate::house
