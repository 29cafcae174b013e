// SPDX-License-Identifier: Apache-2.0
#include "editor/tools.h"

namespace inkflate {

Step deform_step(ToolState const& /*state*/, ToolEvent const& event, ToolContext const& context) {
  if (auto const* hover = std::get_if<ToolHover>(&event)) {
    return hover_step(hover->pointer, context, pick_reach_px(context.view));
  }
  return {};
}

}  // namespace inkflate
