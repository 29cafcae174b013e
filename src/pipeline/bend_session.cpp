// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "document/apply.h"
#include "document/check_values.h"
#include "pipeline/bend_rests.h"

namespace inkflate {
namespace {

// Of what is held by hand: as many as a frame has room for, and between frames of the pointer.
constexpr int kStepsOfDrag = 2;
constexpr int kStepsOfSettling = 4;

// A shape comes to rest in about ten steps, each stretch that the hand jumped over takes one more. Shapes that cannot come to rest stop
// here.
constexpr int kMostIdleRounds = 60;

// After this many rounds what the new reach lets move is about where it was.
constexpr int kRoundsOfReach = 6;

bool is_valid(BendReach const& reach) {
  return !reach.px || (*reach.px > 0 && std::isfinite(*reach.px));
}

Vec2 on_sheet(Vec2 p) {
  constexpr double most = DocumentLimits::kFarthestPx;
  return {std::clamp(p.x, -most, most), std::clamp(p.y, -most, most)};
}

BendSource source_of(Document const& document, BendGrab const& what) {
  if (what.layer != LayerId::None) return {layer_of(document, what.layer), {}};
  return {{}, stroke_of(document, *what.stroke)};
}

/// Whether parts need no other mesh for other options.
bool has_same_mesh(BendOptions const& a, BendOptions const& b) {
  return a.mode == b.mode && a.strip_half_width_px == b.strip_half_width_px;
}

Error bad_input(char const* message) { return {ErrorCode::BadInput, message}; }

}  // namespace

struct BendSession::Inside {
  /// A copy of the rests that has met another document.
  struct Ahead {
    BendRests rests;
    Shared<std::vector<Shared<DocumentLayer>>> layers = {};  // of that document; null: none
    BendOptions options = {};
    bool is_prepared = false;
  };

  BendRests rests;
  BendOptions options;  // of the rests
  Ahead ahead;
  std::optional<BendRig> rig;  // while something is held
  std::shared_ptr<BendPart> part;
  int handle = 0;
  BendAnchor anchor;      // of the handle
  Vec2 from_place;        // from where the hand took it to where the handle is
  bool is_loose = false;  // no pin holds the place
  BendPose loose_from;    // then: where the part was before it was dragged by this place
  int idle_rounds = 0;    // since the hand moved

  /// A person may have as much idle time as there is, or none: it leaves no trace in the rests, which are what grabs make of them. So it
  /// works on a copy, which the next grab takes if it is of its document.
  void look_ahead(Document const& document, BendOptions const& wanted) {
    if (!has_same_mesh(ahead.options, wanted)) ahead = {};
    ahead.is_prepared = ahead.is_prepared && ahead.options == wanted;
    ahead.options = wanted;
    if (ahead.layers == document.layers) return;
    auto next = has_same_mesh(options, wanted) ? rests : BendRests();
    next.meet(document, ahead.rests);
    ahead = {std::move(next), document.layers, wanted};
  }

  std::optional<Error> grab(Document const& document, BendGrab const& what, BendReach reach,
                            BendOptions const& wanted) {
    look_ahead(document, wanted);
    rests = std::exchange(ahead, {}).rests;
    options = wanted;
    auto const by = what.pin ? std::nullopt : std::optional(what.place);
    is_loose = by.has_value();
    rests.set_loose_ends(document, source_of(document, what), by);
    auto root = what.layer == LayerId::None ? rests.root(document, *what.stroke, options)
                                            : rests.root(document, what.layer, options);
    if (!root) return root.error();
    part = root->part;
    loose_from = part->now().loose_end ? part->now().loose_from : part->now().pose;
    auto const& pins = part->now().pins;
    if (what.pin && (*what.pin < 0 || *what.pin >= std::ssize(pins))) {
      return bad_input("the part has no such pin");
    }
    auto made = rests.rig(document, {*root}, options);
    auto const& at = what.pin ? pins[static_cast<std::size_t>(*what.pin)].anchor
                              : part->held_at(what.place, what.is_inside);
    anchor = at;
    handle = what.pin ? *what.pin : made.hold(0, anchor);
    from_place = made.start(0, handle) - what.place;
    rig = std::move(made);
    set_reach(reach);
    idle_rounds = 0;
    return std::nullopt;
  }

