// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "geometry/polyline.h"
#include "io/read_svg.h"

namespace inkflate {

/// The strokes of a drawing; a file that cannot be read counts as empty.
inline Result<Sketch> read_sketch(std::string const& path) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> const bytes{std::istreambuf_iterator<char>(stream), {}};
  auto drawing = read_svg(std::as_bytes(std::span(bytes)));
  if (!drawing) return drawing.error();
  return drawing->sketch;
}

inline Polyline line_of(Stroke const& stroke) {
  Polyline line;
  for (auto const& sample : stroke.samples) line.push_back(sample.position);
  return line;
}

/// Whether all of it could be written.
inline bool write_bytes(std::string const& path, std::span<std::byte const> bytes) {
  std::ofstream stream(path, std::ios::binary);
  for (auto const byte : bytes) stream.put(static_cast<char>(byte));
  return stream.flush().good();
}

/// The exit status after a message.
inline int fail(std::string const& message) {
  std::fprintf(stderr, "%s\n", message.c_str());
  return 1;
}

}  // namespace inkflate
