// SPDX-License-Identifier: Apache-2.0
#include "io/document_hash.h"

#include <cstddef>
#include <span>
#include <string>

#include "base/hash.h"
#include "io/write_document_json.h"

namespace inkflate {

std::uint64_t document_hash(Project const& project) {
  Hash hash;
  std::string const text = write_document_json(project);
  hash.add(std::as_bytes(std::span(text)));
  if (auto const& picture = project.template_picture) {
    hash.add(static_cast<std::int64_t>(picture->width));
    hash.add(static_cast<std::int64_t>(picture->height));
    static_assert(sizeof(Colour) == 4, "only channels");
    hash.add(std::as_bytes(std::span(picture->values)));
  }
  return hash.value();
}

}  // namespace inkflate
