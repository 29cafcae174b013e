#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the recordings of tests/data/replay: the walk-throughs of the thesis' chapter 6, drawn part by part as somebody would who
has the editor before them, with slips that are taken back. Most are bent afterwards (bend_replays.py).

    python3 tests/tools/make_replays.py            write all
    python3 tests/tools/make_replays.py --check    exit with 1 if a file differs from what would be made
"""

import sys
from functools import partial
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "examples"))

import bend_replays  # noqa: E402
from recording import Recording  # noqa: E402
from sketching.curve import limb, ring  # noqa: E402
from sketching.sheet import CORAL, MINT, SEA, Sheet  # noqa: E402
from subjects import birds, figures, insects, mammals, reptiles, sea  # noqa: E402

FOLDER = TOP / "tests" / "data" / "replay"


def parts_of(subject, name):
    """The groups of an example drawing by name. Only what is drawn in ink or closes a part: the editor has a pen of one colour."""
    sheet = Sheet(name, "")
    subject(sheet)
    return {group.name: group for group in sheet.groups}


def part(recording, group, layers=1, **event):
    """Draws a part and simplifies it; then it wears its colour."""
    recording.comment(group.name)
    recording.draw(group.marks, **event)
    recording.simplify(group.fill, layers)


def close_root(recording, *limbs):
    """Help lines across the open roots of limbs, given as the points of limb()."""
    recording.pick("l")
    for points in limbs:
        recording.stroke([points[0][:2], points[-1][:2]], button="secondary")


def slip(recording, points):
    """A line that goes astray and is taken back."""
    recording.pick("b")
    recording.stroke(points)
    recording.undo()


def mouse():
    """Figure 6.7: five layers, ears closed by help lines; the tail is drawn behind all by the other button."""
    recording = Recording(mouse.__doc__)
    parts = parts_of(mammals.mouse, "mouse")
    part(recording, parts["body"])
    slip(recording, [(120, 120), (320, 300), (420, 200)])
    part(recording, parts["paws"], layers=2)
    recording.pinch(1.6, (500, 200))
    part(recording, parts["near-ear"])
    part(recording, parts["far-ear"], button="secondary")
    recording.pinch(1 / 1.6, (500, 200))
    close_root(recording, [(x - 36, y - 20) for x, y, _ in limb("750,586 824,632 900,636", [40, 30, 26])])
    part(recording, parts["tail"], button="secondary")
    return recording


def alligator():
    """Figure 6.8: wide open jaws; a line too many is rubbed out with the pen's other end. The near legs are drawn, the far ones too."""
    recording = Recording(alligator.__doc__)
    parts = parts_of(reptiles.alligator, "alligator")
    recording.comment("body")
    recording.draw(parts["body"].marks[:60])
    recording.stroke([(640, 130), (760, 60), (900, 140)])
    recording.stroke([(640, 130), (760, 60), (900, 140)], button="eraser")
    recording.draw(parts["body"].marks[60:])
    recording.simplify(parts["body"].fill)
    part(recording, parts["near-front-leg"])
    part(recording, parts["near-hind-leg"])
    recording.comment("a step back and forth again")
    for _ in range(4):
        recording.undo()
    for _ in range(4):
        recording.redo()
    part(recording, parts["far-legs"], layers=2, button="secondary")
    return recording


def dove():
    """Figure 6.9: feathers and crossing outlines; whole lines are rubbed out with Alt."""
    recording = Recording(dove.__doc__)
    parts = parts_of(birds.dove, "dove")
    part(recording, parts["body"])
    part(recording, parts["far-wing"], button="secondary")
    recording.comment("near-wing")
    recording.draw(parts["near-wing"].marks)
    recording.stroke([(60, 420), (160, 480), (200, 420)])
    recording.pick("e")
    recording.stroke([(110, 400), (110, 500)], alt=True)
    recording.simplify(parts["near-wing"].fill)
    part(recording, parts["twig"], layers=2)
    return recording


