// SPDX-License-Identifier: Apache-2.0
#include "assemble/plan_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "assemble/host_area.h"
#include "assemble/join_mouths.h"
#include "geometry/crossings.h"

namespace inkflate {
namespace {

// How far from its host a run may end, as a share of its length: hands stop a little short of the line they aim at.
constexpr double kReachShare = 0.3;
constexpr double kLeastReach = 20;  // in units
// How far a run may be pushed into its host.
constexpr double kPushShare = 1;
// A seam keeps this distance from the host's rim and from other seams, so that there is room for triangles.
constexpr double kClearanceShare = 0.1;
constexpr double kLeastClearance = 4;  // in units
// On a narrow host it makes do with less.
constexpr std::array kClearanceFactors = {1.0, 0.5, 0.25};

// A host has at least this share of its limb's area.
constexpr double kLeastHostShare = 0.5;

// Lines whose boxes are as far apart as this many times a distance are farther apart than that, whatever is rounded.
constexpr double kSurelyFar = 1.001;

/// A line on a host along which something is already joined.
struct Seam {
  Side side = Side::Front;
  Polyline line;
  Rect box;
};

/// Where a run could go.
struct Place {
  int host = 0;
  Vec2 push;
  double depth_px = 0;  // how deep inside the host it lies, at most half its length
};

double distance_between(Polyline const& a, Polyline const& b) {
  double least = std::numeric_limits<double>::infinity();
  for (auto const p : a) {
    for (std::size_t i = 1; i < b.size(); ++i) {
      least = std::min(least, squared_distance_to_segment(p, b[i - 1], b[i]));
    }
  }
  return std::sqrt(least);
}

Polyline moved(Polyline points, Vec2 by) {
  for (auto& p : points) p += by;
  return points;
}

/// About a dozen points of the line with both ends.
Polyline coarse(Polyline const& line) {
  Polyline points;
  std::size_t const last = line.size() - 1;
  constexpr std::size_t parts = 12;
  for (std::size_t k = 0; k <= parts; ++k) points.push_back(line[k * last / parts]);
  return points;
}

class Planner {
 public:
  Planner(std::vector<LayerRim>& rims, double unit_px) : rims_(rims), unit_px_(unit_px) {
    for (auto const& rim : rims) {
      areas_.emplace_back(rim, 4 * unit_px);
      is_joined_.emplace_back(rim.runs.size(), false);
    }
    hosts_.resize(rims.size());
    seams_.resize(rims.size());
  }

  std::vector<PlannedJoint> run() && {
    int const count = static_cast<int>(std::ssize(rims_));
    for (int i = 0; i < count; ++i) {
      // By index: a push replaces the runs' points, not their number.
      for (int r = 0; r < static_cast<int>(std::ssize(rims_[i].runs)); ++r) {
        if (rims_[i].runs[r].opening == Opening::None || is_joined_[i][r]) continue;
        if (join_mouth(i, r) || join_slit(i, r)) continue;
        auto& opening = rims_[i].runs[r].opening;
        if (opening == Opening::Possible) opening = Opening::None;
      }
    }
    return std::move(joints_);
  }

 private:
  void add_joint(PlannedJoint const& joint) {
    joints_.push_back(joint);
    is_joined_[joint.limb][joint.run] = true;
    if (joint.host_run >= 0) is_joined_[joint.host][joint.host_run] = true;
    hosts_[joint.limb].push_back(joint.host);
  }

  bool join_mouth(int layer, int run) {
    for (int other = layer + 1; other < static_cast<int>(std::ssize(rims_)); ++other) {
      for (int r = 0; r < static_cast<int>(std::ssize(rims_[other].runs)); ++r) {
        if (rims_[other].runs[r].opening == Opening::None || is_joined_[other][r]) continue;
        if (!bring_together(rims_[layer], run, rims_[other], r)) continue;
        add_joint({layer, run, other, r, Side::Front});
        return true;
      }
    }
    return false;
  }

  bool join_slit(int layer, int run) {
    auto places = find_places(layer, run);
    // The deepest first; of those that are about equally deep the nearest layer, and of two neighbours the one behind.
    std::stable_sort(places.begin(), places.end(), [&](Place const& a, Place const& b) {
      if (a.depth_px > 1.25 * b.depth_px) return true;
      if (b.depth_px > 1.25 * a.depth_px) return false;
      return std::abs(a.host - layer) < std::abs(b.host - layer);
    });
    for (auto const& place : places) {
      if (!push_into(layer, run, place.push)) continue;
      auto const side = place.host < layer ? Side::Front : Side::Back;
      add_joint({layer, run, place.host, -1, side});
      auto const& line = rims_[layer].runs[run].points;
      seams_[place.host].push_back({side, line, bounds(line)});
      return true;
    }
    return false;
  }

