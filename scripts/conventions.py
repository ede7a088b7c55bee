#!/usr/bin/env python3
"""Draws the pictures of the conventions: axes of a contact, strips, axes of a wheel, the way from profiles to forces, the gauge.

    python3 scripts/conventions.py [FOLDER]            (FOLDER is docs/figures otherwise; needs nothing but Python)
"""

import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
# The palette of all pictures: Okabe and Ito
VERMILION, BLUE, GREEN, PURPLE, INK, GREY = "#D55E00", "#0072B2", "#009E73", "#CC79A7", "#222222", "#666666"
WHEEL, RAIL, STICK, SLIP = "#D6E4F0", "#E6E0D4", "#A6CBE8", "#FBE3B8"


class Picture:
    def __init__(self, width, height):
        self.lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
                      'font-family="sans-serif" font-size="15">', f'<rect x="0" y="0" width="{width}" height="{height}" fill="#FFFFFF"/>']

    def path(self, points, fill="none", stroke=INK, width=1.5, dashed=False, closed=True):
        text = " ".join(f"{'ML'[k > 0]}{x:.1f} {y:.1f}" for k, (x, y) in enumerate(points)) + (" Z" if closed else "")
        dash = ' stroke-dasharray="6 4"' if dashed else ""
        self.lines.append(f'<path d="{text}" fill="{fill}" stroke="{stroke}" stroke-width="{width}"{dash}/>')

    def line(self, start, end, stroke=INK, width=1.5, dashed=False):
        self.path([start, end], "none", stroke, width, dashed, False)

    def head(self, tip, angle, colour):
        x, y = tip
        ends = [(x - 11 * math.cos(angle + turn), y - 11 * math.sin(angle + turn)) for turn in (0.38, -0.38)]
        self.path([tip, *ends], colour, colour, 1)

    def arrow(self, start, end, colour=INK, width=2.0, both=False):
        angle = math.atan2(end[1] - start[1], end[0] - start[0])
        back = (end[0] - 8 * math.cos(angle), end[1] - 8 * math.sin(angle))
        self.line((start[0] + 8 * math.cos(angle), start[1] + 8 * math.sin(angle)) if both else start, back, colour, width)
        self.head(end, angle, colour)
        if both:
            self.head(start, angle + math.pi, colour)

    def turn(self, centre, radius, start, end, colour, flat=1.0):
        """An arrow along an arc, angles in degrees from x toward y of the picture."""
        steps = [math.radians(start + (end - start) * k / 40) for k in range(41)]
        points = [(centre[0] + radius * math.cos(a), centre[1] + flat * radius * math.sin(a)) for a in steps]
        self.path(points[:-3], "none", colour, 2.0, False, False)
        (x0, y0), (x1, y1) = points[-4], points[-1]
        self.head(points[-1], math.atan2(y1 - y0, x1 - x0), colour)

    def text(self, at, words, colour=INK, anchor="start", size=15, bold=False, halo=False):
        weight = ' font-weight="bold"' if bold else ""
        weight += ' stroke="#FFFFFF" stroke-width="5" paint-order="stroke"' if halo else ""
        words = words.replace("&", "&amp;").replace("<", "&lt;")
        self.lines.append(f'<text x="{at[0]}" y="{at[1]}" fill="{colour}" text-anchor="{anchor}" font-size="{size}"{weight}>{words}</text>')

    def write(self, path):
        path.write_text("\n".join([*self.lines, "</svg>", ""]), encoding="utf-8")


def ellipse(centre, a, b, start=0, end=360):
    angles = [math.radians(start + (end - start) * k / 72) for k in range(73)]
    return [(centre[0] + a * math.cos(t), centre[1] + b * math.sin(t)) for t in angles]


