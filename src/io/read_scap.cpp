// SPDX-License-Identifier: Apache-2.0
#include "io/read_scap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/rect.h"
#include "io/numbers.h"
#include "io/sketch_limits.h"

namespace inkflate {
namespace {

class ScapReader {
 public:
  Result<Sketch> read(std::string_view text) && {
    while (!text.empty()) {
      auto const end = std::min(text.find_first_of("\n{}"), text.size());
      if (auto error = read_line(trimmed(text.substr(0, end)))) return *error;
      if (end < text.size() && text[end] == '\n') {
        ++line_;
      } else if (end < text.size()) {
        bool const opens = text[end] == '{';
        if (opens == is_in_stroke_) return fault("a brace that does not match");
        opens ? open_stroke() : close_stroke();
      }
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (is_in_stroke_) return fault("the file ends inside a stroke; a '}' is missing");
    if (!has_content_) return fault("not a .scap file: neither a canvas line nor a stroke");
    if (!has_canvas_) fit_canvas();
    return std::move(sketch_);
  }

 private:
  Error fault(std::string const& what) const {
    return {ErrorCode::BadInput, what + " (line " + std::to_string(line_) + ")", line_};
  }

  // A line, or the part of one beside a brace.
  std::optional<Error> read_line(std::string_view line) {
    if (line.empty()) return std::nullopt;
    if (line.front() == '@') return read_width(line.substr(1));
    if (line.front() != '#') return read_sample(line);
    // In a stroke the identifier and its clusters; in front of all strokes the canvas.
    return is_in_stroke_ || has_canvas_ ? std::nullopt : read_canvas(line.substr(1));
  }

  void open_stroke() {
    is_in_stroke_ = has_content_ = true;
    stroke_ = Stroke{};
    stroke_.width_px = width_px_;
    has_pressure_ = false;
  }

  void close_stroke() {
    is_in_stroke_ = false;
    if (stroke_.samples.empty()) return;
    if (!has_pressure_) {
      for (auto& sample : stroke_.samples) sample.pressure = 1;
    }
    sketch_.strokes.push_back(std::move(stroke_));
  }

  std::optional<Error> read_width(std::string_view text) {
    auto const width = take(text);
    if (!width || !(*width >= 0)) return fault("a width that is not a number from 0 on");
    (is_in_stroke_ ? stroke_.width_px : width_px_) = *width;
    return std::nullopt;
  }

  std::optional<Error> read_canvas(std::string_view text) {
    auto const width = take(text);
    auto const height = take(text);
    if (!width || !height || !(*width > 0) || !(*height > 0)) {
      return fault("a canvas that is not two numbers above 0");
    }
    sketch_.width_px = *width;
    sketch_.height_px = *height;
    has_canvas_ = has_content_ = true;
    return std::nullopt;
  }

  std::optional<Error> read_sample(std::string_view text) {
    if (!is_in_stroke_) return fault("not part of a .scap file");
    if (sample_count_ >= kSampleLimit) {
      return Error{ErrorCode::TooLarge, "the sketch has more than 5 000 000 samples", line_};
    }
    auto const x = take(text);
    auto const y = take(text);
    auto const pressure = trimmed(text).empty() ? 0.0 : take(text);
    if (!x || !y || !pressure)
      return fault("a sample needs finite numbers within 1e6: x y pressure");
    if (*pressure != 0) has_pressure_ = true;
    stroke_.samples.push_back({{*x, *y}, std::clamp(*pressure, 0.0, 1.0)});
    ++sample_count_;
    return std::nullopt;  // further columns, such as a time, are passed over
  }

  static std::optional<double> take(std::string_view& text) {
    skip_separator(text, Separator::Comma);
    auto const number = take_number(text);
    bool const is_usable = number && std::abs(*number) <= kCoordinateLimit;
    return is_usable ? number : std::nullopt;
  }

  void fit_canvas() {
    Rect box;
    for (auto const& stroke : sketch_.strokes) {
      for (auto const& sample : stroke.samples) box.include(sample.position);
    }
    sketch_.width_px = box.is_empty() ? 1 : std::max(1.0, std::ceil(box.max.x));
    sketch_.height_px = box.is_empty() ? 1 : std::max(1.0, std::ceil(box.max.y));
  }

  Sketch sketch_;
  Stroke stroke_;
  double width_px_ = Stroke{}.width_px;
  long long line_ = 1;
  int sample_count_ = 0;
  bool is_in_stroke_ = false;
  bool has_pressure_ = false;
  bool has_canvas_ = false;
  bool has_content_ = false;
};

}  // namespace

Result<Sketch> read_scap(std::span<std::byte const> bytes) {
  if (std::ssize(bytes) > kMaxFileBytes)
    return Error{ErrorCode::TooLarge, "the file has more than 64 MB"};
  std::string_view text(reinterpret_cast<char const*>(bytes.data()), bytes.size());
  auto const mark = text.substr(0, 2);
  if (mark == "\xff\xfe" || mark == "\xfe\xff") {
    return Error{ErrorCode::Unsupported, "the file is in UTF-16; save it as UTF-8", 1};
  }
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  return ScapReader().read(text);
}

}  // namespace inkflate
