# SPDX-License-Identifier: Apache-2.0
"""Robot and dragon: characters made of many layers."""

from sketching.curve import limb, ring
from sketching.sheet import (BUTTER, CHERRY, COCOA, CORAL, CREAM, HONEY, LEAF, LILAC, MINT, ROSE, SEA, SKY,
                             WHITE)

MIRRORED = "matrix(-1 0 0 1 1000 0)"


def robot(sheet):
    """A robot that waves."""
    sheet.group("construction")
    sheet.guide("500,40 500,780", "240,760 760,764")
    sheet.group("left-leg", SEA)
    sheet.outline("404,570 404,640 398,688", "466,688 470,640 472,570", passes=2)
    sheet.outline("398,680 360,700 340,740 352,762 420,766 486,762 490,730 466,684", passes=2)
    sheet.copy("right-leg", "left-leg", MIRRORED, fill=SEA)
    sheet.group("left-ear", HONEY, 3)
    sheet.small(ring(346, 226, 34, 44))
    sheet.copy("right-ear", "left-ear", MIRRORED, fill=HONEY, thickness=3)
    sheet.group("body", SKY)
    sheet.outline("372,350 400,336 500,330 600,336 628,350 640,440 634,540 610,592 500,602 390,592 "
                  "366,540 360,440", closed=True, gaps="640,440,20 500,602,24")
    sheet.line("384,360 388,372", "616,360 612,372", "386,574 392,562", "614,574 608,562", width=5, colour=SEA)
    sheet.group("head", SKY)
    sheet.outline("362,160 394,140 500,132 606,140 638,160 652,230 640,300 608,322 500,330 392,322 "
                  "360,300 348,230", closed=True, gaps="500,132,20 360,300,18")
    sheet.line("452,286 476,296 500,298 524,296 548,286", width=4)
    sheet.dab("398,276 602,276", radius=15, turns=4)
    sheet.group("antenna", CHERRY)
    sheet.outline("486,172 488,116 484,92 464,72 470,38 506,22 540,38 546,72 526,92 516,116 516,172", passes=2)
    sheet.line("484,52 494,42", colour=CREAM, width=5)
    sheet.group("left-eye", WHITE, 3)
    sheet.small(ring(440, 222, 42))
    sheet.pupil(448, 226, 15)
    sheet.group("right-eye", WHITE, 3)
    sheet.small(ring(560, 222, 42))
    sheet.pupil(552, 226, 15)
    sheet.group("screen", MINT, 0.5)
    sheet.outline("424,392 500,386 576,392 580,450 574,500 500,506 426,500 420,450", closed=True, passes=2)
    sheet.line("436,456 462,456 478,420 496,484 512,440 524,456 564,456", width=5, colour=CHERRY)
    for name, x, fill in (("red", 448, CORAL), ("yellow", 500, BUTTER), ("green", 552, LEAF)):
        sheet.group(f"{name}-button", fill, 3)
        sheet.small(ring(x, 548, 18))
    sheet.group("left-arm", LILAC)
    sheet.outline(limb("400,420 320,470 250,460 214,380", [56, 48, 44, 46]), passes=2)
    sheet.line("262,442 254,466", "236,426 214,440", colour=SEA, width=4)
    sheet.group("left-hand", HONEY)
    sheet.outline("176,366 150,330 152,276! 182,300 206,322 232,296 254,262! 266,314 254,356 222,384",
                  closed=True, passes=2)
    sheet.group("right-arm", LILAC)
    sheet.outline(limb("600,420 672,480 716,548 722,610", [56, 48, 44, 46]), passes=2)
    sheet.line("698,502 680,518", "726,550 704,558", colour=SEA, width=4)
    sheet.group("right-hand", HONEY)
    sheet.outline("690,608 672,650 684,706! 706,676 722,654 742,676 770,702! 774,652 756,612 722,596",
                  closed=True, passes=2)
    sheet.group("noise")
    sheet.flecks("140,140 860,240 200,620")


