# SPDX-License-Identifier: MIT
"""Furniture of a flat as lists of (material, Part).

Local frame: on the floor, its back at y = 0, the front toward -y, the middle at x = 0, unless said
otherwise. Pieces that touch sink 2 mm or more into each other.
"""
import math

from .solids import box, chamfered_box, cylinder, lathe, prism, rod, rounded_box, textured


def sofa(width, seats):
    """Also an armchair, with one seat."""
    half, arm = width / 2, 0.16
    pieces = [("sofa", rounded_box((-half + 0.05, -0.88, 0.10), (half - 0.05, -0.06, 0.27), 0.02)),
              ("sofa", rounded_box((-half + 0.02, -0.24, 0.12), (half - 0.02, -0.02, 0.74), 0.06))]
    for side in (-1, 1):
        inner, outer = sorted((side * (half - arm), side * half))
        pieces.append(("sofa", rounded_box((inner, -0.90, 0.11), (outer, -0.03, 0.58), 0.06)))
        for y in (-0.82, -0.12):
            pieces.append(("oak", cylinder(0.018, 0.002, 0.13, 8, top_radius=0.026).moved(side * (half - 0.11), y)))
    step = (width - 2 * arm) / seats
    for k in range(seats):
        x0 = -half + arm + k * step
        pieces.append(("sofa", rounded_box((x0 + 0.004, -0.90, 0.255), (x0 + step - 0.004, -0.20, 0.43), 0.05)))
        back = rounded_box((x0 + 0.006, -0.09, 0.0), (x0 + step - 0.006, 0.09, 0.34), 0.07)
        pieces.append(("sofa", back.turned(rx=-10).moved(y=-0.32, z=0.40)))
    return pieces


def cushion(material):
    """Its middle at the origin, standing in the xz plane."""
    part = rounded_box((-0.22, -0.07, -0.22), (0.22, 0.07, 0.22), 0.065, 2)
    return [(material, part.mapped(lambda p: (p[0], p[1] * (1 - 8 * max(p[0] ** 2, p[2] ** 2)), p[2])))]


def round_table(radius, height, top="oak", foot="steel"):
    """Its axis at the origin."""
    edge = [(0.0, height - 0.03), (radius - 0.02, height - 0.03), (radius, height - 0.012), (radius, height - 0.006),
            (radius - 0.006, height), (0.0, height)]
    stand = [(0.0, 0.002), (radius * 0.55, 0.002), (radius * 0.55, 0.012), (0.05, 0.04), (0.035, 0.08), (0.035, height - 0.06),
             (0.09, height - 0.028), (0.0, height - 0.027)]
    return [(top, lathe(edge, 36)), (foot, lathe(stand, 16))]


def low_table(length, depth, height):
    """Its middle at the origin."""
    x, y = length / 2, depth / 2
    pieces = [("oak", rounded_box((-x, -y, height - 0.035), (x, y, height), 0.008)),
              ("oak", box((-x + 0.06, -y + 0.05, 0.14), (x - 0.06, y - 0.05, 0.16)))]
    for sx in (-1, 1):
        for sy in (-1, 1):
            pieces.append(("oak", cylinder(0.018, 0.002, height - 0.02, 10, top_radius=0.026).moved(sx * (x - 0.07), sy * (y - 0.07))))
    return pieces


def dining_chair():
    """Its middle at the origin, the back toward +y."""
    pieces = [("oak", chamfered_box((-0.21, -0.21, 0.43), (0.21, 0.20, 0.46), 0.008)),
              ("cushion_green", rounded_box((-0.19, -0.19, 0.452), (0.19, 0.17, 0.482), 0.012))]
    for sx in (-1, 1):
        pieces.append(("oak", rod((sx * 0.19, -0.19, 0.002), (sx * 0.17, -0.17, 0.44), 0.016, 8)))
        pieces.append(("oak", rod((sx * 0.19, 0.20, 0.002), (sx * 0.175, 0.175, 0.45), 0.017, 8)))
        pieces.append(("oak", rod((sx * 0.175, 0.178, 0.44), (sx * 0.17, 0.235, 0.86), 0.014, 8)))
    rest = chamfered_box((-0.20, -0.010, 0.66), (0.20, 0.014, 0.84), 0.006)
    pieces.append(("oak", rest.mapped(lambda p: (p[0], p[1] + 0.228 - 0.5 * p[0] * p[0] + 0.02, p[2]))))
    return pieces


