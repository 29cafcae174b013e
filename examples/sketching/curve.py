# SPDX-License-Identifier: Apache-2.0
"""Designed curves: smooth curves through hand-chosen points, measured by length.

A curve is written as text, "x,y x,y x,y! x,y": it passes smoothly through its points and turns
sharply at those marked "!".
"""

from math import sqrt

STEP_PX = 2.0  # spacing of the dense polyline; well below the smallest detail drawn


def parse(text):
    """Text to [(x, y, is_corner)]."""
    points = []
    for word in text.split():
        x, y = word.rstrip("!").split(",")
        points.append((float(x), float(y), word.endswith("!")))
    return points


def distance(a, b):
    return sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2)


def blend(a, b, t):
    return (a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t)


def unit(vector):
    length = sqrt(vector[0] ** 2 + vector[1] ** 2)
    return (vector[0] / length, vector[1] / length) if length > 0 else (1.0, 0.0)


def catmull_rom(p0, p1, p2, p3, t):
    """Centripetal Catmull-Rom between p1 and p2 (pyramid of Barry and Goldman 1988).

    Centripetal knots because they alone never loop between unevenly spaced points.
    """
    t0 = 0.0
    t1 = t0 + sqrt(max(distance(p0, p1), 1e-6))
    t2 = t1 + sqrt(max(distance(p1, p2), 1e-6))
    t3 = t2 + sqrt(max(distance(p2, p3), 1e-6))
    x = t1 + (t2 - t1) * t
    a = blend(p0, p1, (x - t0) / (t1 - t0))
    b = blend(p1, p2, (x - t1) / (t2 - t1))
    c = blend(p2, p3, (x - t2) / (t3 - t2))
    d = blend(a, b, (x - t0) / (t2 - t0))
    e = blend(b, c, (x - t1) / (t3 - t1))
    return blend(d, e, (x - t1) / (t2 - t1))


def smooth_through(points, closed=False):
    """Dense polyline through the points."""
    count = len(points)
    if count == 2:
        points, count = [points[0], blend(points[0], points[1], 0.5), points[1]], 3
    if closed:
        padded = [points[-1]] + points + [points[0], points[1]]
    else:
        # Mirrored ends: the curve leaves its first point straight instead of hooking.
        before = blend(points[1], points[0], 2.0)
        after = blend(points[-2], points[-1], 2.0)
        padded = [before] + points + [after]
    dense = [padded[1]]
    for i in range(count if closed else count - 1):
        p0, p1, p2, p3 = padded[i : i + 4]
        steps = max(2, int(distance(p1, p2) / STEP_PX) + 1)
        dense += [catmull_rom(p0, p1, p2, p3, k / steps) for k in range(1, steps + 1)]
    return dense


class Curve:
    """A smooth piece without corners, read by arc length; beyond its ends it goes on straight."""

    def __init__(self, dense, closed=False):
        self.closed = closed
        self.dense = dense
        self.at = [0.0]
        for a, b in zip(dense, dense[1:]):
            self.at.append(self.at[-1] + distance(a, b))
        self.length = self.at[-1]

    def point(self, s):
        if self.closed:
            s %= self.length
        elif s < 0:
            d = self.direction(0)
            return (self.dense[0][0] + d[0] * s, self.dense[0][1] + d[1] * s)
        elif s > self.length:
            d, over = self.direction(self.length), s - self.length
            return (self.dense[-1][0] + d[0] * over, self.dense[-1][1] + d[1] * over)
        low, high = 0, len(self.at) - 1
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if self.at[middle] <= s else (low, middle)
        span = self.at[high] - self.at[low]
        t = (s - self.at[low]) / span if span > 0 else 0.0
        return blend(self.dense[low], self.dense[high], t)

    def direction(self, s):
        reach = 3.0
        low, high = s - reach, s + reach
        if not self.closed:
            low, high = max(0.0, min(low, self.length - reach)), min(self.length, max(high, reach))
        a, b = self.point(low), self.point(high)
        return unit((b[0] - a[0], b[1] - a[1]))

    def bend(self, s):
        """Curvature in 1/px, without sign, averaged over what a wrist feels (about 30 px)."""
        reach = 15.0
        a, b = self.direction(s - reach), self.direction(s + reach)
        return distance(a, b) / (2 * reach)

    def nearest(self, target):
        best = min(range(len(self.dense)), key=lambda i: distance(self.dense[i], target))
        return self.at[best], distance(self.dense[best], target)


def pieces_of(points, closed=False):
    """Cuts [(x, y, is_corner)] at its corners into curves."""
    flat = [(x, y) for x, y, _ in points]
    corners = [i for i, p in enumerate(points) if p[2]]
    if closed and not corners:
        return [Curve(smooth_through(flat, closed=True), closed=True)]
    if closed:
        turn = corners[0]
        flat = flat[turn:] + flat[:turn] + [flat[turn]]
        cuts = [c - turn for c in corners] + [len(flat) - 1]
    else:
        cuts = sorted({0, *corners, len(flat) - 1})
    return [Curve(smooth_through(flat[a : b + 1])) for a, b in zip(cuts, cuts[1:])]


def limb(spine, widths, tip_round=True):
    """Points of a tapering band around a spine: one side, the tip, back along the other side.

    Its two root points are corners, so that the root is a straight cut if the band is closed.

    spine   text of a curve, from the root to the tip
    widths  full widths in px, spread evenly from root to tip
    """
    curve = Curve(smooth_through([p[:2] for p in parse(spine)]))
    count = max(6, int(curve.length / 45))
    left, right = [], []
    for i in range(count + 1):
        t = i / count
        place = t * (len(widths) - 1)
        k = min(int(place), len(widths) - 2)
        half = (widths[k] + (widths[k + 1] - widths[k]) * (place - k)) / 2
        (x, y), (dx, dy) = curve.point(t * curve.length), curve.direction(t * curve.length)
        left.append((x + dy * half, y - dx * half, False))
        right.append((x - dy * half, y + dx * half, False))
    x, y = curve.point(curve.length + widths[-1] * 0.5)
    left[0], right[0] = (*left[0][:2], True), (*right[0][:2], True)
    return left + [(x, y, not tip_round)] + right[::-1]


def ring(x, y, radius_x, radius_y=None):
    """Eight points of an ellipse."""
    ry = radius_x if radius_y is None else radius_y
    d = 0.7071
    places = [(1, 0), (d, d), (0, 1), (-d, d), (-1, 0), (-d, -d), (0, -1), (d, -d)]
    return [(x + radius_x * a, y + ry * b, False) for a, b in places]
