# SPDX-License-Identifier: Apache-2.0
"""Shapes that each test one thing: a large gap, a slanted gap, noise, a spiral."""

from sketching.curve import limb, parse, ring
from sketching.sheet import BLUE, GREY, LEAF, MINT, SEA, SKY, WARM


def mirrored(text, axis_x):
    """The same curve on the other side of an upright axis."""
    return [(2 * axis_x - x, y, corner) for x, y, corner in parse(text)]


def vase(sheet):
    """A vase with a large piece of its outline missing."""
    side = ("410,138! 414,156 438,182 448,216 436,254 378,300 318,354 294,420 308,490 354,564 "
            "404,618 424,650 412,668 386,686 382,704!")
    sheet.group("construction")
    sheet.guide("500,70 501,300 499,560 500,770", "250,420 500,424 560,420", "360,706 640,708")
    sheet.group("vase", SKY)
    sheet.outline(ring(500, 136, 92, 19), closed=True)
    sheet.outline(side, gaps="330,530,26")
    sheet.outline(mirrored(side, 500), gaps="702,440,225")
    sheet.outline("382,704 440,717 500,720 560,717 618,704")
    sheet.line("446,222 500,232 556,220", "438,250 500,262 562,250", "424,650 500,662 576,650")
    sheet.line("330,344 410,372 500,380 580,374", "306,384 400,414 500,422 570,418", colour=WARM)
    sheet.line("342,362 360,396", "366,372 384,404! 408,380", "408,380 428,412! 454,388",
               "454,388 476,416! 502,390", "502,390 522,416! 546,392", colour=WARM)
    sheet.line("318,510 400,540 490,548 560,544", "334,536 410,562 490,570 556,566", colour=WARM)
    sheet.hatch("300,400 310,486 354,560 412,630", "360,410 370,480 404,540 446,596", 34)
    sheet.hatch("440,176 452,216 436,264", "476,184 480,218 470,268", 12, slant=0.12)
    sheet.hatch("350,318 310,356 298,400", "396,330 356,366 346,404", 10)
    sheet.hatch("426,140 500,150 570,142", "440,148 500,154 560,149", 14)


def blob(sheet):
    """A friendly blob whose outline is open on a slant."""
    sheet.group("blob", MINT)
    sheet.outline("236,306 280,200 390,150 500,176 590,130 706,160 772,258 752,370 806,466 778,580 "
                  "676,640 566,612 476,672 356,648 298,560 206,502 190,396", closed=True, passes=3,
                  reach=0.75, gaps="752,206,160 330,606,24 208,352,20")
    sheet.line("290,312 330,236 400,202", "306,330 344,266 400,236", width=1.6, colour=GREY)
    sheet.line("402,470 440,510 500,524 560,504 592,458", "394,458 404,476", "586,450 602,462",
               "300,430 316,416 332,430", "640,300 660,290 672,306", "620,520 640,512 650,528",
               "380,540 396,530 406,546", width=1.7)
    sheet.eye(436, 366, 17, turns=6)
    sheet.eye(548, 352, 17, turns=6)
    sheet.line("408,330 432,318 458,328", "524,312 548,302 574,312")
    sheet.hatch("470,660 560,604 672,628 768,572 796,480", "450,628 556,570 660,588 732,542 756,470",
                32, slant=0.02)
    sheet.hatch("212,500 300,552 356,636", "240,486 322,534 380,608", 14, slant=-0.05)


def noisy_vase(sheet):
    """A jar full of strokes, with noise all around it."""
    side = ("404,150! 416,172 430,196 420,224 356,268 286,336 258,424 268,514 318,600 384,658 "
            "400,676 392,704!")
    sheet.group("construction")
    sheet.guide("500,90 502,380 498,750", "180,430 220,432", "790,428 840,430")
    sheet.group("vase", SEA)
    sheet.outline(ring(500, 148, 98, 20), closed=True)
    sheet.outline(side, gaps="300,320,34 350,630,22")
    sheet.outline(mirrored(side, 501), gaps="744,470,40 650,270,24")
    sheet.outline("392,704 450,716 500,718 552,716 610,704", gaps="530,717,30")
    sheet.line("426,206 500,218 576,204", "398,240 500,256 604,238")
    sheet.line("270,400 380,428 500,436 620,428 732,400", "266,476 380,508 500,516 620,508 736,476")
    sheet.scrawl(490, 320, 150, 66, 7)
    sheet.scrawl(430, 470, 130, 110, 9, colour=WARM, width=1.8)
    sheet.scrawl(610, 470, 120, 120, 9)
    sheet.scrawl(500, 600, 150, 56, 8, colour=WARM, width=1.8)
    sheet.scrawl(500, 460, 215, 215, 6, colour=GREY, width=1.6)
    sheet.line("300,380 420,440 560,400 700,450", "290,520 430,470 560,560 710,500",
               "360,610 470,540 520,640 650,590", "420,290 480,360 590,280 640,360")
    sheet.hatch("260,430 270,510 318,594 384,650", "330,420 340,500 380,570 430,620", 26)
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
    spine = "470,734 400,710 " + spiral_spine(500, 395, 318, 132, 26)
    widths = [26, 52, 62, 64, 64, 62, 60, 56, 54]
    band = limb(spine, widths)
    outer, inner = band[: len(band) // 2], limb(spine, [0.5 * w for w in widths])
    sheet.group("construction")
    sheet.guide("470,376 500,395 524,420", "478,412 500,395 530,376", "500,40 620,52 700,90")
    sheet.group("spiral", LEAF)
    sheet.outline(band, closed=True, gaps="500,48,26 850,420,24 190,500,22")
    sheet.hatch(outer[2:], inner[2 : len(inner) // 2], 120, slant=0.004)
    sheet.group("noise")
    sheet.flecks("120,140 880,120 900,640 110,660 860,720")
