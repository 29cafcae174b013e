// SPDX-License-Identifier: Apache-2.0
#include "io/read_inkflate.h"

#include "io/project_files.h"

namespace inkflate {

Result<Project> read_inkflate(std::span<std::byte const> file) {
  auto const entries = read_zip_directory(file);
  if (!entries) return entries.error();
  return read_project_files(*entries);
}

}  // namespace inkflate
