# SPDX-License-Identifier: MIT
"""Closed sculptures; each stands on z = 0, sunk 2 mm."""
import math

from .solids import Part, sphere, swept
from .vectors import cross, sub, unit

SUNK = -0.002


def knot_curve(p, q, major, minor, t):
    """A (p, q) torus knot, t in 0..1."""
    a = 2 * math.pi * t
    r = major + minor * math.cos(q * a)
    return (r * math.cos(p * a), r * math.sin(p * a), minor * math.sin(q * a))


def knot(p, q, major, minor, tube, steps, sides):
    points, frames = [], []
    for k in range(steps):
        t = k / steps
        here, ahead = knot_curve(p, q, major, minor, t), knot_curve(p, q, major, minor, t + 1e-4)
        along = unit(sub(ahead, here))
        centre = (major * math.cos(2 * math.pi * p * t), major * math.sin(2 * math.pi * p * t), 0.0)
        u = unit(cross(along, sub(here, centre)))
        points.append(here)
        frames.append((u, cross(along, u)))
    return swept(points, frames, [tube] * steps, sides, closed=True)


def standing_knot():
    """A trefoil on edge, 0.66 m high."""
    part = knot(2, 3, 0.21, 0.09, 0.05, 110, 10).turned(rx=90)
    low = min(v[2] for v in part.vertices)
    return part.moved(z=SUNK * 4 - low)


def twisted_column(height=0.85, sides=30, rings=36):
    """A star-shaped section that turns and narrows as it rises."""
    vertices, triangles = [], []
    for k in range(rings + 1):
        t = k / rings
        size = 0.15 * (1 - 0.45 * t) * (1 + 0.12 * math.sin(2 * math.pi * t))
        for i in range(sides):
            a = 2 * math.pi * i / sides
            r = size * (1 + 0.18 * math.cos(5 * a))
            turn = a + 2.4 * t
            vertices.append((r * math.cos(turn), r * math.sin(turn), SUNK + height * t))
    for k in range(rings):
        for i in range(sides):
            a, b = k * sides + i, k * sides + (i + 1) % sides
            triangles += [(a, b, b + sides), (a, b + sides, a + sides)]
    for ring, flip in ((0, True), (rings, False)):
        middle = len(vertices)
        vertices.append((0.0, 0.0, SUNK + height * ring / rings))
        for i in range(sides):
            a, b = ring * sides + i, ring * sides + (i + 1) % sides
            triangles.append((middle, b, a) if flip else (middle, a, b))
    return Part(vertices, triangles, crease_deg=35.0)


def pebble():
    """A smooth lump with hollows, 0.55 m across."""
    part = sphere(1.0, 40, 22)

    def swollen(p):
        x, y, z = p
        r = 1 + 0.22 * math.sin(2.6 * x + 0.6) * math.cos(2.1 * y) + 0.16 * math.sin(3.2 * z + 1.7 * x)
        return (0.26 * r * x, 0.22 * r * y, 0.20 * r * z)
    part = part.mapped(swollen)
    low = min(v[2] for v in part.vertices)
    return part.moved(z=SUNK * 4 - low)
