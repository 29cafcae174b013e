// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/answer.h"

#include <utility>

namespace inkflate::web {

BlobWriter::Place BlobWriter::add(std::span<std::byte const> bytes) {
  auto const start = begin();
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return place_from(start);
}

Answer BlobWriter::answer(nlohmann::json const& head) {
  // Names of files come from outside: bytes that are no UTF-8 become U+FFFD.
  return {head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
          std::exchange(bytes_, {})};
}

std::size_t BlobWriter::begin() {
  while (bytes_.size() % 4 != 0) bytes_.push_back(std::byte{0});
  return bytes_.size();
}

BlobWriter::Place BlobWriter::place_from(std::size_t start) const {
  return Place::array({start, bytes_.size() - start});
}

}  // namespace inkflate::web
