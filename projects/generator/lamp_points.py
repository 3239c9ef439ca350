# SPDX-License-Identifier: MIT
"""Points on and just in front of a luminaire, world coordinates, for checking its place."""
import math

from .vectors import add, rotated

AHEAD = 0.003  # metres


def points(fields, folder):
    shape = fields["shape"]
    if shape == "point":
        local = [(0.0, 0.0, 0.0)]
    else:
        (kind, size), = ((k, v) for k, v in shape.items() if k in _KINDS)
        local = _KINDS[kind](size, folder)
    return [add(fields["position"], rotated(p, *fields["rotation"])) for p in local]


def _flat(outline):
    middle = (sum(x for x, _ in outline) / len(outline), sum(y for _, y in outline) / len(outline))
    return [(x, y, z) for x, y in [*outline, middle] for z in (0.0, -AHEAD)]


def _rectangle(size, _):
    return _flat([(sx * size[0] / 2, sy * size[1] / 2) for sx in (-1, 1) for sy in (-1, 1)])


def _disk(radius, _):
    return _flat([(radius * math.cos(k * math.pi / 6), radius * math.sin(k * math.pi / 6)) for k in range(12)])


def _sphere(radius, _):
    r = radius + AHEAD
    return [(r, 0, 0), (-r, 0, 0), (0, r, 0), (0, -r, 0), (0, 0, r), (0, 0, -r)]


def _tube(size, _):
    r = size[1] + AHEAD
    return [(x * size[0] / 2, r * math.cos(k * math.pi / 4), r * math.sin(k * math.pi / 4))
            for x in (-1, 0, 1) for k in range(8)]


def _polygon(outline, _):
    return [(x, y, z) for x, y in outline for z in (0.0, -AHEAD)]


def _mesh(file, folder):
    lines = (folder / file).read_text(encoding="ascii").splitlines()
    return [tuple(float(w) for w in line.split()[1:4]) for line in lines if line.startswith("v ")]


_KINDS = {"rectangle": _rectangle, "disk": _disk, "sphere": _sphere, "tube": _tube, "polygon": _polygon,
          "mesh": _mesh}
