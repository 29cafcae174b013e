// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "pipeline/bend_hook.h"
#include "pipeline/bend_part.h"

namespace inkflate {

/// The parts of one document by the layers that they are now.
using BendParts = std::map<LayerId, std::shared_ptr<BendPart>>;

/// A mouth of a part, or the rim of one that lies on another (laid_parts.h), and where on its host it stays.
struct BendJoint {
  LayerId limb = LayerId::None;
  LayerId host = LayerId::None;
  Polyline points;                  // along the mouth or rim, as it was when the joint was found
  std::vector<BendAnchor> anchors;  // of the points in the limb's mesh; empty: it has none yet
  std::vector<BendHook> hooks;      // in the host's mesh; empty: it has none yet
  std::vector<Vec2> starts;         // of the hooks: the points but for rounding
  std::vector<Vec2> beside;         // from the points to the limb's places: a hair
  Shared<DocumentLayer> laid_as;  // the limb's layer as it was found lying; null: it joins the host

  /// A host takes along what lies on it, but does not hold it against a hand.
  bool is_laid() const { return laid_as != nullptr; }
};

/// Where the host has a point of the mouth while it lies in this pose; null: as it was when the joint was found.
Vec2 mouth_place(BendJoint const& joint, int point, BendPart const& host, BendPose const* pose);

/// What joins what, among the parts of one document after the other. Joints stay as they were found for as long as both their parts
/// are the same, whatever poses they take; those of a laid part for as long as nothing but its host moves it.
class BendJoints {
 public:
  /// Finds what joins what in a document, as it lies there. out: false where that is known already
  /// cost    that of joined_runs
  bool find(Document const& document);
  /// Whether a layer joins another one in a document, as it lies there. cost: that of find
  bool is_limb(Document const& document, LayerId layer);

  /// Takes another document. cost: that of find, where a part is new; that of laid_parts where any has changed
  void meet(Document const& document, BendParts const& parts);
  /// Anchors the joints of parts that have got a mesh since.
  void anchor(BendParts const& parts);

  std::vector<BendJoint> const& all() const { return joints_; }

 private:
  /// A part, and whether it was seen.
  struct Known {
    LayerId layer = LayerId::None;
    std::shared_ptr<BendPart> part;
    bool is_hidden = false;

    friend bool operator==(Known const&, Known const&) = default;
  };

  void join(Document const& document, std::set<LayerId> const& old);
  void lay(Document const& document, BendParts const& parts);

  Shared<std::vector<Shared<DocumentLayer>>> found_in_;  // the layers of a document; null: none
  std::vector<BendJoint> found_;
  std::vector<Known> known_;
  Shared<std::vector<Shared<DocumentLayer>>> laid_in_;  // the layers of a document; null: none
  std::vector<BendJoint> joints_;                       // what is laid comes last
};

/// The layers that hang on these ones, over as many joints as it takes, nearest first; the layers themselves are not among them.
/// What hangs on a part that is locked stays with it.
std::vector<LayerId> hanging_layers(std::vector<LayerId> const& layers, BendJoints const& joints,
                                    std::set<LayerId> const& locked);

/// The layers so ordered that each comes after those of its hosts that are among them. Where some hang on one another in a circle it
/// begins with the one that stands first.
std::vector<LayerId> hosts_first(std::vector<LayerId> layers, BendJoints const& joints);

}  // namespace inkflate