def seahorse():
    """Figure 6.10: one layer, and a fin behind it. Simplify is taken back, a line added, and done again."""
    recording = Recording(seahorse.__doc__)
    parts = parts_of(sea.seahorse, "seahorse")
    body = parts["body"]
    recording.comment("body")
    recording.draw(body.marks[:-3])
    recording.key("Enter")
    recording.undo()
    recording.draw(body.marks[-3:])
    recording.simplify(body.fill)
    recording.pan(-60, 30)
    recording.pick("l")  # the fin is open towards the body
    recording.stroke([(642, 316), (650, 350), (662, 400), (668, 438)], button="secondary")
    part(recording, parts["dorsal-fin"], button="secondary")
    recording.pan(60, -30)
    return recording


def crab():
    """Figure 6.11: the body first, then claws and legs behind it."""
    recording = Recording(crab.__doc__)
    parts = parts_of(sea.crab, "crab")
    part(recording, parts["body"])
    for name in ("right-claw", "left-claw"):
        part(recording, parts[name], button="secondary")
    left = [limb(spine, [46, 36]) for spine in ("330,440 240,428", "344,490 262,510", "400,524 340,580")]
    right = [[(1000 - x, y) for x, y, _ in points] for points in left]
    for name, roots in (("right-legs", right), ("left-legs", left)):
        close_root(recording, *roots)
        part(recording, parts[name], layers=3, button="secondary")
    return recording


def butterfly():
    """Figure 6.6: wings that are open towards the body, closed by help lines."""
    recording = Recording(butterfly.__doc__)
    parts = parts_of(insects.butterfly, "butterfly")
    part(recording, parts["left-forewing"])
    part(recording, parts["left-hindwing"])
    recording.pinch(0.8, (500, 400))
    part(recording, parts["right-forewing"])
    part(recording, parts["right-hindwing"])
    recording.pinch(1 / 0.8, (500, 400))
    part(recording, parts["body"])
    return recording


def turned(points, centre, angle_degrees):
    """About a place; clockwise as seen, for y points down. Only a few angles, as numbers that no library rounds otherwise."""
    cosine, sine = {-40: (0.7660444431, -0.6427876097), -30: (0.8660254038, -0.5)}[angle_degrees]
    return [(centre[0] + cosine * (x - centre[0]) - sine * (y - centre[1]),
             centre[1] + sine * (x - centre[0]) + cosine * (y - centre[1])) for x, y in points]


def moved(points, by):
    return [(x + by[0], y + by[1]) for x, y in points]


def box_of(points):
    xs, ys = zip(*points)
    return min(xs), min(ys), max(xs), max(ys)


def centre_of(points):
    left, top, right, bottom = box_of(points)
    return (left + right) / 2, (top + bottom) / 2


COPY_OFFSET = (20, 20)   # where a copy lies that Ctrl+D has made
TURN_HANDLE_PX = 28      # above the frame of what is selected


def copy_turned(recording, rim, grip, angle_degrees, root, target):
    """A copy of a part, turned by its handle, moved so that its root comes to a target, and sent to the back. Its points now."""
    recording.pick("v")
    recording.click(grip)
    recording.key("d", ctrl=True)
    recording.layers += 1
    rim, (root, grip) = moved(rim, COPY_OFFSET), moved([root, grip], COPY_OFFSET)
    centre, (left, top, right, _) = centre_of(rim), box_of(rim)
    handle = ((left + right) / 2, top - TURN_HANDLE_PX)
    recording.drag(handle, turned([handle], centre, angle_degrees)[0])
    rim, (root, grip) = turned(rim, centre, angle_degrees), turned([root, grip], centre, angle_degrees)
    way = (target[0] - root[0], target[1] - root[1])
    recording.drag(grip, (grip[0] + way[0], grip[1] + way[1]))
    recording.key("End")
    return moved(rim, way), (grip[0] + way[0], grip[1] + way[1])


