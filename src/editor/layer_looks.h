// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>

#include "document/document.h"

namespace inkflate {

/// A number for how each layer looks, so that pictures of layers are made anew only when they have to be.
class LayerLooks {
 public:
  /// Another number when the layer's lines, area, fill or openness are others than when it was last asked for. Numbers ascend from 1
  /// and never come again.
  ///
  /// cost    O(1) for a layer that is the same; else O(pieces of the outlines)
  std::uint64_t look(Shared<DocumentLayer> const& layer);

  /// Forgets the layers that a document does not have.
  void keep_only(Document const& document);

 private:
  struct Entry {
    Shared<DocumentLayer> layer;  // held, so that no other comes to lie at its address
    std::uint64_t look = 0;
  };

  std::map<LayerId, Entry> entries_;
  std::uint64_t next_look_ = 1;
};

}  // namespace inkflate
