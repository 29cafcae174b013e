// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "document/document.h"
#include "render/draw_list.h"

namespace inkflate {

enum class SceneSpace { Canvas, Screen };

/// Things to draw that change together. A studio keeps what it made of a chunk for as long as its id comes again.
struct SceneChunk {
  std::uint64_t id = 0;  // another content has another id
  SceneSpace space = SceneSpace::Canvas;
  Shared<DrawList> list;  // not empty
};

/// One chunk of something small, which is drawn for each scene and compared with what it was.
class ChunkSlot {
 public:
  /// Puts the chunk of this list at the end; an empty list has none.
  void add(DrawList list, SceneSpace space, std::uint64_t& next_id,
           std::vector<SceneChunk>& chunks);

 private:
  SceneChunk chunk_;
};

/// How the things of a chunk are drawn.
enum class ChunkLook { Layer, HiddenInk, StaleOutline, Strokes, Selected, Hovered };

/// What a chunk depends on.
struct ChunkKey {
  ChunkLook look = ChunkLook::Layer;
  int fineness = 0;
  std::vector<std::shared_ptr<void const>>
      things;  // held, so that nothing else can come to lie at their addresses
};

struct ChunkKeyOrder {
  bool operator()(ChunkKey const& a, ChunkKey const& b) const;
};

/// Chunks of things that never change, by their addresses. The order of addresses decides about nothing but the search.
class ChunkCache {
 public:
  /// The chunk of a key, drawn by make() if it was not there; its list may be null: nothing to draw.
  template <typename Make>
  SceneChunk const& chunk(ChunkKey key, std::uint64_t& next_id, Make make) {
    auto& entry = entries_[std::move(key)];
    if (!entry.is_made) {
      auto list = make();
      if (!list.empty()) {
        entry.chunk = {next_id++, SceneSpace::Canvas,
                       std::make_shared<DrawList const>(std::move(list))};
      }
      entry.is_made = true;
    }
    entry.is_used = true;
    return entry.chunk;
  }

  /// Forgets all chunks that have not been asked for since the last time.
  void drop_unused();

 private:
  struct Entry {
    SceneChunk chunk;
    bool is_made = false;
    bool is_used = false;
  };

  std::map<ChunkKey, Entry, ChunkKeyOrder> entries_;
};

}  // namespace inkflate
