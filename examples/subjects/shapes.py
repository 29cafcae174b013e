# SPDX-License-Identifier: Apache-2.0
"""Shapes that each test one thing: a large gap, a slanted gap, noise, a spiral."""

from sketching.curve import limb, parse, ring
from sketching.sheet import BLUE, GREY, WARM


def mirrored(text, axis_x):
    """The same curve on the other side of an upright axis."""
    return [(2 * axis_x - x, y, corner) for x, y, corner in parse(text)]


def vase(sheet):
    """A vase with a large piece of its outline missing."""
    side = ("410,138! 414,156 438,182 448,216 436,254 378,300 318,354 294,420 308,490 354,564 "
            "404,618 424,650 412,668 386,686 382,704!")
    sheet.group("construction")
    sheet.guide("500,70 501,300 499,560 500,770", "250,420 500,424 560,420", "360,706 640,708")
    sheet.group("vase")
    sheet.outline(ring(500, 136, 92, 19), closed=True)
    sheet.outline(side, gaps="330,530,26")
    sheet.outline(mirrored(side, 500), gaps="702,440,225")
    sheet.outline("382,704 440,717 500,720 560,717 618,704")
    sheet.line("446,222 500,232 556,220", "438,250 500,262 562,250", "424,650 500,662 576,650")
    sheet.line("330,344 410,372 500,380 580,374", "306,384 400,414 500,422 570,418", colour=WARM)
    sheet.line("342,362 360,396", "366,372 384,404! 408,380", "408,380 428,412! 454,388",
               "454,388 476,416! 502,390", "502,390 522,416! 546,392", colour=WARM)
    sheet.line("318,510 400,540 490,548 560,544", "334,536 410,562 490,570 556,566", colour=WARM)
    sheet.hatch("310,420 320,480 352,540 400,600", "346,430 358,486 390,540 428,592", 18)
    sheet.hatch("448,190 456,216 448,240", "470,194 476,218 468,246", 7)
    sheet.hatch("426,140 500,150 570,142", "440,148 500,154 560,149", 9)


def blob(sheet):
    """A pebble whose outline is open on a slant."""
    sheet.group("blob")
    sheet.outline("268,270 350,172 476,132 604,156 716,228 790,338 784,460 716,526 682,612 590,676 "
                  "470,664 396,588 286,552 214,470 216,360", closed=True, passes=3, reach=0.72,
                  gaps="752,276,175 330,572,24 238,310,18")
    sheet.line("320,300 380,234 470,204", "330,326 386,266 450,238", width=1.6, colour=GREY)
    sheet.hatch("420,600 500,650 590,656 664,610", "440,566 512,604 584,604 636,566", 15)
    sheet.hatch("690,540 740,506 768,440", "654,520 700,480 724,426", 9)


def noisy_vase(sheet):
    """A jar full of strokes, with noise all around it."""
    side = ("404,150! 416,172 430,196 420,224 356,268 286,336 258,424 268,514 318,600 384,658 "
            "400,676 392,704!")
    sheet.group("construction")
    sheet.guide("500,90 502,380 498,750", "180,430 220,432", "790,428 840,430")
    sheet.group("vase")
    sheet.outline(ring(500, 148, 98, 20), closed=True)
    sheet.outline(side, gaps="300,320,34 350,630,22")
    sheet.outline(mirrored(side, 501), gaps="744,470,40 650,270,24")
    sheet.outline("392,704 450,716 500,718 552,716 610,704", gaps="530,717,30")
    sheet.line("426,206 500,218 576,204", "398,240 500,256 604,238")
    sheet.line("270,400 380,428 500,436 620,428 732,400", "266,476 380,508 500,516 620,508 736,476")
    sheet.scrawl(500, 350, 150, 60, 26)
    sheet.scrawl(500, 470, 180, 36, 34, colour=WARM)
    sheet.scrawl(500, 590, 130, 56, 26)
    sheet.scrawl(470, 470, 150, 150, 14, colour=GREY, width=1.5)
    sheet.group("noise")
    sheet.flecks("120,120 180,220 90,330 160,480 110,600 200,690 290,740 300,90 250,180 180,560 "
                 "860,110 800,210 900,300 870,430 930,540 840,620 780,700 700,750 720,100 820,330")
    sheet.flecks("200,330 140,410 230,620 780,560 660,180 880,680 60,480 600,60 400,70 940,200",
                 colour=GREY)
    sheet.line("70,220 110,260 150,250 180,290", "840,480 880,500 900,480", "130,700 160,720 190,716",
               "690,80 740,64 770,84", "910,380 930,400 920,430", width=1.7)
    sheet.line("220,110 232,128 224,140", "880,240 860,262 872,280", colour=BLUE)


def spiral_spine(centre_x, centre_y, outer, pitch, steps):
    """An Archimedean spiral as text, a point every 30 degrees, from the outside inwards."""
    cosine, sine = 0.8660254038, 0.5
    dx, dy = -0.5, 0.8660254038
    words = []
    for i in range(steps):
        radius = outer - pitch * i / 12
        words.append(f"{centre_x + dx * radius},{centre_y + dy * radius}")
        dx, dy = dx * cosine - dy * sine, dx * sine + dy * cosine
    return " ".join(words)


def spiral(sheet):
    """A spiral arm with two sides, like the young frond of a fern."""
    spine = spiral_spine(510, 405, 318, 132, 26)
    sheet.group("construction")
    sheet.guide("500,385 510,405 522,424", "494,412 510,405 528,398")
    sheet.group("spiral")
    sheet.outline(limb("120,742 210,742 290,716 " + spine, [30, 52, 60, 60, 58, 54, 50]),
                  passes=3, gaps="510,60,24 850,420,20")
    sheet.line("112,728 114,742 120,756", width=2.4)
