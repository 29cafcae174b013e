// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/affine.h"
#include "io/path_tracer.h"
#include "io/read_svg.h"
#include "io/sketch_limits.h"
#include "io/svg_tree.h"

namespace inkflate {

/// How much one file may make us do, beyond what XmlLimits bounds.
struct SvgLimits {
  int points_per_element = 1'000'000;
  int samples = kSampleLimit;
  int strokes = 1'000'000;
  int use_expansions = 500'000;
  int use_depth = 64;
  std::int64_t copied_bytes = std::int64_t{64}
                              << 20U;  // read again because of use, each element as 64 or more
};

/// Goes through the elements that a viewer would draw, in its order and without recursion, and collects their strokes.
class SvgWalk {
 public:
  explicit SvgWalk(SvgTree const& tree, SvgLimits const& limits = {})
      : tree_(tree), limits_(limits) {}

  SvgReading run() &&;

 private:
  /// What an element takes over from those around it.
  struct Context {
    Affine to_canvas;
    Style style;
    Vec2 viewport;        // size in user units
    int group_node = -1;  // the group that the strokes join
    bool is_help = false;
  };
  /// A range of siblings still to be visited.
  struct Frame {
    int next = 0;
    int end = 0;
    Context context;
    int use_node = -1;  // the use element whose target this frame is; -1: none
    std::optional<double> use_width;
    std::optional<double> use_height;
  };
  /// Where a viewport lies in the user space around it.
  struct Place {
    Vec2 position;
    Vec2 size;
  };

  Context enter_root();
  std::vector<int> children(int node) const;
  void find_group_level();
  void visit(int node, Frame const& frame);
  Context child_context(int node, SvgElement const& element, Context const& parent);
  void enter_group(int node, SvgElement const& element, Context& context);
  void enter_viewport(int node, SvgElement const& element, Place const& place, Context& context);
  void visit_viewport(int node, SvgElement const& element, Frame const& frame, Context& context);
  void visit_use(int node, SvgElement const& element, Context& context);
  void visit_shape(int node, SvgElement const& element, Context const& context);
  void add_strokes(std::vector<Polyline> subpaths, Stroke const& pen, bool is_outline_of_area);
  bool is_background(std::vector<Polyline> const& subpaths) const;
  bool contains_open_use(int node) const;
  int group_index(int node);
  void read_group_data(int node, SvgElement const& element, StrokeGroup& group);
  void warn(std::string_view reason, int node);

  SvgTree const& tree_;
  SvgLimits limits_;
  SvgReading reading_;
  std::vector<Frame> frames_;
  std::vector<int> open_uses_;  // the use elements being expanded, outermost first
  std::map<int, int> group_of_node_;
  std::size_t group_depth_ = 1;  // how many elements are open around a candidate layer
  bool only_named_groups_ = false;
  bool has_canvas_ = false;
  int sample_count_ = 0;
  int expansion_count_ = 0;
  std::int64_t bytes_left_ = 0;
};

}  // namespace inkflate
