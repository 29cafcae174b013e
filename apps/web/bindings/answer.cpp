// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/answer.h"

#include <utility>

#include "io/write_document_json.h"

namespace inkflate::web {

BlobWriter::Place BlobWriter::add(std::span<std::byte const> bytes) {
  auto const start = begin();
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return place_from(start);
}

Answer BlobWriter::answer(Json const& head) { return {json_text(head), std::exchange(bytes_, {})}; }

std::size_t BlobWriter::begin() {
  while (bytes_.size() % 4 != 0) bytes_.push_back(std::byte{0});
  return bytes_.size();
}

BlobWriter::Place BlobWriter::place_from(std::size_t start) const {
  return Place::array({start, bytes_.size() - start});
}

}  // namespace inkflate::web
