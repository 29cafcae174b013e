// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "document/document.h"
#include "pipeline/bend_session.h"

namespace inkflate {

/// A body with an arm, on which hangs a hand, and a leg; ids 1 to 4 (body, arm, hand, leg). Each has a stroke along its
/// middle, and the body one more where the arm's mouth is.
Document jointed_document();

/// The ids of its parts.
inline constexpr LayerId kBody = LayerId{1};
inline constexpr LayerId kArm = LayerId{2};
inline constexpr LayerId kHand = LayerId{3};
inline constexpr LayerId kLeg = LayerId{4};
/// Places on its outlines.
inline constexpr Vec2 kTopOfBody = {400, 190};
inline constexpr Vec2 kBottomOfBody = {400, 710};
inline constexpr Vec2 kTipOfArm = {758.8, 330.3};

/// A hand on the body.
BendGrab body_at(Vec2 place);

/// Whether two documents share a layer.
bool is_shared(Document const& a, Document const& b, LayerId layer);

/// Someone who bends the parts of a document, one gesture after the other.
class BendHand {
 public:
  explicit BendHand(Document given) : document(std::move(given)) {}

  /// Grabs, goes there in a few moves, waits until all is still and lets go. out: the commands, applied to the document
  std::vector<Command> drag(BendGrab const& what, Vec2 to, BendReach reach = {},
                            std::optional<double> turn_rad = {});
  /// Drags a pin.
  std::vector<Command> drag_pin(LayerId layer, int pin, Vec2 to,
                                std::optional<double> turn_rad = {});
  void set_pins(LayerId layer, std::vector<BendPin> pins);
  void apply_all(std::vector<Command> const& commands);

  Document document;
  BendSession session;
  BendOptions options;
};

Layer const& layer_of_hand(Document const& document, LayerId layer);

/// The farthest that a control point of the outlines has moved between two documents, whose outlines have the same pieces; px.
double outline_distance(Document const& a, Document const& b, LayerId layer);

/// The farthest that a point of the first one's outer contour lies from the other's, px.
double contour_distance(Layer const& a, Layer const& b);

}  // namespace inkflate
