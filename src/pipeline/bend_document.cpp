// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_document.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "document/apply.h"
#include "document/check_values.h"
#include "pipeline/bend_rests.h"

namespace inkflate {
namespace {

// A move that begins so near to a pin of its layer moves the pin.
constexpr double kPinPx = 1;

// Shapes come to rest in some ten steps and one more for each stretch of a long way; those that cannot stop here.
constexpr int kMostRounds = 100;
constexpr int kStepsOfRound = 4;

Error cancelled() { return {ErrorCode::Cancelled, "stopped on request"}; }

bool is_valid(BendMove const& move) {
  return is_on_sheet(move.from) && is_on_sheet(move.to) &&
         is_within(move.turn_rad.value_or(0), -DocumentLimits::kBendTurnRad,
                   DocumentLimits::kBendTurnRad);
}

/// The layers that are moved, each once, in the order of the moves, and which of them each move is of.
struct MovedLayers {
  std::vector<LayerId> layers;
  std::vector<int> of_move;
};

MovedLayers moved_layers(std::vector<BendMove> const& moves) {
  MovedLayers moved;
  for (auto const& move : moves) {
    auto found = std::find(moved.layers.begin(), moved.layers.end(), move.layer);
    moved.of_move.push_back(static_cast<int>(found - moved.layers.begin()));
    if (found == moved.layers.end()) moved.layers.push_back(move.layer);
  }
  return moved;
}

/// errors  those of BendRests::root, index: the first move of the layer
Result<std::vector<BendRoot>> roots_of(Document const& document, std::vector<BendMove> const& moves,
                                       MovedLayers const& moved, BendRests& rests,
                                       BendOptions const& options) {
  std::vector<BendRoot> roots;
  for (auto const layer : moved.layers) {
    auto root = rests.root(document, layer, options);
    if (!root) {
      auto error = root.error();
      auto const move = std::find_if(moves.begin(), moves.end(),
                                     [&](BendMove const& one) { return one.layer == layer; });
      error.index = move - moves.begin();
      return error;
    }
    roots.push_back(*std::move(root));
  }
  return roots;
}

/// The handle that a move moves: a pin of the part, or a new one at the nearest place of its line.
int handle_of(BendMove const& move, int root, BendPart const& part, BendRig& rig) {
  auto const& pins = part.now().pins;
  auto const is_it = [&](HeldPin const& held) {
    return distance(held.pin.position, move.from) <= kPinPx;
  };
  auto const pin = std::find_if(pins.begin(), pins.end(), is_it);
  if (pin != pins.end()) return static_cast<int>(pin - pins.begin());
  return rig.hold(root, part.nearest(part.now().pose, move.from));
}

bool is_cancelled(Progress const& progress) {
  return progress.is_cancelled && progress.is_cancelled();
}

}  // namespace

Result<BentDocument> bend_document(Document const& document, std::vector<BendMove> const& moves,
                                   BendOptions const& options, Progress const& progress) {
  if (moves.empty()) return Error{ErrorCode::NothingThere, "no place to move"};
  if (!progress.enter("bend")) return cancelled();
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (is_valid(moves[i])) continue;
    return Error{ErrorCode::BadInput, "a place or turn that is no number or too large",
                 static_cast<long long>(i)};
  }
  BendRests rests;
  rests.meet(document);
  auto const moved = moved_layers(moves);
  auto const roots = roots_of(document, moves, moved, rests, options);
  if (!roots) return roots.error();
  auto rig = rests.rig(document, *roots, options);
  std::vector<int> handles;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    int const root = moved.of_move[i];
    auto const& move = moves[i];
    int const handle = handle_of(move, root, *(*roots)[static_cast<std::size_t>(root)].part, rig);
    handles.push_back(handle);
    rig.move(root, handle, rig.start(root, handle) + (move.to - move.from), move.turn_rad);
  }
  BentDocument bent;
  for (int i = 0; i < kMostRounds && !rig.is_settled(); ++i) {
    if (is_cancelled(progress)) return cancelled();
    rig.step(kStepsOfRound);
    bent.steps += kStepsOfRound;
  }
  bent.is_settled = rig.is_settled();
  rig.snap();
  for (std::size_t i = 0; i < moves.size(); ++i) {
    bent.ends.push_back(rig.end(moved.of_move[i], handles[i]));
  }
  bent.commands = rig.commands();
  if (bent.commands.empty()) return Error{ErrorCode::NothingThere, "nothing moves"};
  return bent;
}

}  // namespace inkflate
