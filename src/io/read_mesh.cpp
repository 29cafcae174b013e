// SPDX-License-Identifier: Apache-2.0
#include "io/read_mesh.h"

#include "io/read_3mf.h"
#include "io/read_glb.h"
#include "io/read_obj.h"
#include "io/read_stl.h"
#include "io/sketch_limits.h"

namespace inkflate {
namespace {

Error no_mesh(FileFormat format) {
  std::string const what =
      format == FileFormat::Unknown
          ? std::string("not a mesh that we know")
          : std::string("this is ") + file_format_name(format) + ", not a mesh";
  return {ErrorCode::Unsupported, what + "; meshes are read from GLB, OBJ, STL and 3MF"};
}

Result<MeshReading> read_as(FileFormat format, std::span<std::byte const> file) {
  switch (format) {
    case FileFormat::Glb:
      return read_glb(file);
    case FileFormat::Obj:
      return read_obj(file);
    case FileFormat::Stl:
      return read_stl(file);
    case FileFormat::ThreeMf:
      return read_3mf(file);
    default:
      return no_mesh(format);
  }
}

}  // namespace

Result<MeshReading> read_mesh(std::span<std::byte const> file) {
  if (std::ssize(file) > kMaxFileBytes) {
    return Error{ErrorCode::TooLarge, "the file is over 64 MB"};
  }
  auto const format = sniff_format(file);
  auto reading = read_as(format, file);
  if (!reading) return reading;
  if (reading->mesh.triangles.empty()) {
    return Error{ErrorCode::NothingThere, "the file holds no triangle"};
  }
  reading->format = format;
  return reading;
}

}  // namespace inkflate
