// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_chunk.h"

#include <algorithm>
#include <functional>

namespace inkflate {

void ChunkSlot::add(DrawList list, SceneSpace space, std::uint64_t& next_id,
                    std::vector<SceneChunk>& chunks) {
  if (list.empty()) {
    chunk_ = {};
    return;
  }
  if (!chunk_.list || *chunk_.list != list) {
    chunk_ = {next_id++, space, std::make_shared<DrawList const>(std::move(list))};
  }
  chunks.push_back(chunk_);
}

bool ChunkKeyOrder::operator()(ChunkKey const& a, ChunkKey const& b) const {
  if (a.look != b.look) return a.look < b.look;
  if (a.fineness != b.fineness) return a.fineness < b.fineness;
  return std::lexicographical_compare(
      a.things.begin(), a.things.end(), b.things.begin(), b.things.end(),
      [](auto const& x, auto const& y) { return std::less<void const*>()(x.get(), y.get()); });
}

void ChunkCache::drop_unused() {
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    if (entry->second.is_used) {
      entry->second.is_used = false;
      ++entry;
    } else {
      entry = entries_.erase(entry);
    }
  }
}

}  // namespace inkflate