def contact(folder):
    """Two bodies from the side, and the patch from above."""
    p = Picture(820, 405)
    p.text((20, 26), "From the side", bold=True)
    p.path(ellipse((190, 60), 190, 130, 12, 168), WHEEL, INK, 1.5)
    p.path([(10, 190), (380, 190), (380, 292), (10, 292)], RAIL, INK, 1.5)
    p.text((190, 115), "upper body (wheel)", anchor="middle")
    p.text((100, 280), "lower body (rail)", anchor="middle")
    p.arrow((190, 190), (345, 190), INK)
    p.text((350, 182), "x")
    p.arrow((190, 190), (190, 250), INK)
    p.text((198, 248), "z")
    p.arrow((215, 165), (305, 165), BLUE, 3)
    p.text((120, 150), "slip of the upper body", BLUE)
    p.arrow((215, 215), (305, 215), VERMILION, 3)
    p.text((208, 238), "force on the lower body", VERMILION, size=14)
    p.text((20, 325), "creepage = (velocity of the upper body", BLUE)
    p.text((20, 345), "- velocity of the lower body) / rolling speed", BLUE)
    p.text((20, 375), "A positive creepage causes a positive force.", VERMILION)

    centre = (600, 190)
    p.text((430, 22), "From above, z points away from you", bold=True)
    p.path(ellipse(centre, 100, 130), STICK, INK)
    p.arrow(centre, (600, 34), INK)
    p.text((612, 50), "x, rolling direction")
    p.arrow(centre, (790, 190), INK)
    p.text((780, 180), "y", anchor="end")
    p.line((600, 320), (740, 320), GREY, 1, True)
    p.line((500, 190), (500, 350), GREY, 1, True)
    p.line((600, 190), (600, 350), GREY, 1, True)
    p.arrow((730, 190), (730, 320), GREY, 1.2, True)
    p.text((738, 262), "a", GREY)
    p.arrow((500, 342), (600, 342), GREY, 1.2, True)
    p.text((480, 347), "b", GREY)
    p.turn(centre, 48, -160, 60, GREEN)
    p.text((672, 140), "spin", GREEN, "middle")
    p.text((430, 376), "spin = difference of the angular velocities", GREEN)
    p.text((430, 394), "about z / rolling speed, from x to y", GREEN)
    p.write(folder / "axes_contact.svg")


def strips(folder):
    """A patch in strips."""
    p = Picture(820, 370)
    centre, a, b, count = (330, 185), 130, 210, 8
    edges = [-b * math.cos(math.pi * k / count) for k in range(count + 1)]
    for left, right in zip(edges, edges[1:]):
        middle = 0.5 * (left + right)
        half = a * math.sqrt(1 - (middle / b) ** 2)
        split = half * (0.25 - 0.9 * middle / b)
        split = max(-half, min(half, split))
        x0, x1 = centre[0] + left, centre[0] + right
        top, bottom, cut = centre[1] - half, centre[1] + half, centre[1] + split
        p.path([(x0, top), (x1, top), (x1, cut), (x0, cut)], STICK, INK, 1)
        p.path([(x0, cut), (x1, cut), (x1, bottom), (x0, bottom)], SLIP, INK, 1)
        p.line((x0, cut), (x1, cut), BLUE, 3.5)
    p.arrow((40, 345), (40, 265), INK)
    p.text((20, 252), "x, rolling")
    p.arrow((40, 345), (130, 345), INK)
    p.text((136, 350), "y")
    left, right = edges[4], edges[5]
    middle = 0.5 * (left + right)
    half = a * math.sqrt(1 - (middle / b) ** 2)
    x0, x1, at = centre[0] + left, centre[0] + right, centre[0] + middle
    p.line((at, centre[1] - half), (640, centre[1] - half), GREY, 1, True)
    p.line((at, centre[1]), (640, centre[1]), GREY, 1, True)
    p.arrow((590, centre[1] - half), (590, centre[1]), GREY, 1.2, True)
    p.text((600, centre[1] - 60), "half_length", GREY)
    p.text((600, centre[1] - 42), "of this strip", GREY)
    p.text((648, centre[1] + 5), "its centre", GREY)
    p.line((x0, centre[1] + half), (x0, 345), GREY, 1, True)
    p.line((x1, centre[1] + half), (x1, 345), GREY, 1, True)
    p.arrow((x0, 338), (x1, 338), GREY, 1.2, True)
    p.text((x1 + 8, 343), "width", GREY)
    p.text((590, 260), "separatrix", BLUE)
    p.text((590, 285), "ahead of it: stick", BLUE)
    p.text((590, 307), "behind it: slip", "#8A5A00")
    p.text((centre[0], 30), "leading edge", INK, "middle")
    p.write(folder / "axes_strips.svg")


