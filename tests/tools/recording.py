# SPDX-License-Identifier: Apache-2.0
"""Somebody at work in the editor, written down as events (docs/FORMATS.md): what they draw is given on the canvas, and they
know how the paper lies under the window."""

import json
from math import sqrt

from sketching.sheet import INK

SPACING_PX = 7        # between the positions that a pen reports, on the screen
BEND_SPACING_PX = 12  # that a mouse reports while it bends


def rounded(value):
    value = round(value, 1)
    return int(value) if value == int(value) else value


def even(points, spacing):
    """The same line with points that lie evenly."""
    result, left = [points[0]], spacing
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        length = sqrt((bx - ax) ** 2 + (by - ay) ** 2)
        at = left
        while at < length:
            result.append((ax + (bx - ax) * at / length, ay + (by - ay) * at / length))
            at += spacing
        left = at - length
    return result + [points[-1]]


class Recording:
    """Lines of events. The window is 1000 x 800 and shows what an example drawing covers."""

    def __init__(self, title):
        self.lines = []
        self.scale, self.x, self.y = 1.0, 0.0, -100.0  # screen = scale * canvas + (x, y)
        self.layers = 0  # that were made so far; their ids count from 1
        self.bends = 0  # and pins put, since the last that were taken back
        self.tool, self.colour, self.width = "b", INK, 2.4
        self.put(comment=title)
        self.put(resize=[1000, 800])
        self.action("brush_size", str(self.width))
        self.pan(0, 100)

    def put(self, **event):
        self.lines.append(json.dumps(event, separators=(",", ":")))

    def comment(self, text):
        self.put(comment=text)

    def screen(self, point):
        return [rounded(self.scale * point[0] + self.x), rounded(self.scale * point[1] + self.y)]

    def pan(self, dx, dy):
        """The paper moves by this much, px of the screen."""
        self.put(wheel=[-dx, -dy], at=[500, 400])
        self.x, self.y = self.x + dx, self.y + dy

    def pinch(self, scale, around):
        """Larger by a factor; a place of the canvas stays where it is."""
        x, y = self.screen(around)
        self.put(pinch=scale, at=[x, y])
        self.scale *= scale
        self.x, self.y = x + scale * (self.x - x), y + scale * (self.y - y)

    def key(self, key, **modifiers):
        self.put(key=key, **modifiers)

    def pick(self, tool):
        if tool != self.tool:
            self.key(tool)
        self.tool = tool

    def hold(self, mark):
        """The pen for a line. Nobody changes it for a trifle."""
        if mark.colour != self.colour and not mark.is_help:
            self.action("ink_colour", mark.colour)
            self.colour = mark.colour
        if abs(mark.width - self.width) > 1:
            self.width = rounded(mark.width)
            self.action("brush_size", str(self.width))

    def undo(self):
        self.key("z", ctrl=True)

    def redo(self):
        self.key("y", ctrl=True)

    def simplify(self, fill="", layers=1):
        """What is rough becomes so many layers of a colour."""
        self.key("Enter")
        if fill:
            self.action("select", " ".join(str(self.layers + i + 1) for i in range(layers)))
            self.action("fill", fill)
        self.layers += layers

    def action(self, name, argument=""):
        self.put(action=name, **({"argument": argument} if argument else {}))

    def stroke(self, points, **event):
        """One line of the pen, with the tool that was picked."""
        at_hand = [self.screen(point) for point in even(points, SPACING_PX / self.scale)]
        self.put(stroke=at_hand, **event)

    def drag(self, start, end, **event):
        """With the mouse, from a place of the canvas to another."""
        (ax, ay), (bx, by) = self.screen(start), self.screen(end)
        steps = 8
        way = [[rounded(ax + (bx - ax) * i / steps), rounded(ay + (by - ay) * i / steps)] for i in range(steps + 1)]
        self.put(stroke=way, kind="mouse", **event)

    def click(self, place, **event):
        self.put(click=self.screen(place), **event)

    def bend(self, *way, **event):
        """Drags a line, a part or a pin with the Deform tool, slowly, from the first of these places through the others to the last."""
        self.pick("d")
        self.bends += 1
        self.put(stroke=[self.screen(point) for point in even(way, BEND_SPACING_PX / self.scale)], kind="mouse", **event)

    def pin(self, *places):
        """Puts pins on lines."""
        self.pick("d")
        for place in places:
            self.bends += 1
            self.click(place)

    def reach(self, share="auto"):
        """How far a drag reaches, as a share of the part."""
        self.action("bend_reach", str(share))

    def draw(self, marks, **event):
        """All lines of a part, help lines with their own tool."""
        for mark in marks:
            self.pick("l" if mark.is_help else "b")
            self.hold(mark)
            self.stroke(mark.points, **event)

    def show(self):
        """Small pictures of the drawing and of the model."""
        self.comment("done")
        self.key("Escape")
        self.put(resize=[256, 208])
        self.action("zoom_fit")
        self.put(picture="drawing.png")
        self.key("2")
        self.put(picture="model.png")

    def go_on(self):
        """Back to the drawing, which lies in the window as it did at first."""
        self.put(resize=[1000, 800])
        self.action("show_place", "0,0,1000,800")
        self.action("zoom_actual")
        self.scale, self.x, self.y = 1.0, 0.0, 0.0

    def take_back(self):
        """All that was bent."""
        for _ in range(self.bends):
            self.undo()
        self.bends = 0

    def result(self, name):
        """A small picture of what was bent."""
        self.put(resize=[256, 208])
        self.action("zoom_fit")
        self.put(picture=f"{name}.png")
        self.go_on()

    def text(self):
        return "\n".join(self.lines) + "\n"
