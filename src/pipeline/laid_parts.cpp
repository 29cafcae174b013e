// SPDX-License-Identifier: Apache-2.0
#include "pipeline/laid_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "geometry/polyline.h"
#include "geometry/rect.h"

namespace inkflate {
namespace {

// Places of a rim: between two of them a part follows its host by its own stiffness.
constexpr int kPlaces = 48;

// An eye lies on a head as a whole, on the end of a stalk with a little of its rim, and a nose stands out. What has less of it over another only
// touches that, and what is as large is its twin. What is behind has to be a small thing, as a far leg: a body is not carried by its own wing.
constexpr int kLeastPlacesOver = 4;
constexpr double kMostShareBefore = 0.95;
constexpr double kMostShareBehind = 0.25;

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

bool may_lie_on(Candidate& part, Candidate& host, double most_share) {
  if (host.is_empty() || (host.layer().is_hidden && !part.layer().is_hidden)) return false;
  return touch(part.box(), host.box()) && part.area() <= most_share * host.area();
}

/// The places of a rim in the host's area, whichever of both is in front.
Polyline places_over(Candidate& part, Candidate& host) {
  Polyline over;
  std::copy_if(part.rim().begin(), part.rim().end(), std::back_inserter(over),
               [&](Vec2 p) { return contains(host.contours(), p); });
  return over;
}

}  // namespace

std::vector<LaidPart> laid_parts(Document const& document, std::set<LayerId> const& joined) {
  std::vector<Candidate> candidates;
  for (auto const& layer : *document.layers) candidates.emplace_back(layer->layer);
  std::vector<LaidPart> laid;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    auto& part = candidates[i];
    if (part.is_empty() || joined.count(part.layer().id) > 0) continue;
    LaidPart best = {part.layer().id};
    auto const try_host = [&](Candidate& host, double most_share) {
      if (!may_lie_on(part, host, most_share)) return;
      auto over = places_over(part, host);
      if (over.size() > best.rim.size()) best = {best.part, host.layer().id, std::move(over)};
    };
    for (std::size_t k = i; k-- > 0;) try_host(candidates[k], kMostShareBefore);
    for (std::size_t k = i + 1; k < candidates.size(); ++k)
      try_host(candidates[k], kMostShareBehind);
    if (std::ssize(best.rim) >= kLeastPlacesOver) laid.push_back(std::move(best));
  }
  return laid;
}

}  // namespace inkflate
