#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the tables of Soffit's OCIO config (luts/*.spi1d) beside this file.

    python3 generate.py          writes the tables
    python3 generate.py --map    prints the control points of core/color/false_color.cpp
    python3 generate.py --search looks for the Filmic inset again (a minute)

Everything is computed from the few numbers below; no measured or third-party data.
"""
import math
import pathlib
import random
import sys

FOLDER = pathlib.Path(__file__).resolve().parent / "luts"
GREY = 0.18

# --- Filmic: a sigmoid of sRGB code value over stops about mid grey -------------------------
# Mid grey keeps its place (0.18 -> 0.18 on the display), SLOPE is a little above the sRGB
# curve's own 0.14 per stop, black is reached 10 stops below grey, white 6.5 stops above.
FILMIC_STOPS = (-10.0, 6.5)
SLOPE = 0.16
ENTRIES = 1024

# Light is mixed a little towards neutral before the curve and back after it, so that bright
# colours keep their hue and fade to white instead of turning to the nearest primary. Columns:
# where red, green, blue go; rows sum to 1 so that grey stays grey. Found by --search, stopped
# where the matrix is still well-conditioned (the search gains 8 % more with a near-singular one).
INSET = ((0.660, 0.318, 0.022),
         (0.109, 0.856, 0.035),
         (0.093, 0.272, 0.635))

# --- Reinhard 2002, equation 4, per channel ---------------------------------------------------
REINHARD_STOPS = (-14.0, 8.0)
REINHARD_WHITE = 16.0


def srgb_encode(x):
    return 12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055


def srgb_decode(y):
    return y / 12.92 if y <= 0.04045 else ((y + 0.055) / 1.055) ** 2.4


def limit(rise, run):
    """L such that run / sqrt(1 + (run / L)^2) = rise: the curve arrives where it should."""
    return run / math.sqrt((run / rise) ** 2 - 1)


PIVOT = srgb_encode(GREY)
SHOULDER = limit(1 - PIVOT, SLOPE * FILMIC_STOPS[1])
TOE = limit(PIVOT, -SLOPE * FILMIC_STOPS[0])


def filmic(stops):
    """Display-linear value of a scene value `stops` above mid grey."""
    stops = min(max(stops, FILMIC_STOPS[0]), FILMIC_STOPS[1])
    v = SLOPE * stops
    code = PIVOT + v / math.sqrt(1 + (v / (SHOULDER if v > 0 else TOE)) ** 2)
    return srgb_decode(min(max(code, 0.0), 1.0))


def reinhard(stops):
    x = GREY * 2.0 ** stops
    return min(x * (1 + x / REINHARD_WHITE ** 2) / (1 + x), 1.0)


# --- False colour: even steps of lightness, violet to yellow ----------------------------------
def oklab_from_linear(c):
    """Ottosson 2020, "A perceptual color space for image processing"."""
    r, g, b = (max(v, 0.0) for v in c)
    l = (0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) ** (1 / 3)
    m = (0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) ** (1 / 3)
    s = (0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b) ** (1 / 3)
    return (0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s)


def linear_from_oklab(lab):
    big_l, a, b = lab
    l = (big_l + 0.3963377774 * a + 0.2158037573 * b) ** 3
    m = (big_l - 0.1055613458 * a - 0.0638541728 * b) ** 3
    s = (big_l - 0.0894841775 * a - 1.2914855480 * b) ** 3
    return (4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)


def false_color(t):
    """sRGB code values at t in 0..1. Lightness rises evenly, so the order of the colours is
    also the order of their greys: readable without colour vision and in a black-and-white print."""
    lightness = 0.20 + 0.74 * t
    hue = math.radians(305.0 - 200.0 * t ** 1.15)
    chroma = 0.17
    while True:  # the most colourful that the display can show, with some room
        lab = (lightness, chroma * math.cos(hue), chroma * math.sin(hue))
        rgb = linear_from_oklab(lab)
        if all(0.002 <= v <= 0.99 for v in rgb) or chroma <= 0.0:
            return tuple(srgb_encode(min(max(v, 0.0), 1.0)) for v in rgb)
        chroma -= 0.001


MAP_POINTS = 33


def map_points():
    return [false_color(i / (MAP_POINTS - 1)) for i in range(MAP_POINTS)]


def map_at(points, t):
    x = t * (len(points) - 1)
    i = min(int(x), len(points) - 2)
    return tuple(a + (x - i) * (b - a) for a, b in zip(points[i], points[i + 1]))


# --- The search for INSET ---------------------------------------------------------------------
def times(matrix, c):
    return [sum(a * b for a, b in zip(row, c)) for row in matrix]


def inverse(m):
    (a, b, c), (d, e, f), (g, h, i) = m
    det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return [[(e * i - f * h) / det, (c * h - b * i) / det, (b * f - c * e) / det],
            [(f * g - d * i) / det, (a * i - c * g) / det, (c * d - a * f) / det],
            [(d * h - e * g) / det, (b * g - a * h) / det, (a * e - b * d) / det]]


def hue_error(inset):
    """RMS of the visible hue shift (Oklab, x100) of 48 colours over eight exposures, with
    mild wishes for colourfulness: keep it up to grey + 1 stop, lose it at the very top."""
    outset = inverse(inset)
    total = count = 0
    for k in range(48):
        h, s = (k % 12) / 2, (0.3, 0.6, 0.9, 1.0)[k // 12]
        color = [1 - s * max(0.0, min((n + h) % 6, 4 - (n + h) % 6, 1.0)) for n in (5, 3, 1)]
        y = max(0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2], 0.15)
        l0, a0, b0 = oklab_from_linear(color)
        for stops in (-3, -1, 0, 1, 2, 3, 4, 5):
            lit = [v * GREY * 2.0 ** stops / y for v in color]
            shown = times(outset, [filmic(math.log2(max(v, 1e-9) / GREY)) for v in times(inset, lit)])
            l, a, b = oklab_from_linear([min(v, 1.0) for v in shown])
            chroma = math.hypot(a, b)
            turn = math.remainder(math.atan2(b, a) - math.atan2(b0, a0), 2 * math.pi)
            total += (200 * chroma * math.sin(turn / 2)) ** 2
            if stops <= 1:
                total += 0.15 * (100 * (chroma - math.hypot(a0, b0) * l / l0)) ** 2
            if stops == 5:
                total += 0.2 * (100 * max(0.0, chroma - 0.06)) ** 2
            count += 1
    return math.sqrt(total / count)


def search():
    rng = random.Random(1)
    best, cost, step = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], math.inf, 0.1
    cost = hue_error(best)
    for trial in range(4000):
        rows = [[max(0.0, v + rng.gauss(0, step)) for v in row] for row in best]
        rows = [[v / sum(row) for v in row] for row in rows]
        try:
            found = hue_error(rows)
        except (ZeroDivisionError, OverflowError):
            continue
        if found < cost:
            best, cost = rows, found
        if trial % 500 == 499:
            step *= 0.6
            print(f"{trial + 1}: {cost:.3f}", [[round(v, 3) for v in row] for row in best])


def write(name, domain, rows):
    lines = ["Version 1", f"From {domain[0]} {domain[1]}", f"Length {len(rows)}",
             f"Components {len(rows[0])}", "{"]
    lines += [" ".join(f"{v:.8g}" for v in row) for row in rows] + ["}", ""]
    (FOLDER / name).write_text("\n".join(lines))


def table(curve, stops):
    lo, hi = stops
    rows = [(curve(lo + (hi - lo) * i / (ENTRIES - 1)),) for i in range(ENTRIES)]
    rows[0] = (0.0,)  # everything darker is black
    return rows


def main():
    if "--map" in sys.argv:
        for r, g, b in map_points():
            print(f"    {{{r:.4f}F, {g:.4f}F, {b:.4f}F}},")
    elif "--search" in sys.argv:
        search()
    else:
        FOLDER.mkdir(exist_ok=True)
        write("filmic.spi1d", (0.0, 1.0), table(filmic, FILMIC_STOPS))
        write("reinhard.spi1d", (0.0, 1.0), table(reinhard, REINHARD_STOPS))
        points = map_points()
        write("false_color.spi1d", (0.0, 1.0), [map_at(points, i / 256) for i in range(257)])  # on the points
        for name, stops in (("Filmic", FILMIC_STOPS), ("Reinhard", REINHARD_STOPS)):
            span = stops[1] - stops[0]
            print(f"{name}: log_side_slope {1 / span:.9f}, log_side_offset "
                  f"{(-stops[0] - math.log2(GREY)) / span:.9f}")
        print("outset", inverse(INSET), "hue error", hue_error(INSET),
              "without inset", hue_error(((1, 0, 0), (0, 1, 0), (0, 0, 1))))


if __name__ == "__main__":
    main()
