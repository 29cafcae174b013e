// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/result.h"
#include "simplify/simplify.h"
#include "simplify/work_space.h"

namespace inkflate {

/// Strokes that are closed together.
struct ClosingGroup {
  std::vector<int> strokes;  // indices into Sketch::strokes
  bool is_left_out = false;  // they shall become no layer
};

/// What is to be closed, before any of it is.
struct ClosingPlan {
  WorkSpace space;             // around all strokes
  std::vector<bool> is_faint;  // per stroke of the sketch: a construction line
  std::vector<ClosingGroup> groups;

  /// The strokes of a group that close something.
  std::vector<int> without_faint(ClosingGroup const& group) const;
};

/// Looks at a sketch and at how it shall be closed.
///
/// out     groups: with Parts::Groups one for each of the sketch's and a last one for strokes without a group, else one with all
/// errors  BadOption, BadInput, as of simplify
/// cost    O(samples)
Result<ClosingPlan> plan_closing(Sketch const& sketch, SimplifyOptions const& options);

/// The error of a sketch of which nothing can be closed.
Error nothing_enclosed();

}  // namespace inkflate
