# SPDX-License-Identifier: MIT
"""Synthetic luminaire photometry, LM-63-2002, axially symmetric. CC0: no manufacturer's data."""
import math


def spot_ies(name, beam_deg, step_deg=1.0, cutoff_deg=90.0):
    """A Gaussian beam: half of the peak at +-beam_deg / 2. The candela integrate to 1000 lm.

    The integral takes the candela as linear in gamma between the angles, as readers do.
    """
    count = int(round(cutoff_deg / step_deg))
    angles = [i * step_deg for i in range(count + 1)]
    shape = [math.exp(-math.log(2.0) * (2.0 * a / beam_deg) ** 2) for a in angles]
    shape[-1] = 0.0
    lumens = sum(_band(math.radians(a), math.radians(b), p, q)
                 for a, b, p, q in zip(angles, angles[1:], shape, shape[1:]))
    candela = [f"{1000.0 / lumens * s:.2f}" for s in shape]
    lines = ["IESNA:LM-63-2002", "[TEST] synthetic", "[TESTLAB] none, computed by projects/generate.py",
             "[MANUFAC] none (CC0)", f"[LUMINAIRE] {name}, beam angle {beam_deg:g} degrees", "TILT=NONE",
             f"1 -1 1 {len(angles)} 1 1 2 -0.09 0 0", "1 1 12"]
    lines += _wrapped([f"{a:g}" for a in angles]) + ["0"] + _wrapped(candela)
    return ("\r\n".join(lines) + "\r\n").encode("ascii")


def _band(a, b, p, q):
    """Lumens of 2 pi times the integral of I(g) sin g from a to b, I linear from p to q."""
    slope = (q - p) / (b - a)
    return 2 * math.pi * (p * math.cos(a) - q * math.cos(b) + slope * (math.sin(b) - math.sin(a)))


def _wrapped(words, per_line=10):
    return [" ".join(words[i:i + per_line]) for i in range(0, len(words), per_line)]
