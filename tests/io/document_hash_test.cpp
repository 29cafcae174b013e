// SPDX-License-Identifier: Apache-2.0
#include "io/document_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "io/bytes.h"
#include "io/read_inkflate.h"
#include "io/read_svg.h"
#include "io/write_inkflate.h"
#include "io/write_svg.h"
#include "support/random_drawing.h"

namespace inkflate {
namespace {

Project small_project() {
  Project project;
  project.drawing.sketch = {
      300, 200, {{"leg"}}, {Stroke{{{{1, 2}}, {{0.1, 1e-9}, 0.5, 0.25}}, StrokeKind::Ink, 2, {}}}};
  project.drawing.layers = {{"body", {}, {0}, {}}};
  project.drawing.layers[0].id = LayerId{1};
  project.pins = {{PinId{2}, LayerId{1}, Side::Front, {1, 1}, {2, 2}}};
  project.clip = {2, {{PinId{2}, {{0, {2, 2}}}, 0.25}}};
  project.next_id = 3;
  project.template_picture = Picture(2, 1, Colour{1, 2, 3, 4});
  return project;
}

// The same on every machine and in every version: else a document changed by being looked at.
TEST(DocumentHash, IsWhatItEverWas) {
  EXPECT_EQ(document_hash({}), 0xcef7e9651269d320U);
  EXPECT_EQ(document_hash(small_project()), 0x29ab5f6361f2d035U);
}

TEST(DocumentHash, TellsEveryMemberApart) {
  std::vector<std::function<void(Project&)>> const changes = {
      [](Project&) {},
      [](Project& p) { p.drawing.sketch.width_px = 301; },
      [](Project& p) { p.drawing.sketch.strokes[0].depth = StrokeDepth::Far; },
      [](Project& p) { p.drawing.sketch.strokes[0].samples[1].time_s = 0.5; },
      [](Project& p) { p.drawing.layers[0].noise = {0}; },
      [](Project& p) { p.drawing.layers[0].is_hidden = true; },
      [](Project& p) { p.drawing.layers[0].is_locked = true; },
      [](Project& p) { p.drawing.layers[0].is_open = true; },
      [](Project& p) { p.drawing.layers[0].id = LayerId{2}; },
      [](Project& p) { p.drawing.layers[0].choice.gap_px = 5; },
      [](Project& p) { p.drawing.choice.gap_px = 5; },
      [](Project& p) {
        p.drawing.choice.outside = {{1, 2}};
      },
      [](Project& p) {
        p.drawing.choice.inside = {{1, 2}};
      },
      [](Project& p) { p.pins[0].side = Side::Back; },
      [](Project& p) { p.pins[0].position.x = 3; },
      [](Project& p) { p.clip.length_s = 3; },
      [](Project& p) { p.clip.tracks[0].phase_s = 0; },
      [](Project& p) { p.clip.tracks[0].keys[0].time_s = 1; },
      [](Project& p) { p.next_id = 4; },
      [](Project& p) { p.template_picture.reset(); },
      [](Project& p) { p.template_picture->values[1].a = 5; },
      [](Project& p) {
        *p.template_picture = Picture(1, 2, Colour{1, 2, 3, 4});
      }};
  std::set<std::uint64_t> hashes;
  for (auto const& change : changes) {
    auto project = small_project();
    change(project);
    hashes.insert(document_hash(project));
  }
  EXPECT_EQ(hashes.size(), changes.size());
}

TEST(DocumentHash, IsTheSameForEveryFormatThatKeepsAll) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    Project const project = {test::random_drawing(rng)};
    auto const svg = write_svg(project.drawing);
    EXPECT_EQ(document_hash({*read_svg(as_bytes(svg))}), document_hash(project));
    EXPECT_EQ(document_hash(*read_inkflate(*write_inkflate(project))), document_hash(project));
  }
}

}  // namespace
}  // namespace inkflate
