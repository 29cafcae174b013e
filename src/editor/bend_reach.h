// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "document/document.h"
#include "editor/view.h"
#include "pipeline/bend_session.h"

namespace inkflate {

/// How far a drag reaches where nothing holds a part, as a share of the longer side of its box: a hand bends a limb or a cheek, and the
/// rest stays. Half of it follows freely.
///
/// out     of mode Wire half as much, as all that it reaches follows
double usual_bend_reach(BendMode mode);

/// How far a drag reaches as a share of what it holds where nobody has said it: all (1) of a part that pins or joints hold, and a share
/// of any other and of a line (LayerId::None).
///
/// session: knows what joins what
double usual_share(Document const& document, LayerId layer, BendMode mode, BendSession& session);

/// As the person has set it, 0.02 .. 1; else usual_share().
double bend_share(Document const& document, BendGrab const& what, ToolSettings const& settings,
                  BendSession& session);

/// The share in px of the canvas.
BendReach bend_reach(Document const& document, BendGrab const& what, double share);

}  // namespace inkflate
