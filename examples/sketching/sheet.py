# SPDX-License-Identifier: Apache-2.0
"""The sheet a subject is drawn on: what a subject module may ask for."""

from sketching.chance import Chance
from sketching.curve import Curve, blend, parse, pieces_of, smooth_through
from sketching.hand import Hand, scribble, straight, zigzag

INK, GREY, BLUE = "#22242b", "#6a6f7d", "#a9bedb"
WARM, GREEN, TEAL = "#b4533c", "#5d8a54", "#159c95"
WHITE, CREAM, BUTTER, HONEY = "#fffdf8", "#fdeecb", "#fbe08a", "#f4b860"
CORAL, ROSE, CHERRY, BROWN, COCOA = "#f58a6c", "#f7b5b8", "#d8434e", "#a8693f", "#6b4230"
LEAF, MINT, SKY, SEA, LILAC = "#8cc56a", "#a9dcc3", "#8cc8ee", "#3f8fb5", "#b9a3e3"
NEAR_PX = 14.0  # a gap is asked for by a place; it lies on every curve that passes this near


class Mark:
    """One stroke as it will be written: points, colour, width in px, and whether it is a help line."""

    def __init__(self, points, colour=INK, width=2.4, is_help=False):
        self.points, self.colour, self.width, self.is_help = points, colour, width, is_help


class Group:
    """Marks that may become a layer; `copies` names a group that is drawn again, moved by `transform`."""

    def __init__(self, name, fill="", thickness=0.0, copies="", transform=""):
        self.name, self.fill, self.thickness = name, fill, thickness
        self.copies, self.transform = copies, transform
        self.marks = []


class Sheet:
    """A drawing: named groups of marks, in the order in which they are drawn."""

    def __init__(self, name, title):
        self.name, self.title = name, title
        self.groups = []
        self.place = lambda x, y: (x, y)  # moves designed points; set while a tilted part is drawn

    def group(self, name, fill="", thickness=0.0):
        """Starts a group: a candidate layer, with its colour and how round it is (0: as usual)."""
        self.groups.append(Group(name, fill, thickness))

    def copy(self, name, of, transform, fill="", thickness=0.0):
        """A group that shows another one once more: a far leg."""
        self.groups.append(Group(name, fill, thickness, of, transform))

    def outline(self, *shapes, closed=False, passes=3, gaps="", width=2.5, reach=1.0):
        """Contours that matter: several overlapping passes, some bits restated.

        shapes  texts or point lists
        gaps    "x,y,length ...": nothing is drawn for `length` px around the place x,y
        """
        for points in map(self.designed, shapes):
            chance = self.chance()
            hand = Hand(chance, reach=reach)
            for curve in pieces_of(points, closed):
                for stroke in hand.passes(curve, passes, self.gaps_on(curve, gaps)):
                    self.add(stroke, INK, width + chance.about(0.6))

    def small(self, *shapes, closed=True, width=2.5):
        """Contours too small for a swinging arm: two careful passes."""
        for points in map(self.designed, shapes):
            chance = self.chance()
            hand = Hand(chance, drift=1.0, tremor=0.25, flare=1.6, reach=1.8, skip=0)
            for curve in pieces_of(points, closed):
                for stroke in hand.passes(curve, 2):
                    self.add(stroke, INK, width + chance.about(0.4))

    def line(self, *shapes, closed=False, width=1.9, colour=INK, loose=1.0):
        """Inner detail: drawn once."""
        for points in map(self.designed, shapes):
            chance = self.chance()
            hand = Hand(chance, drift=1.1 * loose, flare=2.5 * loose, reach=1.6, skip=0)
            for curve in pieces_of(points, closed):
                for stroke in hand.passes(curve, 1):
                    self.add(stroke, colour, width + chance.about(0.25))

    def hatch(self, start, end, count, slant=0.06, colour=GREY, width=1.4):
        """Shading: `count` quick lines from the curve `start` to the curve `end`, short at its ends.

        slant   how far each line runs ahead, as a part of the curves' length
        """
        chance = self.chance()
        first = Curve(smooth_through([p[:2] for p in self.designed(start)]))
        last = Curve(smooth_through([p[:2] for p in self.designed(end)]))
        for i in range(count):
            t = (i + 0.5 + chance.about(0.45)) / count
            a, b = first.point(t * first.length), last.point((t + slant) * last.length)
            reach = (0.45 + 2.4 * t * (1 - t)) * chance.between(0.7, 1.15)
            a, b = blend(a, b, chance.between(-0.08, 0.08)), blend(a, b, reach)
            self.add(straight(chance, a, b), colour, width + chance.about(0.25))

    def eye(self, x, y, radius, turns=4, colour=INK, width=2.0):
        self.add(scribble(self.chance(), *self.place(x, y), radius, turns), colour, width)

    def scrawl(self, x, y, radius_x, radius_y, count, colour=INK, width=2.0):
        """Careless strokes to and fro, all over an ellipse."""
        chance = self.chance()
        for _ in range(count):
            steps = 3 + int(chance.unit() * 6)
            turns = zigzag(chance, x, y, radius_x, radius_y, steps)
            # Too fast for the hand to correct anything: the bare curve, thinly sampled.
            self.add(smooth_through(turns)[::18], colour, width + chance.about(0.4))

    def dab(self, *places, radius=16, turns=4, colour=ROSE, width=6.0):
        """Filled spots, as with a thick crayon: a cheek, a nose, a patch of fur. places: "x,y x,y" """
        for text in places:
            for x, y, _ in parse(text):
                self.eye(x, y, radius, turns, colour, width)

    def pupil(self, x, y, radius):
        """A dark filled spot with a glint."""
        self.eye(x, y, radius - 3, turns=radius / 3, colour=INK, width=6)
        self.line([(x - 0.4 * radius, y - 0.25 * radius, False), (x - 0.1 * radius, y - 0.5 * radius, False)],
                  width=4.5, colour=WHITE, loose=0)

    def guide(self, *shapes, closed=False):
        """Light construction lines, meant to be ignored."""
        self.line(*shapes, closed=closed, width=1.3, colour=BLUE, loose=1.5)

    def flecks(self, places, colour=INK):
        """Where the pen touched the paper by mistake: short strokes at "x,y x,y"."""
        chance = self.chance()
        for x, y, _ in self.designed(places):
            dx, dy = chance.about(16), chance.about(12)
            self.add(straight(chance, (x, y), (x + dx, y + dy)), colour, 1.6 + chance.about(0.3))

    def help(self, *shapes):
        """Help lines: close an open side without being part of the drawing."""
        for points in map(self.designed, shapes):
            hand = Hand(self.chance(), drift=0.8, flare=1.0)
            for curve in pieces_of(points):
                self.add(hand.follow(curve, 0, curve.length), TEAL, 2.4, is_help=True)

    def designed(self, shape):
        points = parse(shape) if isinstance(shape, str) else shape
        return [(*self.place(x, y), corner) for x, y, corner in points]

    def gaps_on(self, curve, text):
        gaps = []
        for word in text.split():
            x, y, length = map(float, word.split(","))
            s, away = curve.nearest(self.place(x, y))
            if away < NEAR_PX:
                gaps.append((s - length / 2, s + length / 2))
        return gaps

    def chance(self):
        group = self.groups[-1]
        return Chance(f"{self.name}/{group.name}/{len(group.marks)}")

    def add(self, points, colour, width, is_help=False):
        self.groups[-1].marks.append(Mark(points, colour, width, is_help))