def wheel(folder):
    """A wheel on its rail from behind and from above, with positive angles."""
    p = Picture(860, 430)
    p.text((20, 26), "From behind, x points away from you", bold=True)
    # the right wheel: the flange at small y
    p.path([(236, 110), (288, 110), (288, 212), (236, 212)], WHEEL)
    p.path([(200, 80), (324, 80), (324, 112), (200, 112)], WHEEL)
    p.path([(132, 205), (330, 205), (330, 240), (210, 240), (186, 244), (168, 254), (156, 274), (144, 280), (132, 272)], WHEEL)
    p.path([(176, 262), (186, 250), (210, 244), (262, 243), (290, 246), (300, 256), (302, 290), (262, 304), (262, 372), (310, 384), (310, 396),
            (166, 396), (166, 384), (214, 372), (214, 304), (176, 290)], RAIL)
    p.line((60, 96), (200, 96), GREY, 6)
    p.text((62, 84), "axle", GREY)
    p.text((170, 226), "wheel", anchor="middle")
    p.line((262, 96), (262, 241), GREY, 1, True)
    p.text((296, 185), "wheel_radius", GREY)
    p.text((238, 352), "rail", anchor="middle")
    p.text((20, 262), "flange and")
    p.text((20, 280), "gauge side")
    p.text((20, 298), "at small y")
    p.arrow((262, 96), (400, 96), INK)
    p.text((404, 101), "y")
    p.arrow((262, 243), (262, 340), INK)
    p.text((270, 335), "z")
    p.turn((262, 96), 44, 0, 80, VERMILION)
    p.text((306, 140), "roll: from y to z", VERMILION)
    p.line((262, 243), (400, 243), BLUE, 1.2, True)
    p.line((262, 243), (395, 293), BLUE, 1.2, True)
    p.turn((262, 243), 118, 0, 20, BLUE)
    p.text((392, 268), "contact angle:", BLUE, size=14)
    p.text((400, 288), "from y to z", BLUE, size=14)
    p.line((128, 312), (192, 228), BLUE, 2)
    p.text((20, 332), "negative on a flange", BLUE, size=14)

    p.text((520, 26), "From above, z points away from you", bold=True)
    centre = (680, 215)
    angle = math.radians(16)
    turned = lambda along, across: (centre[0] + across * math.cos(angle) + along * math.sin(angle),
                                    centre[1] + across * math.sin(angle) - along * math.cos(angle))
    p.path([(655, 60), (705, 60), (705, 385), (655, 385)], RAIL, GREY, 1)
    p.path([turned(95, -28), turned(95, 28), turned(-95, 28), turned(-95, -28)], WHEEL)
    p.line(turned(0, -135), turned(0, -28), GREY, 6)
    p.text((546, 165), "axle", GREY)
    p.line(turned(95, 0), turned(165, 0), PURPLE, 1.5, True)
    p.arrow(centre, (680, 42), INK)
    p.text((640, 50), "x")
    p.arrow(centre, (840, 215), INK)
    p.text((832, 206), "y")
    p.turn(centre, 140, -90, -75, PURPLE)
    p.text((724, 84), "yaw: from x to y", PURPLE)
    p.arrow((600, 400), (600, 300), GREEN)
    p.text((612, 412), "forward > 0", GREEN)
    p.turn((560, 300), 30, 200, 350, GREEN, 0.55)
    p.text((520, 350), "pitch < 0", GREEN, size=14)
    p.write(folder / "axes_wheel.svg")


