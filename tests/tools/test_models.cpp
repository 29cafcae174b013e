// SPDX-License-Identifier: Apache-2.0
// test_models FOLDER: writes the models of tests/support as files, for the outside judges.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "io/print_objects.h"
#include "io/print_pose.h"
#include "io/write_3mf.h"
#include "io/write_glb.h"
#include "io/write_obj.h"
#include "io/write_stl.h"
#include "support/models.h"

namespace {

using namespace inkflate;

bool write(std::filesystem::path const& path, std::span<std::byte const> bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(reinterpret_cast<char const*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  return static_cast<bool>(stream.flush());
}

bool write(std::filesystem::path const& path, std::string const& text) {
  return write(path, std::as_bytes(std::span(text)));
}

bool write_obj_files(std::filesystem::path const& folder, std::string const& name,
                     RestModel const& model, Texture const& texture) {
  auto const files = write_obj(model, &texture, name);
  return write(folder / (name + ".obj"), files.obj) && write(folder / (name + ".mtl"), files.mtl) &&
         write(folder / (name + ".png"), files.png);
}

bool write_3mf_file(std::filesystem::path const& path, RestModel const& model) {
  std::vector<PrintColour> colours;
  for (auto const& layer : model.layer_names) colours.push_back({layer, {214, 141, 104}});
  return write(path, write_3mf(print_objects(model), colours));
}

bool write_all_formats(std::filesystem::path const& folder, std::string const& name,
                       RestModel const& model) {
  auto const texture = sheet_texture(model, red_over_blue(256));
  return write(folder / (name + ".glb"), write_glb(model, &texture, name)) &&
         write(folder / (name + "_clay.glb"), write_glb(model, nullptr, name)) &&
         write(folder / (name + ".stl"), write_stl(print_pose(model.mesh))) &&
         write_3mf_file(folder / (name + ".3mf"), model) &&
         write_obj_files(folder, name, model, texture);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::filesystem::path const folder = arguments[1];
  std::filesystem::create_directories(folder);
  bool const is_done = write_all_formats(folder, "ball", ball_model({}, 150, 16)) &&
                       write_all_formats(folder, "torus", torus_model(120, 50, 24)) &&
                       write_all_formats(folder, "two_layers", two_layer_model()) &&
                       // More vertices than 16 bits can name.
                       write_all_formats(folder, "large_ball", ball_model({}, 150, 100));
  if (!is_done) std::fprintf(stderr, "cannot write to %s\n", arguments[1]);
  return is_done ? 0 : 1;
}