def bed(width, length):
    """Its head at y = 0."""
    half = width / 2
    pieces = [("oak", chamfered_box((-half - 0.04, -0.06, 0.05), (half + 0.04, -0.005, 1.02), 0.006)),
              ("oak", chamfered_box((-half - 0.02, -length - 0.02, 0.12), (half + 0.02, -0.05, 0.30), 0.006)),
              ("linen", rounded_box((-half + 0.01, -length, 0.28), (half - 0.01, -0.065, 0.50), 0.05, 2)),
              ("duvet", rounded_box((-half - 0.03, -length - 0.02, 0.34), (half + 0.03, -0.62, 0.57), 0.06, 2))]
    for sx in (-1, 1):
        for y in (-length + 0.10, -0.20):
            pieces.append(("oak", box((sx * (half - 0.1) - 0.03, y - 0.03, -0.002), (sx * (half - 0.1) + 0.03, y + 0.03, 0.13))))
        pillow = rounded_box((-0.34, -0.20, -0.07), (0.34, 0.20, 0.07), 0.065, 2)
        pieces.append(("linen", pillow.turned(rx=-22).moved(sx * 0.39, -0.30, 0.57)))
    return pieces


def bedside_table():
    return [("oak", chamfered_box((-0.22, -0.40, 0.44), (0.22, -0.01, 0.46), 0.004)),
            ("cupboard", box((-0.21, -0.385, 0.18), (0.21, -0.015, 0.443))),
            ("cupboard", box((-0.20, -0.400, 0.19), (0.20, -0.382, 0.435))),
            ("steel", box((-0.05, -0.418, 0.36), (0.05, -0.398, 0.37))),
            ("oak", box((-0.20, -0.375, -0.002), (0.20, -0.025, 0.05))),
            ("oak", box((-0.03, -0.22, 0.045), (0.03, -0.18, 0.185)))]


def wardrobe(width, height, doors):
    pieces = [("cupboard", box((-width / 2, -0.58, 0.05), (width / 2, 0.002, height))),
              ("cupboard", box((-width / 2 + 0.02, -0.55, -0.002), (width / 2 - 0.02, -0.01, 0.055)))]
    step = width / doors
    for k in range(doors):
        x0 = -width / 2 + k * step
        pieces.append(("cupboard", chamfered_box((x0 + 0.003, -0.602, 0.056), (x0 + step - 0.003, -0.578, height - 0.004), 0.003)))
        x = x0 + (step - 0.05 if k % 2 == 0 else 0.05)
        pieces.append(("steel", rod((x, -0.625, 0.95), (x, -0.625, 1.25), 0.007, 8)))
        for z in (0.98, 1.22):
            pieces.append(("steel", rod((x, -0.622, z), (x, -0.600, z), 0.005, 6)))
    return pieces


def drawers(width, height, rows, depth=0.44):
    """A chest of drawers, also a low board for a television."""
    pieces = [("oak", chamfered_box((-width / 2, -depth, height - 0.025), (width / 2, 0.002, height), 0.004)),
              ("cupboard", box((-width / 2 + 0.01, -depth + 0.02, 0.10), (width / 2 - 0.01, 0.001, height - 0.02)))]
    columns = 2
    step, rise = (width - 0.03) / columns, (height - 0.145) / rows
    for i in range(columns):
        for j in range(rows):
            x0, z0 = -width / 2 + 0.015 + i * step, 0.11 + j * rise
            pieces.append(("cupboard", box((x0 + 0.002, -depth + 0.004, z0 + 0.002), (x0 + step - 0.002, -depth + 0.022, z0 + rise - 0.002))))
            x = x0 + step / 2
            pieces.append(("steel", box((x - 0.06, -depth - 0.014, z0 + rise * 0.7), (x + 0.06, -depth + 0.006, z0 + rise * 0.7 + 0.01))))
    for sx in (-1, 1):
        for y in (-depth + 0.07, -0.07):
            pieces.append(("oak", cylinder(0.016, 0.002, 0.105, 8, top_radius=0.024).moved(sx * (width / 2 - 0.09), y)))
    return pieces


BOOKS = ["book_red", "book_blue", "book_cream", "book_green", "book_dark"]