def octopus():
    """Figure 6.19: only a head and two tentacles are drawn. The others are copies, turned, moved, flipped and sent to the back."""
    recording = Recording(octopus.__doc__)
    parts = parts_of(sea.octopus, "octopus")
    spines = dict(sea.TENTACLES)
    part(recording, parts["head"])
    part(recording, parts["tentacle-left-1"], button="secondary")
    part(recording, parts["tentacle-left-3"], button="secondary")

    def rim_of(name):
        return [p[:2] for p in limb(spines[name], [80, 66, 52, 40, 29, 21, 13])]

    def on_spine(name, index):
        return tuple(float(number) for number in spines[name].split()[index].split(","))

    recording.comment("two copies on this side")
    arms = [(rim_of("left-1"), on_spine("left-1", 2)), (rim_of("left-3"), on_spine("left-3", 2))]
    arms.append(copy_turned(recording, *arms[0], -40, on_spine("left-1", 0), on_spine("left-2", 0)))
    arms.append(copy_turned(recording, *arms[1], -30, on_spine("left-3", 0), on_spine("left-4", 0)))
    recording.comment("all four on the other side")
    for index, (_, grip) in enumerate(arms):
        recording.click(grip, **({"shift": True} if index else {}))
    recording.key("d", ctrl=True)
    recording.key("h", shift=True)
    recording.key("End")
    centre = centre_of([point for rim, _ in arms for point in rim])
    x, y = arms[0][1]
    grip = (2 * centre[0] - x + COPY_OFFSET[0], y + COPY_OFFSET[1])
    recording.drag(grip, (1000 - x, y))
    return recording


def half_torus():
    """Figure 6.27: a half ring beside a body, as a handle; its open ends are closed by help lines."""
    sheet = Sheet("half_torus", "")
    sheet.group("body", SEA)
    sheet.outline(ring(400, 420, 210, 230), closed=True, gaps="400,190,16")
    sheet.group("handle", MINT)
    sheet.outline("560,284 640,250 730,274 786,350 792,440 750,520 676,566 580,572", passes=2)
    sheet.outline("566,350 630,328 690,350 720,400 718,450 690,492 640,512 572,506", passes=2)
    sheet.help("562,286 566,348", "572,508 580,570")
    recording = Recording(half_torus.__doc__)
    for group in sheet.groups:
        part(recording, group)
    return recording


def torus():
    """Figure 6.28: a torus of two halves. The second one is a copy that is flipped and moved until both touch."""
    sheet = Sheet("torus", "")
    sheet.group("left-half", CORAL)
    sheet.outline("500,180 400,190 310,250 262,340 262,440 310,540 400,604 500,616", passes=2)
    sheet.outline("500,290 430,300 376,350 360,400 376,450 430,500 500,508", passes=2)
    sheet.help("500,182 500,288", "500,510 500,614")
    recording = Recording(torus.__doc__)
    part(recording, sheet.groups[0])
    recording.pick("v")
    grip = (310, 400)
    recording.click(grip)
    recording.key("d", ctrl=True)
    recording.key("h", shift=True)
    there = (258 + 500 - grip[0] + COPY_OFFSET[0], grip[1] + COPY_OFFSET[1])
    recording.drag(there, (1000 - grip[0], grip[1]))
    return recording


def one_part(name):
    """A figure in one outline, to be bent."""
    recording = Recording(f"{name}: one part")
    part(recording, parts_of(getattr(figures, name), name)[name.split("_")[-1]])
    return recording


RECORDINGS = {"mouse": mouse, "alligator": alligator, "dove": dove, "seahorse": seahorse, "crab": crab,
              "butterfly": butterfly, "octopus": octopus, "half_torus": half_torus, "torus": torus}
RECORDINGS |= {name: partial(one_part, name) for name in ("giraffe", "monster", "letter_s", "person")}


def made(name):
    recording = RECORDINGS[name]()
    recording.show()
    bend = getattr(bend_replays, name, None)
    if bend:
        recording.go_on()
        recording.comment(bend.__doc__)
        bend(recording)
    return recording.text()


def main():
    differing = 0
    for name in RECORDINGS:
        path, text = FOLDER / f"{name}.jsonl", made(name)
        if sys.argv[1:] == ["--check"]:
            if not path.exists() or path.read_text(encoding="utf-8") != text:
                print(f"{path}: differs; run python3 tests/tools/make_replays.py", file=sys.stderr)
                differing += 1
        else:
            path.write_text(text, encoding="utf-8")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
