# SPDX-License-Identifier: Apache-2.0
"""Butterfly."""

from sketching.curve import ring
from sketching.sheet import BROWN, BUTTER, GREY, HONEY, WARM


def tilted(flip):
    """Places points given around the butterfly's waist: mirrored if asked, then turned by 12 degrees."""
    cosine, sine = 0.9781476, 0.2079117

    def place(x, y):
        x *= flip
        return (490 + x * cosine - y * sine, 420 + x * sine + y * cosine)

    return place


def butterfly(sheet):
    """A butterfly whose wings are open towards the body; help lines close them."""
    for name, flip in (("left", -1), ("right", 1)):
        sheet.place = tilted(flip)
        sheet.group(f"{name}-forewing", HONEY)
        sheet.outline("23,-88 66,-144 122,-222 204,-286 288,-316 340,-296 344,-244 318,-176 276,-110 "
                      "236,-56 190,-26! 130,-20 76,-22 30,-32", passes=3, gaps="250,-304,30")
        sheet.help("23,-88 26,-62 30,-32")
        sheet.line("40,-80 110,-130 190,-200 270,-262", "40,-64 120,-96 216,-130 290,-150",
                   "40,-48 110,-58 190,-60 236,-66", width=1.6)
        sheet.line("150,-168 190,-160 212,-130 200,-96")
        sheet.line(ring(262, -214, 24, 28), ring(232, -150, 15, 18), closed=True, colour=WARM)
        sheet.eye(288, -262, 9, turns=4, colour=WARM)
        sheet.line("236,-280 288,-292 318,-280 320,-240 296,-172 256,-108 216,-62", width=1.5)
        sheet.hatch("250,-306 330,-300 342,-244 316,-176 240,-60",
                    "240,-282 312,-284 320,-240 294,-174 222,-66", 26, slant=0.015)
        sheet.group(f"{name}-hindwing", BUTTER)
        sheet.outline("30,-18 84,-9 140,-8 196,-16 246,10 266,60 262,104! 240,124 226,152! 212,156 206,176 "
                      "214,212 238,244 214,252 182,228 164,184! 142,190 128,186! 96,186 64,150 46,106 28,58",
                      passes=3, gaps="90,186,26")
        sheet.help("30,-18 26,20 28,58")
        sheet.line("40,-2 90,20 160,40 236,50", "40,20 80,58 140,104 196,146", "38,44 58,80 92,150",
                   width=1.6)
        sheet.line("124,20 160,60 150,110 108,124")
        sheet.line(ring(198, 84, 22, 24), closed=True, colour=WARM)
        sheet.eye(198, 84, 8, turns=4, colour=WARM)
        sheet.line("214,12 240,52 236,96 206,136 160,164 112,164", width=1.5)
        sheet.hatch("230,0 264,60 258,108 210,160", "212,12 240,56 234,98 196,142", 13, slant=0.02)
    sheet.place = tilted(1)
    sheet.group("body", BROWN)
    sheet.outline("0,-112 13,-100 16,-70 12,-38 15,-6 15,40 10,96 0,138! -10,96 -15,40 -15,-6 -12,-38 "
                  "-16,-70 -13,-100 0,-112", passes=2, reach=0.8)
    sheet.outline(ring(0, -130, 18, 17), closed=True, passes=2, reach=0.8)
    sheet.hatch("-11,-20 -11,40 -6,110", "11,-20 11,40 6,110", 8, colour=GREY)
    sheet.eye(-9, -134, 5)
    sheet.eye(9, -134, 5)
    sheet.line("-6,-146 -16,-204 -26,-254 -40,-292", "6,-146 18,-206 30,-262 46,-302", width=2.1)
    sheet.eye(-41, -294, 6)
    sheet.eye(47, -304, 6)
    sheet.group("noise")
    sheet.flecks("-380,60 -300,240 330,250 -120,300 400,-30")
