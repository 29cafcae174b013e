# SPDX-License-Identifier: Apache-2.0
"""The hand: how somebody with a pen would follow a designed curve.

Nobody draws an outline in one go. The arm makes strokes of a certain reach, shorter where the line
bends; each starts a little early, ends a little late and leaves the curve there; it lies beside the
curve by an error that changes slowly; and the whole outline is gone over more than once.
"""

from math import sqrt

from sketching.curve import distance

CALM_REACH_PX = 270.0  # a stroke on a straight
TIGHT_REACH_PX = 75.0  # a stroke around a curl
CURL = 1 / 55          # curvature at which the reach is half way between the two
OPEN_END_FLY_PX = 8.0  # how far a stroke shoots over a corner


class Hand:
    """How steady and how generous; lengths in px."""

    def __init__(self, chance, drift=2.3, tremor=0.35, flare=7.0, reach=1.0, skip=0.07):
        self.chance = chance
        self.drift = drift    # slow error beside the curve
        self.tremor = tremor  # fast error
        self.flare = flare    # how far the ends of a stroke leave the curve
        self.reach = reach    # multiplies the length of strokes
        self.skip = skip      # probability that a later pass leaves a stroke out

    def passes(self, curve, count, gaps=()):
        """Goes over a curve `count` times, keeping off `gaps` [(from, to)] along it."""
        strokes = []
        for number in range(count):
            exploring = number == 0 and count > 1
            for low, high in free_runs(curve, [self.fuzzy(gap) for gap in gaps]):
                is_whole = curve.closed and not gaps
                for start, end in self.cut(curve, low, high, number, is_whole):
                    if number > 0 and self.chance.happens(self.skip):
                        continue
                    start, end = self.run_over(start, end, low, high, is_whole)
                    strokes.append(self.follow(curve, start, end, 1.7 if exploring else 1.0))
            if number > 0:
                for _ in range(round(curve.length / 500 + self.chance.about(0.5))):
                    strokes += self.correction(curve, gaps)
        return strokes

    def fuzzy(self, gap):
        return (gap[0] + self.chance.about(5), gap[1] + self.chance.about(5))

    def cut(self, curve, low, high, number, is_whole):
        """Where one stroke ends and the next begins, at equal effort: [(from, to)]."""
        marks, effort = self.effort_along(curve, low, high)
        count = max(2 if is_whole else 1, round(effort[-1] + self.chance.about(0.5)))
        if is_whole:
            phase = self.chance.unit()
            wobble = [0.0] + [self.chance.about(0.2) for _ in range(count - 1)] + [0.0]
            shares = [(i + phase + wobble[i]) / count for i in range(count + 1)]
            joints = [at_effort(marks, effort, share) for share in shares]
        else:
            # Every second pass joins its strokes where the others have their middles.
            phase = 0.5 if number % 2 and count > 1 else 0.0
            shares = [(i + phase + self.chance.about(0.2)) / count for i in range(count + 1)]
            inner = [at_effort(marks, effort, share) for share in shares if 0 < share < 1]
            joints = [low] + [j for j in inner if low + 12 < j < high - 12] + [high]
        return [(a, b) for a, b in zip(joints, joints[1:]) if b - a > 4]

    def effort_along(self, curve, low, high):
        """Places along the curve and the effort spent up to each; 1 is what one stroke can do."""
        marks, effort = [low], [0.0]
        while marks[-1] < high:
            s = marks[-1]
            tight = (curve.bend(s) / CURL) ** 2
            reach = TIGHT_REACH_PX + (CALM_REACH_PX - TIGHT_REACH_PX) / (1 + tight)
            marks.append(min(high, s + 6.0))
            effort.append(effort[-1] + (marks[-1] - s) / (reach * self.reach))
        return marks, effort

    def run_over(self, start, end, low, high, is_whole):
        """A little early, a little late; at a corner or gap only as far as the pen slips."""
        early = self.chance.between(6, 20) * self.reach
        late = self.chance.between(8, 26) * self.reach
        length = end - start
        early, late = min(early, 0.3 * length), min(late, 0.3 * length)
        at_low = not is_whole and start - low < 1
        at_high = not is_whole and high - end < 1
        slip = min(OPEN_END_FLY_PX, 0.12 * length)
        first = start - (self.chance.between(-0.4, 0.7) * slip if at_low else early)
        last = end + (self.chance.between(-0.3, 1.0) * slip if at_high else late)
        if not is_whole:
            first, last = max(first, low - slip), min(last, high + slip)
        return first, last

    def correction(self, curve, gaps):
        """A short stroke that restates a bit of the line just beside the others."""
        length = self.chance.between(35, 80) * self.reach
        if curve.length < 2.5 * length:
            return []
        start = self.chance.between(0, curve.length - length)
        if any(start < gap[1] + 5 and start + length > gap[0] - 5 for gap in gaps):
            return []
        return [self.follow(curve, start, start + length, 1.5)]

    def follow(self, curve, start, end, looseness=1.0):
        """One stroke along the curve from `start` to `end`: a list of points."""
        chance, length = self.chance, max(end - start, 1e-3)
        drift, tremor, speed = chance.wander(), chance.wander(), chance.wander()
        size = min(1.0, sqrt(length / 120))  # short strokes have no room to go astray
        bias = chance.about(1.0) * self.drift * looseness * size
        slope = chance.about(0.014) * looseness
        open_first = chance.about(self.flare) * looseness * size
        open_last = chance.about(self.flare) * looseness * size
        fade = min(32.0, 0.35 * length)
        points, s = [], start
        while True:
            aside = bias + slope * (s - start - length / 2)
            aside += drift(s / 85) * self.drift * 0.8 * looseness * size + tremor(s / 9) * self.tremor
            aside += open_first * max(0.0, 1 - (s - start) / fade) ** 2
            aside += open_last * max(0.0, 1 - (end - s) / fade) ** 2
            (x, y), (dx, dy) = curve.point(s), curve.direction(s)
            points.append((x + dy * aside, y - dx * aside))
            if s >= end:
                return points
            # A pen is sampled evenly in time and slows down in bends and at both ends.
            pace = 17.0 / (1 + 60 * curve.bend(s)) * (1 + 0.25 * speed(s / 40))
            pace *= min(1.0, 0.5 + min(s - start, end - s) / 40)
            s = min(end, s + max(3.5, pace))
            if end - s < 2:
                s = end


