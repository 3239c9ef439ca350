# SPDX-License-Identifier: MIT
"""Nine pictures for the gallery and a rug, from formulas. pixel(u, v), v downward, linear RGB."""
import math
import random
from functools import lru_cache

from .images import png


def _mix(a, b, t):
    t = min(1.0, max(0.0, t))
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def _noise(seed):
    """Smooth noise in -1..1, summed over three octaves."""
    rng = random.Random(seed)
    grid = [[rng.uniform(-1, 1) for _ in range(64)] for _ in range(64)]

    def once(x, y):
        i, j = math.floor(x), math.floor(y)
        fx, fy = x - i, y - j
        sx, sy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
        left, right, upper, lower = i % 64, (i + 1) % 64, grid[j % 64], grid[(j + 1) % 64]
        top = upper[left] + (upper[right] - upper[left]) * sx
        bottom = lower[left] + (lower[right] - lower[left]) * sx
        return top + (bottom - top) * sy

    return lambda x, y: (once(x, y) + 0.5 * once(2 * x, 2 * y) + 0.25 * once(4 * x, 4 * y)) / 1.75


def _dusk():
    """Hills under an evening sky."""
    noise = _noise(1)
    ridge = lru_cache(maxsize=None)(lambda u, k: (0.60, 0.70, 0.82)[k] + 0.09 * noise(3 * u + 7 * k, 0.5 + k))

    def pixel(u, v):
        colour = _mix((0.06, 0.10, 0.28), (0.78, 0.42, 0.16), v / 0.62)
        if math.hypot((u - 0.68) * 1.4, v - 0.47) < 0.075:
            colour = (0.85, 0.62, 0.30)
        for k in range(3):
            if v > ridge(u, k):
                colour = _mix((0.22, 0.16, 0.26), (0.02, 0.03, 0.05), k / 2)
        return colour
    return pixel


def _blocks():
    """Fields of primary colour between black bars."""
    xs, ys = (0.0, 0.22, 0.61, 0.86, 1.0), (0.0, 0.31, 0.48, 0.80, 1.0)
    fills = {(0, 0): (0.70, 0.03, 0.03), (2, 1): (0.80, 0.62, 0.04), (3, 3): (0.03, 0.08, 0.42),
             (1, 2): (0.74, 0.73, 0.68), (0, 3): (0.78, 0.60, 0.05)}

    def pixel(u, v):
        if min(abs(u - x) for x in xs[1:-1]) < 0.012 or min(abs(v - y) for y in ys[1:-1]) < 0.012:
            return (0.02, 0.02, 0.02)
        cell = (sum(u > x for x in xs) - 1, sum(v > y for y in ys) - 1)
        return fills.get(cell, (0.80, 0.79, 0.74))
    return pixel


def _rings():
    def pixel(u, v):
        r = math.hypot(u - 0.5, v - 0.5)
        k = int(r / 0.075)
        palette = ((0.75, 0.20, 0.08), (0.80, 0.70, 0.50), (0.08, 0.25, 0.35), (0.70, 0.45, 0.10), (0.05, 0.08, 0.12))
        return palette[k % 5] if r < 0.45 else (0.72, 0.68, 0.58)
    return pixel


def _clouds():
    near, far = _noise(3), _noise(4)

    def pixel(u, v):
        t = 0.5 + 0.9 * near(5 * u + far(3 * u, 3 * v), 4 * v)
        return _mix((0.10, 0.27, 0.42), (0.80, 0.78, 0.72), t)
    return pixel


def _cells():
    rng = random.Random(5)
    seeds = [(rng.random(), rng.random(), (rng.uniform(0.05, 0.8), rng.uniform(0.05, 0.5), rng.uniform(0.05, 0.4)))
             for _ in range(26)]

    def pixel(u, v):
        first = second = (9.0, None)
        for x, y, colour in seeds:
            distance = math.hypot(u - x, v - y)
            if distance < first[0]:
                first, second = (distance, colour), first
            elif distance < second[0]:
                second = (distance, colour)
        return (0.75, 0.73, 0.68) if second[0] - first[0] < 0.012 else first[1]
    return pixel


def _waves():
    def pixel(u, v):
        t = 0.5 + 0.5 * math.sin(30 * v + 4 * math.sin(5 * u + 2 * v))
        return _mix((0.04, 0.20, 0.24), (0.72, 0.74, 0.60), t ** 1.5)
    return pixel


def _strokes():
    wash = _noise(7)

    def pixel(u, v):
        ink = wash(2.2 * u + 1.5 * v, 9 * v - 4 * u)
        return _mix((0.78, 0.75, 0.67), (0.03, 0.03, 0.04), 4 * (ink - 0.18))
    return pixel


def _spectrum():
    def pixel(u, v):
        k = math.floor(14 * u)
        hue = k / 14
        colour = tuple(0.45 + 0.40 * math.cos(2 * math.pi * (hue + p)) for p in (0.0, 0.67, 0.33))
        return _mix(colour, (0.80, 0.78, 0.74), abs(2 * v - 1) ** 3)
    return pixel


def _figure():
    """A pale arc over a dark field."""
    def pixel(u, v):
        bend = abs(math.hypot(u - 0.1, v - 0.9) - 0.62)
        colour = _mix((0.15, 0.05, 0.06), (0.05, 0.06, 0.12), v)
        return _mix((0.82, 0.66, 0.50), colour, (bend - 0.04 - 0.05 * u) / 0.03)
    return pixel


def _rug():
    def pixel(u, v):
        edge = min(u, v, 1 - u, 1 - v)
        if edge < 0.04:
            return (0.30, 0.05, 0.05)
        if edge < 0.09:
            return (0.62, 0.50, 0.34) if int(24 * (u + v)) % 2 else (0.10, 0.10, 0.22)
        diamond = abs((6 * u) % 1 - 0.5) + abs((4 * v) % 1 - 0.5)
        return (0.55, 0.42, 0.28) if diamond < 0.22 else (0.36, 0.07, 0.06) if diamond < 0.5 else (0.12, 0.12, 0.24)
    return pixel


PAINTINGS = [_dusk, _blocks, _rings, _clouds, _cells, _waves, _strokes, _spectrum, _figure]


def painting(index, width, height):
    """PNG number index (0 to 8), so many pixels wide and high."""
    return png(width, height, PAINTINGS[index]())


def rug(width, height):
    return png(width, height, _smooth(_rug(), width, height))


def _smooth(pixel, width, height, side=4):
    """The mean over each pixel: sharp borders would show as stairs when somebody stands on them."""
    offsets = [((k + 0.5) / side - 0.5) for k in range(side)]
    places = [(x / width, y / height) for y in offsets for x in offsets]

    def mean(u, v):
        colours = [pixel(u + x, v + y) for x, y in places]
        return tuple(sum(c) / len(colours) for c in zip(*colours))
    return mean
