// SPDX-License-Identifier: Apache-2.0
#include "io/read_mesh.h"

#include <string_view>

#include "base/check.h"
#include "io/format.h"
#include "io/read_glb.h"
#include "io/read_obj.h"
#include "io/read_stl.h"
#include "io/sketch_limits.h"

namespace inkflate {
namespace {

Error no_mesh(std::span<std::byte const> file) {
  auto const format = sniff_format(file);
  std::string const what = format == FileFormat::Unknown
                               ? std::string("not a format we know")
                               : std::string("a ") + file_format_name(format) + " file";
  return {ErrorCode::Unsupported,
          what + ", not a mesh; meshes are read from GLB, OBJ, STL and 3MF"};
}

Result<MeshReading> read_by_content(std::span<std::byte const> file) {
  if (is_glb(file)) return read_glb(file);
  if (is_binary_stl(file)) return read_binary_stl(file);
  std::string_view const text(reinterpret_cast<char const*>(file.data()), file.size());
  if (is_text_stl(text)) return read_text_stl(text);
  if (is_obj(text)) return read_obj(text);
  return no_mesh(file);
}

}  // namespace

char const* mesh_format_name(MeshFormat format) {
  switch (format) {
    case MeshFormat::Glb:
      return "GLB";
    case MeshFormat::Obj:
      return "OBJ";
    case MeshFormat::Stl:
      return "STL";
    case MeshFormat::ThreeMf:
      return "3MF";
  }
  CHECK(false, "unknown mesh format");
}

Result<MeshReading> read_mesh(std::span<std::byte const> file) {
  if (std::ssize(file) > kMaxFileBytes) {
    return Error{ErrorCode::TooLarge, "the file is over 64 MB"};
  }
  auto reading = read_by_content(file);
  if (reading && reading->mesh.triangles.empty()) {
    return Error{ErrorCode::NothingThere, "the file holds no triangle"};
  }
  return reading;
}

}  // namespace inkflate
