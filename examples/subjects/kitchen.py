# SPDX-License-Identifier: Apache-2.0
"""A mug: a character with two rings."""

from sketching.curve import limb, ring
from sketching.sheet import BROWN, BUTTER, CHERRY, COCOA, CREAM, HONEY, ROSE, SEA, SKY, WHITE


def mug(sheet):
    """A mug of cocoa that brings a doughnut."""
    sheet.group("construction")
    sheet.guide("200,664 520,672 820,660", "515,120 515,700")
    sheet.group("handle", SEA)
    sheet.outline(ring(744, 420, 140, 150), closed=True, passes=2, gaps="884,420,18")
    sheet.outline(ring(748, 420, 84, 94), closed=True, passes=2)
    sheet.group("left-leg", SEA)
    sheet.outline("396,590 394,660 388,712 350,732 346,756 372,768 452,768 462,748 454,700 456,650 "
                  "460,590", passes=2)
    sheet.copy("right-leg", "left-leg", "matrix(-1 0 0 1 1036 0)", fill=SEA)
    sheet.group("body", SKY)
    sheet.outline("284,250 298,430 316,556 352,632 430,664 520,672 612,662 688,630 718,556 734,430 "
                  "748,250 704,210 612,188 516,182 420,188 328,210", closed=True,
                  gaps="734,430,26 352,632,20")
    sheet.pupil(430, 400, 21)
    sheet.pupil(600, 400, 21)
    sheet.line("422,350 440,340 460,346", "572,346 592,340 610,350", width=3)
    sheet.line("456,462 484,492 516,500 548,492 574,462", "448,456 462,468", "568,468 582,456", width=3.4)
    sheet.dab("406,466 640,466", radius=24, turns=5)
    sheet.line("320,560 400,588 516,596 630,588 710,560", width=9, colour=WHITE)
    sheet.group("cocoa", BROWN, 0.5)
    sheet.outline(ring(516, 246, 196, 40), closed=True, passes=2)
    sheet.line("380,250 420,262 470,266", "600,262 650,254", colour=COCOA)
    sheet.group("marshmallow", WHITE)
    sheet.outline("420,210 418,240 424,262 460,270 496,262 502,238 500,210 462,202", closed=True,
                  passes=2)
    sheet.dab("444,232 474,234", radius=3, turns=2, colour=COCOA, width=3)
    sheet.line("450,244 460,250 470,244")
    sheet.group("doughnut", ROSE, 2.4)
    sheet.outline(ring(142, 238, 104), closed=True, gaps="142,134,16")
    sheet.outline(ring(142, 238, 46), closed=True)
    # Only a few: a ring with much ink on it would be taken for a plate with something drawn on.
    sheet.line("88,188 96,178", "150,158 162,164", "208,212 210,224", width=8, colour=CHERRY)
    sheet.line("70,246 72,258", "116,150 124,144", "190,296 200,288", width=8, colour=BUTTER)
    sheet.line("104,300 114,308", "184,172 194,168", "214,256 216,268", width=8, colour=WHITE)
    sheet.group("arm", SEA)
    sheet.outline(limb("338,452 262,476 196,432 166,326", [56, 50, 46, 50]), passes=2)
    sheet.group("noise")
    sheet.flecks("860,140 80,600 900,660", colour=HONEY)
    sheet.line("470,150 486,120 468,92 484,62", "560,148 576,118 558,88 574,58", colour=CREAM)
