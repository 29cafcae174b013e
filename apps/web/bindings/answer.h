// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace inkflate::web {

/// The same that the core writes files with: another kind would be a library's worth of code beside it.
using Json = nlohmann::ordered_json;

/// What goes out of the core: a head, JSON in UTF-8, and the bytes of blobs. In the head a blob is a pair: its first byte and how many
/// they are. In blobs all numbers are of four bytes, the lowest byte first, and each begins at a multiple of four.
struct Answer {
  std::string head;  // empty: there is none
  std::vector<std::byte> blobs;
};

/// Blobs one after another.
class BlobWriter {
 public:
  using Place = Json;  // as the head names a blob

  Place add(std::span<std::byte const> bytes);

  /// What write(bytes) appends to the bytes is a blob.
  template <typename Write>
  Place add_written(Write write) {
    auto const start = begin();
    write(bytes_);
    return place_from(start);
  }

  /// The answer; the writer has nothing any more.
  Answer answer(Json const& head);

 private:
  std::size_t begin();
  Place place_from(std::size_t start) const;

  std::vector<std::byte> bytes_;
};

}  // namespace inkflate::web