def bookcase(width, height, shelves, rng):
    """Filled with books, here and there a gap or a vase."""
    depth, half = 0.30, width / 2
    pieces = [("oak", box((-half, -depth, -0.002), (-half + 0.025, 0.002, height))),
              ("oak", box((half - 0.025, -depth, -0.002), (half, 0.002, height))),
              ("oak", box((-half + 0.02, -0.012, 0.03), (half - 0.02, 0.001, height - 0.03)))]
    levels = [0.06 + k * (height - 0.10) / shelves for k in range(shelves + 1)]
    for z in levels:
        pieces.append(("oak", box((-half + 0.021, -depth + 0.006, z), (half - 0.021, -0.008, z + 0.024))))
    room = (height - 0.10) / shelves - 0.05
    for z in levels[:-1]:
        x = -half + 0.035
        while x < half - 0.09:
            if rng.random() < 0.08:
                x += rng.uniform(0.10, 0.25)
                continue
            thick, tall, deep = rng.uniform(0.018, 0.05), rng.uniform(0.62, 0.95) * room, rng.uniform(0.15, 0.23)
            pieces.append((rng.choice(BOOKS), box((x, -depth + 0.02 + rng.uniform(0, 0.03), z + 0.022),
                                                  (x + thick, -depth + 0.05 + deep, z + 0.022 + tall))))
            x += thick + 0.0025
    return pieces


def television(width):
    """On a board at z = 0, its middle at the origin; the screen faces -y."""
    height = width * 0.57
    return [("black", box((-0.22, -0.10, -0.002), (0.22, 0.10, 0.010))), ("black", box((-0.04, 0.01, 0.006), (0.04, 0.03, 0.12))),
            ("black", chamfered_box((-width / 2, -0.02, 0.06), (width / 2, 0.02, 0.06 + height), 0.005)),
            ("screen", box((-width / 2 + 0.012, -0.022, 0.075), (width / 2 - 0.012, -0.016, 0.048 + height)))]


def vase(height, radius):
    profile = [(0.0, -0.002), (0.55, -0.002), (0.9, 0.12), (1.0, 0.35), (0.8, 0.62), (0.42, 0.82), (0.45, 1.0), (0.36, 1.0),
               (0.32, 0.84), (0.0, 0.72)]
    return [("ceramic", lathe([(r * radius, z * height) for r, z in profile], 20, crease_deg=50.0))]


def bowl():
    return lathe([(0.0, -0.002), (0.06, -0.002), (0.15, 0.06), (0.165, 0.09), (0.155, 0.09), (0.10, 0.035), (0.0, 0.02)], 24)


def rug(width, depth):
    return [("rug", textured(box((-width / 2, -depth / 2, -0.002), (width / 2, depth / 2, 0.010)), 0, 1))]


def curtain(width, bottom, top, waves=7):
    """A gathered cloth, 2 cm thick, hanging in front of the wall."""
    front, back = [], []
    for i in range(6 * waves + 1):
        x = width * (i / (6 * waves) - 0.5)
        y = -0.09 + 0.035 * math.sin(2 * math.pi * waves * i / (6 * waves))
        front.append((x, y - 0.01))
        back.append((x, y + 0.01))
    return [("curtain", prism(front + back[::-1], bottom, top, crease_deg=60.0))]


def curtain_rail(width, z):
    pieces = [("steel", rod((-width / 2, -0.09, z), (width / 2, -0.09, z), 0.012, 8))]
    for side in (-1, 1):
        x = side * (width / 2 - 0.05)
        pieces.append(("steel", box((x - 0.008, -0.098, z - 0.008), (x + 0.008, 0.002, z + 0.006))))
    return pieces


def floor_lamp(height):
    """The stand of a lamp whose shade begins at this height."""
    return [("steel", lathe([(0.0, 0.002), (0.15, 0.002), (0.15, 0.014), (0.02, 0.030), (0.009, 0.05), (0.009, height - 0.004),
                             (0.0, height - 0.003)], 16))]


def table_lamp(height):
    """The foot of a lamp whose shade begins at this height above the table."""
    return [("ceramic", lathe([(0.0, -0.002), (0.05, -0.002), (0.065, 0.04), (0.05, 0.09), (0.015, height - 0.02), (0.012, height - 0.004),
                               (0.0, height - 0.003)], 16))]


def shade(lower, upper, height):
    """A lampshade with closed ends: the luminous body of a lamp. Its lower end at z = 0."""
    return lathe([(0.0, 0.0), (lower, 0.0), (upper, height), (0.0, height)], 20)
