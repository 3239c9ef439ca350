# SPDX-License-Identifier: MIT
"""Three-component vectors as tuples, metres, z up."""
import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    n = length(a)
    return (a[0] / n, a[1] / n, a[2] / n)


def cos_sin_deg(angle):
    """Cosine and sine, exact at multiples of 90 degrees, so that turned boxes stay axis-parallel."""
    quarter = angle / 90.0
    if quarter == int(quarter):
        return [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][int(quarter) % 4]
    return math.cos(math.radians(angle)), math.sin(math.radians(angle))


def rotated(p, rx=0.0, ry=0.0, rz=0.0):
    """p turned by degrees about the fixed x, y, z axes in that order (as in the project file)."""
    x, y, z = p
    c, s = cos_sin_deg(rx)
    y, z = y * c - z * s, y * s + z * c
    c, s = cos_sin_deg(ry)
    x, z = x * c + z * s, -x * s + z * c
    c, s = cos_sin_deg(rz)
    x, y = x * c - y * s, x * s + y * c
    return (x, y, z)


def aim_rotation(direction):
    """The project-file rotation [0, ry, rz] that turns a luminaire's -z to `direction`."""
    x, y, z = unit(direction)
    ry = -math.degrees(math.acos(max(-1.0, min(1.0, -z))))
    rz = math.degrees(math.atan2(y, x)) if abs(x) + abs(y) > 1e-9 else 0.0
    return [0.0, round(ry, 3), round(rz, 3)]
