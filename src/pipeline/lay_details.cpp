// SPDX-License-Identifier: Apache-2.0
#include "pipeline/lay_details.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "simplify/layer_area.h"
#include "simplify/stroke_samples.h"

namespace inkflate {
namespace {

// Strokes are looked at in steps of this length, work px.
constexpr double kStepPx = 12;

// A line that was drawn along an outline wavers to both sides of it; so far beyond it still lies on the layer, work px.
constexpr double kRimPx = 9;

/// The closed layers that may be given something, and what they cover.
class LayersBelow {
 public:
  LayersBelow(Document const& document, WorkSpace const& space) {
    for (auto layer = document.layers->rbegin(); layer != document.layers->rend(); ++layer) {
      auto const& data = (*layer)->layer;
      if (!is_shown(data) || data.is_locked || data.is_open) continue;
      ids_.push_back(data.id);
      areas_.emplace_back(data, space);
    }
  }

  /// The layer on which most of a stroke lies; None when more than half of it lies on none.
  LayerId under(StrokeSamples const& stroke) const {
    std::vector<std::ptrdiff_t> counts(areas_.size(), 0);
    std::ptrdiff_t covered = 0;
    for (auto const& sample : stroke.points) {
      auto const is_under = [&](LayerArea const& area) {
        return area.covers(sample.position, kRimPx);
      };
      auto const found = std::find_if(areas_.begin(), areas_.end(), is_under);
      if (found == areas_.end()) continue;
      ++covered;
      ++counts[static_cast<std::size_t>(found - areas_.begin())];
    }
    if (covered == 0 || 2 * covered < std::ssize(stroke.points)) return LayerId::None;
    auto const most = std::max_element(counts.begin(), counts.end()) - counts.begin();
    return ids_[static_cast<std::size_t>(most)];
  }

 private:
  std::vector<LayerId> ids_;  // from front to back
  std::vector<LayerArea> areas_;
};

/// In which the strokes and all layers have their place.
WorkSpace common_space(Document const& document, RoughSet const& set) {
  Rect box;
  for (auto const& kept : set.strokes) box = united(box, kept->box);
  for (auto const& layer : *document.layers) {
    for (auto const& outline : layer->layer.outlines) {
      for (auto const& piece : outline.pieces) {
        for (auto const p : piece.curve.control) box.include(p);
      }
    }
  }
  return WorkSpace::around(box);
}

bool may_be_detail(Sketch const& sketch, Stroke const& stroke) {
  if (stroke.kind == StrokeKind::HelpLine) return false;
  return stroke.group < 0 || is_candidate_layer(sketch.groups[stroke.group]);
}

/// Which strokes of the set lie on layers, each with its layer.
std::map<int, LayerId> strokes_on_layers(Document const& document, RoughSet const& set) {
  std::map<int, LayerId> result;
  if (set.layer != LayerId::None || document.layers->empty()) return result;
  auto const space = common_space(document, set);
  LayersBelow const below(document, space);
  auto const sketch = set_sketch(document, set);
  for (int i = 0; i < std::ssize(sketch.strokes); ++i) {
    if (!may_be_detail(sketch, sketch.strokes[i])) continue;
    int const chosen[] = {i};
    auto const layer = below.under(sample_strokes(sketch, chosen, space, kStepPx));
    if (layer != LayerId::None) result[i] = layer;
  }
  return result;
}

}  // namespace

int lay_details(Document const& document, RoughSet& set, std::vector<Simplify::Details>& details) {
  auto const on_layers = strokes_on_layers(document, set);
  std::map<LayerId, std::vector<int>> by_layer;
  RoughSet rest = {set.layer, set.depth, {}, {}};
  for (int i = 0; i < std::ssize(set.places); ++i) {
    if (auto const found = on_layers.find(i); found != on_layers.end()) {
      by_layer[found->second].push_back(set.places[i]);
      continue;
    }
    rest.places.push_back(set.places[i]);
    rest.strokes.push_back(set.strokes[i]);
  }
  for (auto const& [layer, strokes] : by_layer) details.push_back({layer, strokes});
  set = std::move(rest);
  return static_cast<int>(std::ssize(on_layers));
}

int lay_details(Document const& document, RoughSet const& set, Simplify::Set& closed,
                std::vector<Simplify::Details>& details) {
  std::set<int> named;
  for (auto const& shape : closed.shapes) {
    named.insert(shape.strokes.begin(), shape.strokes.end());
    named.insert(shape.details.begin(), shape.details.end());
  }
  RoughSet unnamed = {set.layer, set.depth, {}, {}};
  for (int i = 0; i < std::ssize(set.places); ++i) {
    if (named.count(set.places[i]) > 0) continue;
    unnamed.places.push_back(set.places[i]);
    unnamed.strokes.push_back(set.strokes[i]);
  }
  auto const before = details.size();
  int const count = lay_details(document, unnamed, details);
  std::set<int> gone;
  for (auto i = before; i < details.size(); ++i) {
    gone.insert(details[i].strokes.begin(), details[i].strokes.end());
  }
  std::erase_if(closed.strokes, [&](int stroke) { return gone.count(stroke) > 0; });
  return count;
}

}  // namespace inkflate
