// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "deform/bend_options.h"
#include "editor/events.h"
#include "geometry/affine.h"
#include "geometry/rect.h"
#include "model/drawing.h"
#include "render/draw_model.h"

namespace inkflate {

/// How the paper lies under the window. Immutable: each change gives another camera.
struct Camera {
  Vec2 centre = {500, 500};  // px; in the middle of the view; within DocumentLimits::kFarthestPx
  double zoom = 1;           // px of the screen for one of the canvas, kLeastZoom .. kLargestZoom
  bool is_mirrored = false;  // left and right change places on the screen

  friend bool operator==(Camera const&, Camera const&) = default;

  static constexpr double kLeastZoom = 0.02;
  static constexpr double kLargestZoom = 64;
};

struct ViewSize {
  double width_px = 1000;
  double height_px = 1000;
  ViewEdges edges = {};  // each >= 0; two that face each other no more than the side between them

  friend bool operator==(ViewSize const&, ViewSize const&) = default;
};

/// What bars and panels leave free of the view, px of the screen, where drawings that are fitted go: at least half of each side, however
/// small the window is.
Rect free_room(ViewSize const& size);
/// The height for a model, which stands in the middle of the view: as much is free below as above, and at least half of the view.
double free_height_px(ViewSize const& size);

/// Of all that follows: camera, model view and size are finite; a stretch, place, factor or box that is not, or that means
/// nothing, changes nothing.

Affine canvas_to_screen(Camera const& camera, ViewSize const& size);
Vec2 to_canvas(Camera const& camera, ViewSize const& size, Vec2 screen);

/// The paper follows the hand: moved by a stretch of the screen.
Camera panned(Camera const& camera, Vec2 screen_delta);
/// Larger by a factor, with the place under the pointer staying where it is. The zoom stays within its limits, and the paper
/// within reach.
Camera zoomed(Camera const& camera, ViewSize const& size, Vec2 screen, double factor);
/// So that a rectangle of the canvas fills the free room but for a margin, as near to the middle of the view as it can lie there; a single
/// place comes to the middle.
Camera fitted(Camera const& camera, ViewSize const& size, Rect const& box);
/// Left and right change places; the middle of the view stays.
Camera mirrored(Camera const& camera);

inline constexpr double kLeastModelZoom = 0.1;
inline constexpr double kLargestModelZoom = 20;

/// The viewer walks on around the model and rises above it: turn stays in [-pi, pi), tilt within a quarter turn.
ModelView turned(ModelView const& model, double turn_rad, double tilt_rad);
/// The model follows the hand.
ModelView panned(ModelView const& model, Vec2 screen_delta);
/// Larger by a factor, with the place under the pointer staying where it is.
ModelView zoomed(ModelView const& model, ViewSize const& size, Vec2 screen, double factor);

enum class Mode { Draw, Inflate, Animate };

enum class Tool { Brush, HelpLine, Eraser, Mark, Deform, Select, Hand };

/// How a person works, which no document knows.
struct ToolSettings {
  double brush_px = 3;  // width of strokes, canvas px, 0.5 .. 100
  Colour ink = {0x22, 0x24, 0x2b};
  double smoothing = 0.5;  // 0 .. 1: how much of the hand's tremble is taken out
  double eraser_px = 12;   // radius on the screen
  BendMode bend_mode = BendMode::Body;
  double bend_body = 1;  // BendOptions::kLeastBody .. 1: how stiff the inside is beside the line
  /// How far a drag reaches, as a share of the longer side of the part's box, kLeastBendReach .. 1. 1: the whole part; none: as the part
  /// is held.
  std::optional<double> bend_reach = {};

  static constexpr double kLeastBrushPx = 0.5;
  static constexpr double kLargestBrushPx = 100;
  static constexpr double kLeastEraserPx = 1;
  static constexpr double kLargestEraserPx = 200;
  static constexpr double kLeastBendReach = 0.02;

  friend bool operator==(ToolSettings const&, ToolSettings const&) = default;
};

/// A pin of a part, by which it is held while it is bent.
struct BendPinRef {
  LayerId layer = LayerId::None;
  int index = 0;  // into Layer::bend_pins

  friend bool operator==(BendPinRef const&, BendPinRef const&) = default;
};

/// What is looked at and how; none of it is in the document.
struct View {
  ViewSize size;
  Camera camera;
  Mode mode = Mode::Draw;
  Tool tool = Tool::Brush;
  ToolSettings settings;
  std::vector<LayerId> selection;  // ascending
  LayerId hover = LayerId::None;
  std::optional<BendPinRef> pin;  // that is selected, while the tool is Deform
  bool has_grid = true;           // lines of the paper
  ModelView model;                // modes Inflate and Animate
  Shading shading = Shading::Textured;
};

bool is_selected(View const& view, LayerId layer);

}  // namespace inkflate
