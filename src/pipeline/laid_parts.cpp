// SPDX-License-Identifier: Apache-2.0
#include "pipeline/laid_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "geometry/polyline.h"
#include "geometry/rect.h"

namespace inkflate {
namespace {

// Places of a rim: between two of them a part follows its host by its own stiffness.
constexpr int kPlaces = 24;

// A nose may stand out from its head by more than half, and a hat does. But what only touches is beside it, and so is what is nearly as large.
constexpr int kLeastPlacesOver = 8;
constexpr double kMostShareOfHost = 0.5;

constexpr double kTolerancePx = 0.25;

/// Places of a closed contour, evenly along it.
Polyline places_along(Contour const& contour) {
  std::vector<double> at = {0};
  for (std::size_t i = 0; i < contour.size(); ++i) {
    at.push_back(at.back() + distance(contour[i], contour[(i + 1) % contour.size()]));
  }
  Polyline places;
  std::size_t edge = 0;
  for (int k = 0; k < kPlaces; ++k) {
    double const wanted = at.back() * k / kPlaces;
    while (edge + 1 < contour.size() && at[edge + 1] <= wanted) ++edge;
    double const length = at[edge + 1] - at[edge];
    double const share = length > 0 ? (wanted - at[edge]) / length : 0;
    places.push_back(lerp(contour[edge], contour[(edge + 1) % contour.size()], share));
  }
  return places;
}

/// What is asked of a layer, each once at most.
class Candidate {
 public:
  explicit Candidate(Layer const& layer) : layer_(&layer) {
    if (layer.outlines.empty()) return;
    for (auto const& piece : layer.outlines.front().pieces) {
      box_ = united(box_, bounds(piece.curve.control));
    }
  }

  Layer const& layer() const { return *layer_; }
  bool is_empty() const { return box_.is_empty(); }
  /// A little too large.
  Rect const& box() const { return box_; }

  std::vector<Contour> const& contours() {
    if (contours_.empty()) {
      for (auto const& outline : layer_->outlines) {
        contours_.push_back(flatten(outline, kTolerancePx));
      }
    }
    return contours_;
  }

  double area() {
    if (!area_) area_ = std::abs(signed_area(contours().front()));
    return *area_;
  }

  Polyline const& rim() {
    if (rim_.empty()) rim_ = places_along(contours().front());
    return rim_;
  }

 private:
  Layer const* layer_;
  Rect box_;
  std::vector<Contour> contours_;
  std::optional<double> area_;
  Polyline rim_;
};

bool lies_on(Candidate& part, Candidate& host) {
  if (host.is_empty() || (host.layer().is_hidden && !part.layer().is_hidden)) return false;
  if (!touch(part.box(), host.box())) return false;
  if (part.area() > kMostShareOfHost * host.area()) return false;
  auto const over = std::count_if(part.rim().begin(), part.rim().end(),
                                  [&](Vec2 p) { return contains(host.contours(), p); });
  return over >= kLeastPlacesOver;
}

}  // namespace

std::vector<LaidPart> laid_parts(Document const& document, std::set<LayerId> const& joined) {
  std::vector<Candidate> candidates;
  for (auto const& layer : *document.layers) candidates.emplace_back(layer->layer);
  std::vector<LaidPart> laid;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    auto& part = candidates[i];
    if (part.is_empty() || joined.count(part.layer().id) > 0) continue;
    for (std::size_t below = i; below-- > 0;) {
      if (!lies_on(part, candidates[below])) continue;
      laid.push_back({part.layer().id, candidates[below].layer().id, part.rim()});
      break;
    }
  }
  return laid;
}

}  // namespace inkflate
