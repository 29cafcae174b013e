# SPDX-License-Identifier: Apache-2.0
"""Figures 6.12 to 6.25 of the thesis: drawings bent with the Deform tool. Each bending ends with a small picture."""

from sketching.curve import limb


def giraffe(recording):
    """Figures 6.12, 6.13 and 6.16: by one place, down to drink, and once more with pins."""
    chin = (172, 180)
    recording.comment("6.12: by one place, the whole drawing")
    recording.reach("1")
    recording.bend(chin, (172, 290), (150, 360))
    recording.result("one_place_whole")
    recording.comment("6.12: by one place, as far as a drag reaches by itself")
    recording.reach()
    recording.bend(chin, (172, 290), (150, 360))
    recording.result("one_place")
    recording.comment("6.13: down to drink, held by two hooves")
    recording.pin((360, 740), (748, 740))
    recording.bend(chin, (110, 330), (90, 480), (110, 620), (150, 700))
    recording.result("drinks")
    recording.comment("6.16: a step, with pins")
    recording.pin((300, 100), (628, 740))
    recording.bend((476, 740), (420, 720), (400, 690))
    recording.bend((888, 640), (930, 560), (940, 480))
    recording.result("steps")


def monster(recording):
    """Figures 6.12, 6.14 and 6.15: by one place, its tail and hands a little, and with pins."""
    recording.comment("6.12: by one place, the whole drawing")
    recording.reach("1")
    recording.bend((846, 100), (900, 60), (960, 60))
    recording.result("one_place_whole")
    recording.comment("6.12: by one place, as far as a drag reaches by itself")
    recording.reach()
    recording.bend((846, 100), (900, 60), (960, 60))
    recording.result("one_place")
    recording.comment("6.14: tail and hands a little")
    recording.bend((884, 470), (920, 460), (950, 480))
    recording.bend((92, 572), (90, 520), (110, 480))
    recording.bend((770, 122), (740, 90), (720, 84))
    recording.result("tail_and_hands")
    recording.comment("6.15: with pins at its feet, its head and its other arm")
    recording.pin((392, 742), (608, 742), (500, 140))
    recording.bend((196, 655), (150, 500), (120, 380), (130, 280))
    recording.bend((846, 100), (900, 200), (930, 330), (900, 420))
    recording.result("arms")


def letter_s(recording):
    """Figures 6.17 and 6.18: bent, and widened."""
    recording.comment("6.17: bent")
    recording.pin((310, 640))
    recording.bend((700, 164), (790, 200), (850, 290), (870, 400))
    recording.result("bent")
    recording.comment("6.18: widened")
    recording.undo()
    recording.bend((310, 640), (230, 640), (150, 620))
    recording.bend((700, 164), (790, 180), (860, 200))
    recording.result("wide")


def mouse(recording):
    """Figure 6.20."""
    recording.comment("6.20")
    recording.bend((900, 636), (900, 560), (850, 480), (780, 450))
    recording.bend((318, 214), (280, 190), (250, 150))
    recording.result("bent")


def alligator(recording):
    """Figure 6.21."""
    recording.comment("6.21")
    recording.pin((390, 330), (560, 556))
    recording.bend((952, 318), (900, 230), (820, 190))
    recording.bend((66, 320), (60, 380), (90, 430))
    recording.result("bent")


def dove(recording):
    """Figure 6.22."""
    recording.comment("6.22")
    recording.result("bent")


def seahorse(recording):
    """Figure 6.23."""
    recording.comment("6.23")
    recording.pin((440, 108), (660, 400))
    recording.bend((306, 612), (260, 600), (210, 640))
    recording.result("bent")


def crab(recording):
    """Figure 6.24."""
    recording.comment("6.24")
    recording.result("bent")


def person(recording):
    """Figure 6.25."""
    recording.comment("6.25: fattened")
    recording.bend((652, 450), (690, 450), (740, 460))
    recording.bend((348, 450), (310, 450), (260, 460))
    recording.result("fat")