  void set_reach(BendReach reach) {
    // Of a pin that is dragged again the shape has to be that of its new place alone.
    bool const is_soft = is_loose && options.mode == BendMode::Body;
    auto const end = is_soft ? ReachEnd::Soft : ReachEnd::Stiff;
    rig->keep_within(reach.px ? part->bender().within_reach(anchor, *reach.px, end) : BendArea{});
  }

  bool is_settled() const { return idle_rounds >= kMostIdleRounds || rig->is_settled(); }
};

BendSession::BendSession() : inside_(std::make_unique<Inside>()) {}
BendSession::~BendSession() = default;
BendSession::BendSession(BendSession&&) noexcept = default;
BendSession& BendSession::operator=(BendSession&&) noexcept = default;

void BendSession::prepare(Document const& document, BendOptions const& options) {
  if (is_holding() || is_prepared(document, options)) return;
  auto& ahead = inside_->ahead;
  inside_->look_ahead(document, options);
  ahead.is_prepared = !ahead.rests.prepare(document, options);
}

bool BendSession::is_prepared(Document const& document, BendOptions const& options) const {
  auto const& ahead = inside_->ahead;
  return ahead.is_prepared && ahead.layers == document.layers && ahead.options == options;
}

bool BendSession::is_limb(Document const& document, LayerId layer) {
  auto& ahead = inside_->ahead;
  return (ahead.layers ? ahead.rests : inside_->rests).is_limb(document, layer);
}

std::optional<Error> BendSession::grab(Document const& document, BendGrab const& what,
                                       BendReach reach, BendOptions const& options) {
  release(nullptr);
  if (!is_on_sheet(what.place) || !is_valid(reach)) {
    return bad_input("a place or a reach that is no number or too large");
  }
  if (what.layer == LayerId::None && !what.stroke) {
    return Error{ErrorCode::NothingThere, "there is no line to hold here"};
  }
  return inside_->grab(document, what, reach, options);
}

void BendSession::drag(Vec2 target, std::optional<double> turn_rad) {
  auto& inside = *inside_;
  bool const is_number =
      is_finite(target) &&
      is_within(turn_rad.value_or(0), -DocumentLimits::kBendTurnRad, DocumentLimits::kBendTurnRad);
  if (!inside.rig || !is_number) return;
  inside.rig->move(0, inside.handle, on_sheet(target + inside.from_place), turn_rad);
  inside.rig->step(kStepsOfDrag);
  inside.idle_rounds = 0;
}

void BendSession::set_reach(BendReach reach) {
  auto& inside = *inside_;
  if (!inside.rig || !is_valid(reach)) return;
  inside.set_reach(reach);
  inside.rig->restart();
  inside.idle_rounds = 0;
  for (int i = 0; i < kRoundsOfReach && !inside.is_settled(); ++i) settle();
}

bool BendSession::is_holding() const { return inside_->rig.has_value(); }

bool BendSession::is_settled() const { return !inside_->rig || inside_->is_settled(); }

void BendSession::settle() {
  if (is_settled()) return;
  inside_->rig->step(kStepsOfSettling);
  ++inside_->idle_rounds;
}

void BendSession::finish() {
  if (inside_->rig) inside_->rig->finish();
}

std::vector<Command> BendSession::commands() const {
  return inside_->rig ? inside_->rig->commands() : std::vector<Command>{};
}

void BendSession::release(Document const* result) {
  if (inside_->rig && result != nullptr) {
    inside_->rig->remember(*result);
    if (inside_->is_loose) inside_->part->leave_loose(inside_->anchor, inside_->loose_from);
  }
  inside_->rig.reset();
  inside_->part.reset();
}

void BendSession::forget() {
  release(nullptr);
  inside_->rests = {};
  inside_->ahead = {};
}

}  // namespace inkflate
