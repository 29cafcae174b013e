# SPDX-License-Identifier: Apache-2.0
"""Butterfly."""

from sketching.curve import ring
from sketching.sheet import GREY, WARM


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
        sheet.group(f"{name}-forewing")
        sheet.outline("18,-92 58,-150 122,-222 204,-286 288,-316 340,-296 344,-244 318,-176 276,-110 "
                      "236,-56 190,-26! 130,-20 70,-22 18,-34", passes=3, gaps="250,-304,30")
        sheet.help("18,-92 17,-64 18,-34")
        sheet.line("24,-70 110,-130 190,-200 270,-262", "24,-60 120,-96 216,-130 290,-150",
                   "24,-50 110,-58 190,-60 236,-66", width=1.6)
        sheet.line("150,-168 190,-160 212,-130 200,-96")
        sheet.line(ring(262, -214, 24, 28), ring(232, -150, 15, 18), closed=True, colour=WARM)
        sheet.eye(*(288, -262), 9, turns=4, colour=WARM)
        sheet.hatch("300,-300 334,-262 316,-190 280,-120", "286,-290 312,-254 298,-190 264,-122", 14)
        sheet.group(f"{name}-hindwing")
        sheet.outline("18,-22 80,-10 140,-8 196,-16 246,10 266,66 250,124 212,160 184,172! 188,206 "
                      "204,240! 166,224 146,188! 104,192 66,156 40,100 18,48",
                      passes=3, gaps="90,186,26")
        sheet.help("18,-22 17,12 18,48")
        sheet.line("24,-6 90,20 160,40 236,50", "24,8 80,58 140,104 196,146", "24,24 56,80 92,150",
                   width=1.6)
        sheet.line("124,20 160,60 150,110 108,124")
        sheet.line(ring(198, 84, 22, 24), closed=True, colour=WARM)
        sheet.eye(198, 84, 8, turns=4, colour=WARM)
        sheet.hatch("256,60 244,116 206,156", "240,60 228,106 194,142", 8)
    sheet.place = tilted(1)
    sheet.group("body")
    sheet.outline("0,-112 16,-100 20,-70 16,-38 19,-6 18,40 12,96 0,138! -12,96 -18,40 -19,-6 -16,-38 "
                  "-20,-70 -16,-100 0,-112", passes=2, reach=0.8)
    sheet.outline(ring(0, -130, 18, 17), closed=True, passes=2, reach=0.8)
    sheet.hatch("-14,-20 -14,40 -8,110", "14,-20 14,40 8,110", 10, colour=GREY)
    sheet.eye(-9, -134, 5)
    sheet.eye(9, -134, 5)
    sheet.line("-6,-146 -30,-200 -72,-240 -100,-244", "6,-146 34,-206 72,-252 104,-262", width=2.1)
    sheet.eye(-102, -243, 6)
    sheet.eye(107, -262, 6)
    sheet.group("noise")
    sheet.flecks("-380,60 -360,220 300,260 -120,300 420,-60")
