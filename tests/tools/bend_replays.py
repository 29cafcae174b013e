# SPDX-License-Identifier: Apache-2.0
"""Figures 6.12 to 6.25 of the thesis: drawings bent with the Deform tool. Each bending ends with a small picture."""

from sketching.curve import limb
from sketching.sheet import SKY, Mark


def giraffe(recording):
    """Figures 6.12, 6.13 and 6.16: by one place, down to drink, and with more pins."""
    chin = (172, 180)
    recording.comment("6.12: by one place, the whole drawing")
    recording.reach("1")
    recording.bend(chin, (172, 290), (150, 360))
    recording.result("one_place_whole")
    recording.take_back()
    recording.comment("6.12: by one place, as far as a drag reaches by itself")
    recording.reach()
    recording.bend(chin, (172, 240), (150, 290))
    recording.result("one_place")
    recording.take_back()
    recording.comment("6.13: down to drink, in one drag that reaches as far as its neck does")
    recording.reach("0.7")
    recording.bend(chin, (90, 330), (60, 480), (70, 620))
    recording.result("drinks")
    recording.take_back()
    recording.reach()
    recording.comment("6.16: its head up, a leg lifted, its tail raised")
    recording.pin((748, 740), (628, 740), (360, 740), (640, 424))
    recording.bend((890, 640), (940, 560), (950, 460), (930, 400))
    recording.bend((476, 740), (450, 720), (430, 700))
    recording.bend(chin, (150, 120), (170, 60))
    recording.result("steps")


def monster(recording):
    """Figures 6.12, 6.14 and 6.15: by one place, its tail and hands a little, and with pins."""
    recording.comment("6.12: by one place, as far as a drag reaches by itself")
    recording.bend((832, 94), (900, 90), (950, 140))
    recording.result("one_place")
    recording.take_back()
    recording.comment("6.14: tail and hands a little")
    recording.bend((884, 470), (920, 450), (950, 450))
    recording.bend((78, 584), (70, 540), (80, 500))
    recording.bend((760, 118), (730, 100), (710, 110))
    recording.result("tail_and_hands")
    recording.take_back()
    recording.comment("6.15: an arm up and an arm down, with pins at its feet and its head")
    recording.pin((392, 742), (608, 742), (500, 140))
    recording.bend((180, 640), (120, 520), (100, 400), (120, 250))
    recording.bend((832, 94), (900, 200), (930, 330), (900, 440))
    recording.result("arms")


def letter_s(recording):
    """Figures 6.17 and 6.18: bent, and widened."""
    recording.comment("6.17: bent")
    recording.pin((273, 592))
    recording.bend((698, 208), (770, 240), (830, 320), (850, 420))
    recording.result("bent")
    recording.take_back()
    recording.comment("6.18: widened")
    recording.pin((273, 592))
    recording.bend((698, 208), (790, 220), (900, 220))
    recording.bend((273, 592), (200, 620), (110, 620))
    recording.result("wide")


def octopus(recording):
    """Figure 6.19: copies of tentacles, bent so that they are no copies any more; each is held where it joins the head."""
    recording.bend((816, 190), (880, 130), (950, 150))
    recording.bend((794, 738), (860, 730), (920, 690))
    recording.result("bent")


def mouse(recording):
    """Figure 6.20: its tail and an ear."""
    recording.bend((894, 482), (960, 430), (940, 370), (880, 330))
    recording.bend((282, 194), (240, 160), (200, 160))
    recording.result("bent")


def alligator(recording):
    """Figure 6.21: its tail, its lower jaw and a leg."""
    recording.pin((402, 334), (760, 356))
    recording.bend((955, 324), (900, 270), (850, 260))
    recording.bend((96, 597), (80, 540), (90, 470))
    recording.bend((430, 650), (400, 640), (370, 600))
    recording.result("bent")


def dove(recording):
    """Figure 6.22: its wings, held where they join the body."""
    recording.pin((664, 370), (570, 487))
    recording.bend((328, 37), (220, 100), (130, 220), (90, 350))
    recording.bend((808, 60), (880, 90), (930, 150))
    recording.result("bent")


def seahorse(recording):
    """Figure 6.23: its tail unrolled, and its head bowed."""
    recording.pin((662, 400), (420, 430))
    recording.bend((350, 560), (300, 600), (250, 680), (260, 760))
    recording.bend((302, 206), (290, 250), (300, 300))
    recording.result("bent")


def crab(recording):
    """Figure 6.24: its claws spread, its legs drawn in."""
    recording.bend((160, 80), (90, 110), (50, 180))
    recording.bend((848, 104), (900, 130), (950, 200))
    recording.bend((96, 524), (110, 600), (150, 660))
    recording.bend((904, 524), (890, 600), (850, 660))
    recording.result("bent")


def person(recording):
    """Figure 6.25: fattened, given two more legs, and its limbs moved."""
    recording.comment("fattened")
    recording.reach("0.22")
    for side in (1, -1):
        for x, y, far in ((140, 420, 50), (150, 500, 60), (130, 570, 40)):
            recording.bend((500 + side * x, y), (500 + side * (x + far / 2), y), (500 + side * (x + far), y))
    recording.result("fat")
    recording.reach()
    recording.comment("a leg is drawn, and a copy of it bent")
    leg = [point[:2] for point in limb("590,560 680,600 740,680", [90, 80, 64])]
    middle = (680, 600)
    recording.draw([Mark(leg + leg[:1])])
    recording.simplify(SKY)
    recording.key("End")
    recording.pick("v")
    recording.click((740, 660))
    recording.key("d", ctrl=True)
    recording.key("h", shift=True)
    recording.key("End")
    xs = [x for x, _ in leg]
    copy = (min(xs) + max(xs) + 20 - middle[0], middle[1] + 20)  # the copy lies (20, 20) beside, and is flipped
    recording.drag(copy, (1000 - middle[0], middle[1]))
    recording.bend((250, 700), (190, 690), (150, 640))
    recording.result("legs")
    recording.comment("limbs moved")
    recording.pin((500, 72), (420, 742), (580, 742))
    recording.bend((812, 284), (830, 200), (780, 100))
    recording.bend((188, 284), (150, 380), (200, 480))
    recording.result("limbs")
