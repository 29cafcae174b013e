// SPDX-License-Identifier: Apache-2.0
#include "io/write_inkflate.h"

#include "io/project_files.h"
#include "io/sketch_limits.h"

namespace inkflate {

Result<std::vector<std::byte>> write_inkflate(Project const& project) {
  auto const files = project_files(project);
  if (!files) return files.error();
  auto archive = write_zip(*files);
  if (std::ssize(archive) > kMaxFileBytes) {
    return Error{ErrorCode::TooLarge,
                 "the file would be larger than 64 MB, which is the most we read"};
  }
  return archive;
}

}  // namespace inkflate