def way(folder):
    """From profiles to the wrench, with the functions between."""
    p = Picture(860, 240)
    boxes = [("two profiles,", "position"), ("undeformed gap", "along the rail"), ("contacts:", "frame, load, patch"), ("wrench", "on the wheel")]
    names = ["kstrip_touch", "kstrip_contacts_", "kstrip_wrench_"]
    below = ["", "from_gap", "from_contacts"]
    for k, (first, second) in enumerate(boxes):
        x = 20 + 222 * k
        p.path([(x, 90), (x + 140, 90), (x + 140, 150), (x, 150)], (RAIL, STICK, STICK, WHEEL)[k])
        p.text((x + 70, 116), first, anchor="middle", size=14)
        p.text((x + 70, 136), second, anchor="middle", size=14)
        if k < 3:
            p.arrow((x + 144, 120), (x + 218, 120), BLUE)
            p.text((x + 181, 60), names[k], BLUE, "middle", 13)
            p.text((x + 181, 76), below[k], BLUE, "middle", 13)
    p.path([(90, 158), (90, 196), (756, 196), (756, 170)], "none", VERMILION, 2, False, False)
    p.head((756, 156), -math.pi / 2, VERMILION)
    p.text((423, 216), "kstrip_wheel_on_rail: all in one call", VERMILION, "middle")
    for k, words in ((1, "your own gap"), (2, "your own contacts, tables")):
        x = 90 + 222 * k
        p.arrow((x, 32), (x, 88), GREEN)
        p.text((x, 24), words, GREEN, "middle", 14)
    p.write(folder / "path.svg")


def gauge(folder):
    """A wheelset on its track: gauge, flange backs, running circles."""
    p = Picture(860, 400)
    mirror = lambda points: [(860 - x, y) for x, y in points]
    wheel_left = [(110, 216), (128, 110), (160, 110), (160, 76), (176, 76), (176, 216), (173, 234), (165, 240), (156, 236), (146, 222), (112, 217)]
    rail_left = [(98, 232), (104, 222), (138, 224), (150, 229), (153, 242), (153, 252), (134, 262), (134, 300), (170, 312), (84, 312), (118, 300),
                 (118, 262), (98, 252)]
    for side in (lambda points: points, mirror):
        p.path(side(wheel_left), WHEEL)
        p.path(side(rail_left), RAIL)
    p.path([(160, 86), (700, 86), (700, 104), (160, 104)], WHEEL)
    p.line((430, 44), (430, 380), GREY, 1, True)
    p.text((430, 36), "middle of the track", GREY, "middle")
    p.text((60, 60), "left, index 1")
    p.text((800, 60), "right, index 0", anchor="end")

    def size(x0, x1, y, words, colour, at=None):
        p.arrow((x0, y), (x1, y), colour, 1.5, True)
        p.text((at or 0.5 * (x0 + x1), y - 8), words, colour, "middle", halo=True)

    for x in (176, 684):
        p.line((x, 110), (x, 168), VERMILION, 1, True)
    size(176, 684, 160, "back_to_back 1360 mm", VERMILION, 300)
    for x in (153, 707):
        p.line((x, 242), (x, 278), BLUE, 1, True)
    size(153, 707, 272, "gauge 1435 mm", BLUE, 300)
    p.text((300, 292), "14 mm below the top of the rails", BLUE, "middle")
    p.line((738, 100), (738, 370), GREEN, 1, True)
    size(684, 738, 200, "70 mm", GREEN, 648)
    size(430, 738, 352, "running circle at 750 mm", GREEN)
    p.text((584, 372), "y = 0 of the wheel", GREEN, "middle")
    p.arrow((40, 340), (110, 340), INK)
    p.text((116, 345), "y")
    p.arrow((40, 340), (40, 390), INK)
    p.text((48, 390), "z")
    p.write(folder / "gauge.svg")


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "figures"
    for draw in (contact, strips, wheel, way, gauge):
        draw(folder)


if __name__ == "__main__":
    main()