def free_runs(curve, gaps):
    """What is left of a curve between the gaps, as [(from, to)]."""
    if not gaps:
        return [(0.0, curve.length)]
    gaps = sorted(gaps)
    if curve.closed:
        nexts = gaps[1:] + [(gaps[0][0] + curve.length, 0)]
        runs = [(gap[1], following[0]) for gap, following in zip(gaps, nexts)]
    else:
        lows = [0.0] + [gap[1] for gap in gaps]
        highs = [gap[0] for gap in gaps] + [curve.length]
        runs = list(zip(lows, highs))
    return [(low, high) for low, high in runs if high - low > 8]


def at_effort(marks, effort, share):
    """The place where `share` of the effort is spent; goes round for closed curves."""
    turns = int(share // 1)
    wanted = (share - turns) * effort[-1]
    length = marks[-1] - marks[0]
    for i in range(1, len(marks)):
        if effort[i] >= wanted:
            span = effort[i] - effort[i - 1]
            t = (wanted - effort[i - 1]) / span if span > 0 else 0.0
            return marks[i - 1] + (marks[i] - marks[i - 1]) * t + turns * length
    return marks[-1] + turns * length


def scribble(chance, x, y, radius, turns):
    """Fills a spot by going round and round, as one does for an eye."""
    # One step turns by about 40 degrees: (cos, sin) as constants, so that no maths library differs.
    cosine, sine = 0.7660444431, 0.6427876097
    dx, dy = 1.0, 0.0
    points, count = [], int(turns * 9)
    for i in range(count):
        r = radius * (1 - 0.95 * i / count) * chance.between(0.86, 1.1)
        points.append((x + dx * r, y + dy * r))
        dx, dy = dx * cosine - dy * sine, dx * sine + dy * cosine
    return points


def straight(chance, a, b):
    """A quick short line: three or four points, hardly bent."""
    length = distance(a, b)
    bow = chance.about(0.05) * length
    nx, ny = -(b[1] - a[1]) / max(length, 1e-6), (b[0] - a[0]) / max(length, 1e-6)
    middle = ((a[0] + b[0]) / 2 + nx * bow, (a[1] + b[1]) / 2 + ny * bow)
    return [a, middle, b]


def zigzag(chance, x, y, radius_x, radius_y, steps):
    """One wild stroke to and fro across an ellipse, in any direction."""
    across = chance.between(-1, 1)
    along = sqrt(1 - across * across)
    rise = chance.between(0.07, 0.22)
    low = chance.between(-0.85, max(-0.8, 0.85 - rise * steps))
    points = []
    for i in range(steps):
        height = min(0.95, low + rise * i)
        half = sqrt(1 - height * height) * chance.between(0.45, 0.97) * (1 if i % 2 else -1)
        points.append((x + radius_x * (half * along - height * across),
                       y + radius_y * (half * across + height * along)))
    return points
