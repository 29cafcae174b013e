// SPDX-License-Identifier: Apache-2.0
#include "io/svg_path.h"

#include <array>
#include <cmath>
#include <optional>

#include "geometry/cubic.h"
#include "io/numbers.h"

namespace inkflate {
namespace {

int argument_count(char command) {
  switch (command) {
    case 'm':
    case 'l':
    case 't':
      return 2;
    case 'h':
    case 'v':
      return 1;
    case 's':
    case 'q':
      return 4;
    case 'c':
      return 6;
    case 'a':
      return 7;
    default:
      return 0;
  }
}

// An arc's flags are single digits and may stand without separators: "a1 1 0 01 5 5".
std::optional<double> take_flag(std::string_view& text) {
  if (text.empty() || (text.front() != '0' && text.front() != '1')) return std::nullopt;
  double const flag = text.front() - '0';
  text.remove_prefix(1);
  return flag;
}

using Arguments = std::array<double, 7>;

bool take_arguments(std::string_view& text, char command, Arguments& arguments) {
  std::size_t const count = static_cast<std::size_t>(argument_count(command));
  for (std::size_t i = 0; i < count; ++i) {
    skip_separator(text, i == 0 ? Separator::Blank : Separator::Comma);
    bool const is_flag = command == 'a' && (i == 3 || i == 4);
    auto const number = is_flag ? take_flag(text) : take_number(text);
    if (!number || !std::isfinite(*number)) return false;
    arguments[i] = *number;
  }
  return true;
}

// What S and T mirror: the last control point, if the command before was of their kind.
struct Reflection {
  Vec2 control;
  char family = ' ';  // 'c', 'q' or ' '

  Vec2 mirrored(Vec2 position, char wanted) const {
    return family == wanted ? 2 * position - control : position;
  }
};

void draw_quadratic(Vec2 control, Vec2 to, PathTracer& tracer) {
  auto const curve = quadratic_cubic(tracer.position(), control, to);
  tracer.cubic_to(curve.control[1], curve.control[2], to);
}

// One command with absolute meaning: origin is what its coordinates are relative to.
Reflection draw_command(char command, Arguments const& v, Vec2 origin, Reflection const& before,
                        PathTracer& tracer) {
  Vec2 const here = tracer.position();
  auto const point = [&](std::size_t i) { return origin + Vec2{v[i], v[i + 1]}; };
  switch (command) {
    case 'm':
      tracer.move_to(point(0));
      break;
    case 'l':
      tracer.line_to(point(0));
      break;
    case 'h':
      tracer.line_to({origin.x + v[0], here.y});
      break;
    case 'v':
      tracer.line_to({here.x, origin.y + v[0]});
      break;
    case 'c':
      tracer.cubic_to(point(0), point(2), point(4));
      return {point(2), 'c'};
    case 's':
      tracer.cubic_to(before.mirrored(here, 'c'), point(0), point(2));
      return {point(0), 'c'};
    case 'q':
      draw_quadratic(point(0), point(2), tracer);
      return {point(0), 'q'};
    case 't': {
      Vec2 const control = before.mirrored(here, 'q');
      draw_quadratic(control, point(0), tracer);
      return {control, 'q'};
    }
    case 'a':
      tracer.arc_to({{v[0], v[1]}, v[2], v[3] != 0, v[4] != 0, point(5)});
      break;
    default:
      tracer.close();
  }
  return {};
}

}  // namespace

bool trace_path(std::string_view data, PathTracer& tracer) {
  Reflection reflection;
  char command = ' ';
  bool is_relative = false;
  while (tracer.fault() == TraceFault::None) {
    // A comma may only stand between repeated arguments.
    bool const may_repeat = argument_count(command) > 0;
    skip_separator(data, may_repeat ? Separator::Comma : Separator::Blank);
    if (data.empty()) return true;
    char const lower = lower_ascii(data.front());
    if (argument_count(lower) > 0 || lower == 'z') {
      if (command == ' ' && lower != 'm') return false;
      command = lower;
      is_relative = lower == data.front();
      data.remove_prefix(1);
    } else if (!may_repeat) {
      return false;
    } else if (command == 'm') {
      command = 'l';  // further points of a move are lines
    }
    Arguments arguments = {};
    if (!take_arguments(data, command, arguments)) return false;
    Vec2 const origin = is_relative ? tracer.position() : Vec2{};
    reflection = draw_command(command, arguments, origin, reflection, tracer);
  }
  return true;
}

bool trace_points(std::string_view points, PointsEnd end, PathTracer& tracer) {
  bool is_first = true;
  bool is_whole = true;
  skip_separator(points, Separator::Blank);
  while (!points.empty() && tracer.fault() == TraceFault::None) {
    auto const x = take_number(points);
    skip_separator(points, Separator::Comma);
    auto const y = x ? take_number(points) : std::nullopt;
    is_whole = y && std::isfinite(*x) && std::isfinite(*y);
    if (!is_whole) break;
    if (is_first) {
      tracer.move_to({*x, *y});
    } else {
      tracer.line_to({*x, *y});
    }
    is_first = false;
    skip_separator(points, Separator::Comma);
  }
  if (end == PointsEnd::Closed && !is_first) tracer.close();
  return is_whole;
}

}  // namespace inkflate