def dragon(sheet):
    """A small dragon with a small fire."""
    sheet.group("construction")
    sheet.guide("300,716 560,720 860,712", "300,210 440,200")
    sheet.copy("far-wing", "near-wing", "translate(-128 -26)", fill="#e0715a", thickness=0.4)
    sheet.copy("far-leg", "near-leg", "translate(-112 -18)", fill="#6fae55")
    sheet.group("fire", HONEY, 1)
    sheet.outline("226,268 190,240 150,238! 168,262 120,262 76,284! 128,296 110,324! 160,318 206,306 "
                  "232,292", passes=2)
    sheet.help("226,268 236,280 232,292")
    sheet.line("196,274 160,280 130,282", width=6, colour=CHERRY)
    sheet.group("tail-tip", CORAL, 1)
    sheet.outline("826,470 792,452 782,420 838,348! 884,424 872,456", passes=2)
    sheet.help("826,470 848,476 872,456")
    sheet.group("tail", LEAF)
    sheet.outline(limb("580,600 690,668 796,642 850,552 846,450", [116, 92, 66, 44, 26]), passes=2)
    sheet.line("706,636 712,656", "766,626 776,640", "816,584 832,588", colour=SEA, width=4)
    sheet.group("body", LEAF)
    sheet.outline("420,356 490,320 566,352 636,436 668,540 640,640 560,694 456,694 386,640 366,540 "
                  "384,440", closed=True, gaps="456,694,24 636,436,20")
    sheet.line("404,520 440,532 486,524", "394,564 440,576 498,566", "396,608 446,620 498,608",
               "414,650 452,660 494,650", width=13, colour=CREAM)
    sheet.group("spikes", CORAL, 1)
    sheet.outline("420,196 452,160 492,140! 482,186 490,214 532,216 548,222! 520,250 514,280 546,292 "
                  "566,308! 532,322 510,340", passes=2)
    sheet.help("420,196 470,256 510,340")
    sheet.group("horn", CREAM)
    sheet.outline("366,158 370,100 402,48! 418,104 416,160", passes=2)
    sheet.help("366,158 392,166 416,160")
    sheet.group("head", LEAF)
    sheet.outline("524,420 512,340 486,262 468,196 426,146 366,126 310,134 268,166 232,200 206,236 "
                  "214,272 250,292 310,300 362,304 386,340 396,400 410,440", gaps="310,134,18 486,262,20")
    sheet.line("214,274 262,270 320,276 352,258", "346,250 358,266", width=3)
    sheet.dab("236,218", radius=5, turns=3, colour=COCOA, width=3)
    sheet.dab("390,250", radius=20, turns=4, colour=ROSE)
    sheet.group("eye", WHITE, 3)
    sheet.small(ring(336, 196, 34, 38))
    sheet.pupil(326, 202, 14)
    sheet.group("near-wing", CORAL, 0.4)
    sheet.outline("552,448 590,340 650,232 742,140! 764,214 812,240! 796,304 846,344! 786,388 794,436! "
                  "716,424 640,456 578,496", gaps="650,232,20")
    sheet.line("600,420 660,300 738,160", "610,430 700,330 800,248", "616,442 720,382 830,346",
               width=4, colour=CHERRY)
    sheet.group("near-leg", LEAF)
    sheet.outline("500,560 462,598 452,652 414,682 396,708 420,722 520,722 576,704 612,650 618,594 "
                  "590,556", passes=2)
    sheet.help("500,560 546,540 590,556")
    sheet.line("424,706 420,720", "452,708 450,722", width=2.4)
    sheet.group("near-arm", LEAF)
    sheet.outline(limb("470,450 420,500 360,496 316,466", [52, 46, 38, 30]), passes=2)
    sheet.group("noise")
    sheet.flecks("120,120 900,180 140,560")
