# SPDX-License-Identifier: Apache-2.0
"""Dog and snail: characters made of several layers, with colours."""

from sketching.curve import limb, ring
from sketching.sheet import BROWN, BUTTER, CHERRY, COCOA, CORAL, CREAM, HONEY, ROSE, WARM, WHITE
from subjects.shapes import spiral_spine


def dog(sheet):
    """A dog that waits for a walk."""
    sheet.group("construction")
    sheet.guide("150,708 500,712 860,706", "120,300 300,286")
    sheet.copy("far-front-leg", "front-leg", "translate(78 -20)", fill="#d99d5a")
    sheet.copy("far-back-leg", "back-leg", "translate(-92 -20)", fill="#d99d5a")
    sheet.group("tail", HONEY)
    sheet.outline(limb("690,420 786,362 846,284 846,190", [66, 52, 40, 26]), passes=2)
    sheet.group("body", HONEY)
    sheet.outline("292,420 318,366 410,344 540,350 660,344 742,376 776,446 756,524 690,562 560,574 "
                  "430,578 340,554 300,496", closed=True, gaps="560,574,24 742,376,20")
    sheet.line("322,372 342,420 340,470 314,520", width=9, colour=CHERRY)
    sheet.dab("338,520", radius=15, turns=5, colour=BUTTER)
    sheet.dab("600,410", radius=46, turns=7, colour=BROWN, width=9)
    sheet.line("470,540 500,532", "520,552 552,546", "700,500 722,486")
    sheet.group("front-leg", HONEY)
    sheet.outline("348,470 346,560 340,634 312,660 300,688 320,706 382,706 406,690 410,636 414,560 "
                  "420,470", passes=2, gaps="410,636,16")
    sheet.line("326,690 328,704", "352,690 354,704", width=2.2)
    sheet.group("back-leg", HONEY)
    sheet.outline("632,456 606,508 612,562 634,604 628,652 600,674 592,694 612,708 680,706 702,688 "
                  "704,640 720,584 736,528 720,462", passes=2)
    sheet.help("632,456 678,436 720,462")
    sheet.line("616,692 618,706", "644,692 646,706", width=2.2)
    sheet.group("far-ear", BROWN)
    sheet.outline("246,252 214,168 228,112 268,116 296,168 300,250", passes=2)
    sheet.group("head", HONEY)
    sheet.outline("176,262 206,214 266,190 330,198 376,244 384,310 354,362 292,386 220,392 148,386 "
                  "106,360 100,322 126,296 156,284", closed=True, gaps="330,198,18 220,392,20")
    sheet.line("120,352 160,366 206,362 236,340", "232,332 242,348", width=2.4)
    sheet.dab("318,336", radius=20, turns=4)
    sheet.line("196,222 216,208 238,210", width=2.6)
    sheet.dab("158,326 178,338 180,318", radius=3, turns=2, colour=BROWN, width=3)
    sheet.group("tongue", ROSE, 1)
    sheet.outline("176,356 180,392 198,416 220,408 226,380 218,352", passes=2)
    sheet.line("200,370 202,398", colour=WARM)
    sheet.group("eye", WHITE)
    sheet.small(ring(226, 264, 26, 30))
    sheet.pupil(219, 268, 12)
    sheet.group("nose", COCOA, 3)
    sheet.small(ring(108, 310, 27, 22))
    sheet.line("96,300 106,296", colour=CREAM, width=4)
    sheet.group("near-ear", BROWN, 1.4)
    sheet.outline("306,238 344,204 402,246 434,326 424,390 388,402 356,356 332,288", passes=2)
    sheet.line("384,300 400,350", "404,300 414,340", colour=COCOA)
    sheet.group("noise")
    sheet.flecks("600,180 120,600 900,560")


def snail(sheet):
    """A snail in no hurry at all."""
    sheet.group("construction")
    sheet.guide("80,706 500,710 930,704", "540,200 540,660")
    sheet.copy("far-stalk", "near-stalk", "translate(74 14)", fill="#e9c46a")
    sheet.copy("far-eye", "near-eye", "translate(74 14)", fill=WHITE)
    sheet.group("body", BUTTER)
    sheet.outline("92,606 104,540 130,470 170,424 226,414 270,446 286,510 310,570 380,604 500,612 "
                  "640,612 780,620 870,640 916,672 868,694 700,702 480,706 280,706 156,698 108,664",
                  closed=True, gaps="480,706,30 170,424,16")
    sheet.line("110,560 136,580 170,580 196,560", "192,552 204,566", width=2.6)
    sheet.dab("212,520", radius=20, turns=4, colour=ROSE)
    sheet.line("330,690 350,676", "430,692 452,678", "540,692 562,678", "660,690 682,676",
               "770,684 790,672")
    sheet.group("shell", CORAL, 1.6)
    sheet.outline(ring(540, 420, 214, 206), closed=True, gaps="691,274,24 540,626,30")
    sheet.line(spiral_spine(540, 420, 164, 56, 33), width=8, colour=CHERRY)
    sheet.line("724,330 700,350", "744,420 714,420", "730,500 704,486", "680,570 662,548",
               "440,236 452,264", "560,214 556,244", width=5, colour=CREAM)
    sheet.group("near-stalk", BUTTER)
    sheet.outline(limb("208,480 186,380 164,280", [46, 32, 26]), passes=2)
    sheet.group("near-eye", WHITE, 4)
    sheet.small(ring(160, 252, 42))
    sheet.pupil(146, 256, 15)
    sheet.group("noise")
    sheet.flecks("860,200 60,300 930,480")
