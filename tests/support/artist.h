// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "editor/engine.h"

namespace inkflate {

/// Someone who works with the program: events go into an engine with a view of 1000 x 1000 px on the canvas, which it shows px for px;
/// what comes out is kept.
class Artist {
 public:
  explicit Artist(Progress progress = {}) : engine_(std::move(progress)) {}

  Engine& engine() { return engine_; }
  Document const& document() const { return engine_.document(); }
  EngineState state() const { return engine_.state(); }

  bool has_said(Word word) const;
  /// The one layer that there has to be.
  Layer const& only_layer() const;
  /// Of what is seen of the document.
  std::uint64_t hash() const;

  std::vector<Message> messages;
  std::vector<FileOut> files;
  std::vector<std::string> studio_actions;
  std::string journal;  // the file that a studio would keep

  /// Of the last event and the work after it.
  Changes send(Event const& event) {
    auto changes = engine_.handle(event);
    keep(changes);
    while (engine_.has_work()) keep(engine_.work());
    return changes;
  }

  Changes act(std::string name, std::string argument = {}) {
    return send(ActionEvent{std::move(name), std::move(argument)});
  }

  Changes key(std::string key, Modifiers modifiers = {}) {
    KeyEvent event;
    event.key = std::move(key);
    event.modifiers = modifiers;
    auto changes = send(event);
    event.is_press = false;
    send(event);
    return changes;
  }

  void press(Vec2 at, PointerButton button = PointerButton::Primary, Modifiers modifiers = {}) {
    button_ = button;
    modifiers_ = modifiers;
    time_s_ += 1;  // too long after the one before for a double click
    point(PointerAction::Press, at, button);
  }
  void move(Vec2 at) { point(PointerAction::Move, at, PointerButton::None); }
  void release(Vec2 at) { point(PointerAction::Release, at, button_); }

  /// A line by hand, through these points.
  void draw(std::vector<Vec2> const& line, PointerButton button = PointerButton::Primary,
            Modifiers modifiers = {}) {
    press(line.front(), button, modifiers);
    for (auto const p : line) move(p);
    release(line.back());
  }

  void click(Vec2 at, PointerButton button = PointerButton::Primary, Modifiers modifiers = {}) {
    draw({at}, button, modifiers);
  }

  void double_click(Vec2 at, PointerButton button = PointerButton::Primary) {
    click(at, button);
    click_again(at, button);
  }

  /// The second click of a double click.
  void click_again(Vec2 at, PointerButton button = PointerButton::Primary) {
    time_s_ -= 0.9;
    click(at, button);
  }

  /// A rough circle, drawn as two halves that do not meet by gap_px.
  void draw_circle(Vec2 centre, double radius, double gap_px = 6,
                   PointerButton button = PointerButton::Primary);

 private:
  void keep(Changes const& changes) {
    messages.insert(messages.end(), changes.messages.begin(), changes.messages.end());
    files.insert(files.end(), changes.files.begin(), changes.files.end());
    studio_actions.insert(studio_actions.end(), changes.studio_actions.begin(),
                          changes.studio_actions.end());
    if (changes.is_journal_new) journal.clear();
    journal += changes.journal;
  }

  void point(PointerAction action, Vec2 at, PointerButton button) {
    PointerEvent event;
    event.action = action;
    event.button = button;
    event.screen = at;
    event.time_s = time_s_ += 0.008;
    event.modifiers = modifiers_;
    send(event);
  }

  Engine engine_;
  double time_s_ = 0;
  PointerButton button_ = PointerButton::Primary;
  Modifiers modifiers_;
};

}  // namespace inkflate