  std::vector<Place> find_places(int layer, int run) const {
    std::vector<Place> places;
    for (int host = 0; host < static_cast<int>(std::ssize(rims_)); ++host) {
      if (host == layer || !may_host(host, layer, rims_[layer].runs[run].opening)) continue;
      if (auto const place = place_in(host, layer, rims_[layer].runs[run].points)) {
        places.push_back(*place);
      }
    }
    return places;
  }

  /// A closing is no proof that something joins there: a body does not grow out of its own arm, nor out of anything much smaller than itself.
  bool may_host(int host, int limb, Opening opening) const {
    if (opening == Opening::Wanted) return true;
    auto const& hosts = hosts_[host];
    bool const is_limb_of_it = std::find(hosts.begin(), hosts.end(), limb) != hosts.end();
    return !is_limb_of_it && areas_[host].area() >= kLeastHostShare * areas_[limb].area();
  }

  /// The shortest way into the host, straight out of the limb's mouth.
  std::optional<Place> place_in(int host, int limb, Polyline const& line) const {
    auto const chord = line.back() - line.front();
    double const width_px = norm(chord);
    auto const outward = -normalized(perpendicular(chord));
    double const reach_px = std::max(kReachShare * width_px, kLeastReach * unit_px_);
    auto const& area = areas_[host];
    if (area.clearance(line.front()) < -reach_px || area.clearance(line.back()) < -reach_px) {
      return std::nullopt;
    }
    double const full_px = std::max(kLeastClearance * unit_px_, kClearanceShare * width_px);
    auto const samples = coarse(line);
    double const step_px = std::max(unit_px_, width_px / 32);
    int const steps = static_cast<int>((kPushShare * width_px + reach_px) / step_px);
    for (double const factor : kClearanceFactors) {
      double const wanted_px = factor * full_px;
      for (int step = 0; step <= steps; ++step) {
        auto const push = outward * (step * step_px);
        double const depth_px = area.least_clearance(moved(samples, push), wanted_px);
        if (depth_px < wanted_px || !is_free(host, limb, moved(line, push), wanted_px)) continue;
        return Place{host, push, std::min(depth_px, width_px / 2)};
      }
    }
    return std::nullopt;
  }

  /// Whether the line keeps away from the seams on the host. On the other side of it, it may lie exactly on one: that is a duplicate.
  bool is_free(int host, int limb, Polyline const& line, double distance_px) const {
    auto const side = host < limb ? Side::Front : Side::Back;
    auto const& seams = seams_[host];
    auto const near = bounds(line).grown(kSurelyFar * distance_px);
    return std::all_of(seams.begin(), seams.end(), [&](Seam const& seam) {
      if (!touch(seam.box, near)) return true;
      if (seam.side != side && seam.line == line) return true;
      return distance_between(line, seam.line) >= distance_px;
    });
  }

  /// Moves the run and draws the way to it. False, and nothing changed: the outline would cross itself.
  bool push_into(int layer, int run, Vec2 push) {
    if (push == Vec2{}) return true;
    auto changed = rims_[layer];
    int const count = static_cast<int>(std::ssize(changed.runs));
    auto& points = changed.runs[run].points;
    auto& before = changed.runs[(run + count - 1) % count].points;
    auto& after = changed.runs[(run + 1) % count].points;
    auto const way_in = densify({points.front(), points.front() + push}, unit_px_);
    auto way_out = densify({points.back() + push, points.back()}, unit_px_);
    before.insert(before.end(), way_in.begin() + 1, way_in.end());
    after.insert(after.begin(), way_out.begin(), way_out.end() - 1);
    points = moved(points, push);
    points.front() = before.back();
    points.back() = after.front();
    if (!is_simple(outer_contour(changed))) return false;
    rims_[layer] = std::move(changed);
    return true;
  }

  std::vector<LayerRim>& rims_;
  double unit_px_;
  std::vector<HostArea> areas_;
  std::vector<std::vector<char>> is_joined_;  // per layer and run
  std::vector<std::vector<int>> hosts_;       // per layer, those that it joins
  std::vector<std::vector<Seam>> seams_;      // per host
  std::vector<PlannedJoint> joints_;
};

}  // namespace

std::vector<PlannedJoint> plan_joints(std::vector<LayerRim>& rims, double unit_px) {
  return Planner(rims, unit_px).run();
}

}  // namespace inkflate
