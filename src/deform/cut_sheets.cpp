// SPDX-License-Identifier: Apache-2.0
#include "deform/cut_sheets.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "geometry/crossings.h"
#include "geometry/predicates.h"

namespace inkflate {
namespace {

// Chords are looked for between so many points of the rim, evenly spread over it.
constexpr int kChordEnds = 64;
// What crosses itself more often, or takes more cuts, is a scribble.
constexpr int kMostCrossings = 1000;
constexpr std::size_t kMostPieces = 64;

/// A chord from corner `from` to corner `to` of a polygon.
struct Chord {
  int from = 0;
  int to = 0;
  int left_over = 0;  // crossings that neither side is rid of
  double squared_px = 0;
};

bool is_left(Vec2 a, Vec2 b, Vec2 p) { return orientation_sign(a, b, p) > 0; }

class Cutter {
 public:
  Cutter(Contour const& rim, double edge_px) : edge_px_(edge_px) {
    sheets_.points = rim;
    std::vector<int> whole;
    for (int i = 0; i < std::ssize(rim); ++i) whole.push_back(i);
    waiting_.push_back(std::move(whole));
  }

  std::optional<RimSheets> run() && {
    while (!waiting_.empty()) {
      auto piece = std::move(waiting_.back());
      waiting_.pop_back();
      auto const contour = contour_of(piece);
      auto const crossings = find_crossings(std::span(&contour, 1), kMostCrossings);
      if (crossings.empty()) {
        if (!(signed_area(contour) > 0)) return std::nullopt;
        sheets_.pieces.push_back(std::move(piece));
        continue;
      }
      bool const is_too_much = std::ssize(crossings) >= kMostCrossings ||
                               sheets_.pieces.size() + waiting_.size() >= kMostPieces;
      auto const chord = is_too_much ? std::nullopt : best_chord(contour, crossings);
      if (!chord) return std::nullopt;
      cut(piece, *chord);
    }
    std::stable_sort(sheets_.pieces.begin(), sheets_.pieces.end(),
                     [&](std::vector<int> const& a, std::vector<int> const& b) {
                       return signed_area(contour_of(a)) < signed_area(contour_of(b));
                     });
    return std::move(sheets_);
  }

 private:
  Contour contour_of(std::span<int const> piece) const {
    Contour contour;
    for (int const v : piece) contour.push_back(sheets_.points[v]);
    return contour;
  }

  /// The chord that leaves the fewest crossings, of those the shortest.
  static std::optional<Chord> best_chord(Contour const& contour,
                                         std::span<Crossing const> crossings) {
    auto chords = chords_of(contour, crossings);
    std::sort(chords.begin(), chords.end(), [](Chord const& a, Chord const& b) {
      if (a.left_over != b.left_over) return a.left_over < b.left_over;
      if (a.squared_px != b.squared_px) return a.squared_px < b.squared_px;
      return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
    auto const first_of = [&](auto const& is_it) {
      auto const found = std::find_if(chords.begin(), chords.end(), is_it);
      return found == chords.end() ? std::nullopt : std::optional(*found);
    };
    auto const inside = first_of(
        [&](Chord const& chord) { return is_inside(contour, chord) && is_free(contour, chord); });
    // In an armpit that is bent sharply the shape goes more than once around a point of its rim.
    return inside ? inside : first_of([&](Chord const& chord) { return is_free(contour, chord); });
  }

  /// Those that are any use.
  static std::vector<Chord> chords_of(Contour const& contour, std::span<Crossing const> crossings) {
    int const count = static_cast<int>(std::ssize(contour));
    int const ends = std::min(count, kChordEnds);
    std::vector<Chord> chords;
    for (int k = 0; k < ends; ++k) {
      for (int m = k + 1; m < ends; ++m) {
        Chord chord = {k * count / ends, m * count / ends, 0, 0};
        if (chord.to - chord.from < 2 || chord.to - chord.from > count - 2) continue;
        auto const is_between = [&](int edge) { return edge >= chord.from && edge < chord.to; };
        chord.left_over = static_cast<int>(
            std::count_if(crossings.begin(), crossings.end(), [&](Crossing const& crossing) {
              return is_between(crossing.edge_a) == is_between(crossing.edge_b);
            }));
        chord.squared_px = squared_norm(contour[chord.to] - contour[chord.from]);
        if (chord.left_over < std::ssize(crossings)) chords.push_back(chord);
      }
    }
    return chords;
  }

  /// Whether the chord begins and ends towards the inside.
  static bool is_inside(Contour const& contour, Chord const& chord) {
    int const count = static_cast<int>(std::ssize(contour));
    auto const looks_inside = [&](int v, int other) {
      Vec2 const before = contour[(v + count - 1) % count];
      Vec2 const at = contour[v];
      Vec2 const after = contour[(v + 1) % count];
      Vec2 const to = contour[other];
      bool const is_convex = is_left(before, at, after);
      bool const beyond_first = is_left(at, after, to);
      bool const before_last = is_left(before, at, to);
      return is_convex ? beyond_first && before_last : beyond_first || before_last;
    };
    return looks_inside(chord.from, chord.to) && looks_inside(chord.to, chord.from);
  }

  /// Whether the chord meets no edge but those at its ends.
  static bool is_free(Contour const& contour, Chord const& chord) {
    int const count = static_cast<int>(std::ssize(contour));
    for (int edge = 0; edge < count; ++edge) {
      int const next = (edge + 1) % count;
      bool const is_at_end =
          edge == chord.from || edge == chord.to || next == chord.from || next == chord.to;
      if (is_at_end) continue;
      if (segments_touch(contour[chord.from], contour[chord.to], contour[edge], contour[next]))
        return false;
    }
    return true;
  }

  void cut(std::span<int const> piece, Chord const& chord) {
    Vec2 const from = sheets_.points[piece[chord.from]];
    Vec2 const to = sheets_.points[piece[chord.to]];
    int const edges =
        static_cast<int>(std::clamp(std::round(distance(from, to) / edge_px_), 1.0, 1e4));
    std::vector<int> seam;
    for (int k = 1; k < edges; ++k) {
      seam.push_back(static_cast<int>(std::ssize(sheets_.points)));
      sheets_.points.push_back(lerp(from, to, static_cast<double>(k) / edges));
    }
    std::vector<int> between(piece.begin() + chord.from, piece.begin() + chord.to + 1);
    between.insert(between.end(), seam.rbegin(), seam.rend());
    std::vector<int> around(piece.begin() + chord.to, piece.end());
    around.insert(around.end(), piece.begin(), piece.begin() + chord.from + 1);
    around.insert(around.end(), seam.begin(), seam.end());
    waiting_.push_back(std::move(between));
    waiting_.push_back(std::move(around));
  }

  double edge_px_;
  RimSheets sheets_;
  std::vector<std::vector<int>> waiting_;
};

}  // namespace

std::optional<RimSheets> cut_into_sheets(Contour const& rim, double edge_px) {
  return Cutter(rim, edge_px).run();
}

}  // namespace inkflate
