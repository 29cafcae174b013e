// SPDX-License-Identifier: Apache-2.0
#include "io/write_inkflate.h"

#include "io/project_files.h"

namespace inkflate {

Result<std::vector<std::byte>> write_inkflate(Project const& project) {
  auto const files = project_files(project);
  if (!files) return files.error();
  return write_project_zip(*files);
}

}  // namespace inkflate
