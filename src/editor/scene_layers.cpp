// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_layers.h"

#include <algorithm>

#include "editor/draw_document_layer.h"
#include "editor/scene_strokes.h"

namespace inkflate {
namespace {

/// At 4 px of the screen for one of the canvas, a fifth of a pixel.
constexpr double kCoarsestTolerancePx = 0.05;
constexpr double kZoomStep = 4;
constexpr int kFinest = 2;

double tolerance_px(int fineness) {
  double tolerance = kCoarsestTolerancePx;
  for (int i = 0; i < fineness; ++i) tolerance /= kZoomStep;
  return tolerance;
}

bool has_id(std::vector<LayerId> const& ids, LayerId id) {
  return std::binary_search(ids.begin(), ids.end(), id);
}

}  // namespace

int fineness_of(double zoom) {
  int fineness = 0;
  for (double step = kZoomStep; zoom > step && fineness < kFinest; step *= kZoomStep) ++fineness;
  return fineness;
}

void LayerChunks::update(LayerList const& layers, int fineness, std::uint64_t& next_id) {
  if (layers == layers_ && fineness == fineness_) return;
  closed_.clear();
  open_.clear();
  shown_.clear();
  for (auto const& layer : *layers) {
    if (layer->layer.is_hidden) continue;
    if (layer->layer.is_open) {
      add_open(layer, fineness, next_id);
    } else {
      add_closed(layer, fineness, next_id);
    }
  }
  add_hidden_ink(fineness, next_id);
  cache_.drop_unused();
  layers_ = layers;
  fineness_ = fineness;
}

void LayerChunks::add_closed(Shared<DocumentLayer> const& layer, int fineness,
                             std::uint64_t& next_id) {
  auto const& chunk = cache_.chunk({ChunkLook::Layer, fineness, {layer}}, next_id, [&] {
    return draw_closed_layer(*layer, tolerance_px(fineness));
  });
  if (!chunk.list) return;
  closed_.push_back(chunk);
  shown_.push_back(layer);
}

void LayerChunks::add_hidden_ink(int fineness, std::uint64_t& next_id) {
  // Nothing hides the nearest. Where nothing hides the others, ink goes over the same ink and is not seen.
  for (std::size_t i = 0; i + 1 < shown_.size(); ++i) {
    auto const list = closed_[i].list;
    auto const& chunk = cache_.chunk({ChunkLook::HiddenInk, fineness, {shown_[i]}}, next_id,
                                     [&] { return draw_hidden_ink(*list); });
    if (chunk.list) closed_.push_back(chunk);
  }
}

void LayerChunks::add_open(Shared<DocumentLayer> const& layer, int fineness,
                           std::uint64_t& next_id) {
  auto const& chunk = cache_.chunk({ChunkLook::StaleOutline, fineness, {layer}}, next_id, [&] {
    return draw_stale_outlines(*layer, tolerance_px(fineness));
  });
  if (chunk.list) open_.push_back(chunk);
  add_stroke_chunks(layer->strokes, cache_, next_id, open_);
}

std::vector<SceneChunk> const& HighlightChunks::update(LayerList const& layers,
                                                       std::vector<LayerId> const& selection,
                                                       LayerId hover, int fineness,
                                                       std::uint64_t& next_id) {
  if (layers == layers_ && selection == selection_ && hover == hover_ && fineness == fineness_) {
    return chunks_;
  }
  chunks_.clear();
  for (auto const& layer : *layers) {
    if (layer->layer.id == hover && !has_id(selection, hover)) {
      add(layer, ChunkLook::Hovered, fineness, next_id);
    }
  }
  for (auto const& layer : *layers) {
    if (has_id(selection, layer->layer.id)) add(layer, ChunkLook::Selected, fineness, next_id);
  }
  cache_.drop_unused();
  layers_ = layers;
  selection_ = selection;
  hover_ = hover;
  fineness_ = fineness;
  return chunks_;
}

void HighlightChunks::add(Shared<DocumentLayer> const& layer, ChunkLook look, int fineness,
                          std::uint64_t& next_id) {
  if (layer->layer.is_hidden) return;
  auto const highlight = look == ChunkLook::Selected ? Highlight::Selected : Highlight::Hovered;
  auto const& chunk = cache_.chunk({look, fineness, {layer}}, next_id, [&] {
    return draw_highlight(*layer, highlight, tolerance_px(fineness));
  });
  if (chunk.list) chunks_.push_back(chunk);
}

}  // namespace inkflate
