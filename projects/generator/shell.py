# SPDX-License-Identifier: MIT
"""Rooms as the boundary of a union of air boxes.

All faces lie on one grid made of every box's coordinates, so neighbours share their vertices: no
T-junctions, hence no cracks, and the shell is closed wherever two rooms, a window recess or a
doorway meet. Faces are wound toward the air.
"""
from itertools import product

from .solids import Part

DIRECTIONS = {"-x": (0, -1), "+x": (0, 1), "-y": (1, -1), "+y": (1, 1), "-z": (2, -1), "+z": (2, 1)}


class Shell:
    def __init__(self):
        self.air = []
        self.rules = []

    def room(self, low, high):
        """Adds a box of air."""
        self.air.append((tuple(low), tuple(high)))

    def paint(self, material, sides="-x +x -y +y -z +z", low=None, high=None):
        """Faces on these sides of the air (and, if given, with their middle in the box low..high)
        get the material; later rules win. Material None leaves the face out (an opening)."""
        self.rules.append((material, sides.split(), low, high))

    def contains(self, p):
        return any(all(low[k] <= p[k] <= high[k] for k in range(3)) for low, high in self.air)

    def parts(self):
        """{material: Part}, all wound toward the air."""
        breaks = [sorted({b[k] for box in self.air for b in box}) for k in range(3)]
        counts = [len(b) - 1 for b in breaks]

        def is_air(cell):
            if any(not 0 <= cell[k] < counts[k] for k in range(3)):
                return False
            return self.contains([(breaks[k][cell[k]] + breaks[k][cell[k] + 1]) / 2 for k in range(3)])

        parts, index = {}, {}
        for cell in product(*(range(c) for c in counts)):
            if not is_air(cell):
                continue
            for side, (axis, sign) in DIRECTIONS.items():
                neighbour = list(cell)
                neighbour[axis] += sign
                if is_air(neighbour):
                    continue
                corners = _face(cell, axis, sign)
                material = self._material(side, [[breaks[k][c[k]] for k in range(3)] for c in corners])
                if material is None:
                    continue
                part = parts.setdefault(material, Part([], []))
                ids = []
                for corner in corners:
                    key = (material, tuple(corner))
                    if key not in index:
                        index[key] = len(part.vertices)
                        part.vertices.append(tuple(breaks[k][corner[k]] for k in range(3)))
                    ids.append(index[key])
                part.triangles += [(ids[0], ids[1], ids[2]), (ids[0], ids[2], ids[3])]
        return parts

    def _material(self, side, corners):
        middle = [sum(c[k] for c in corners) / 4 for k in range(3)]
        for material, sides, low, high in reversed(self.rules):
            if side in sides and (low is None or all(low[k] <= middle[k] <= high[k] for k in range(3))):
                return material
        raise ValueError(f"no material for the {side} side at {middle}")


def _face(cell, axis, sign):
    """Grid corners of a cell's face, counter-clockwise seen from inside the cell."""
    j, k = (axis + 1) % 3, (axis + 2) % 3
    ring = []
    for dj, dk in ((0, 0), (1, 0), (1, 1), (0, 1)):
        corner = list(cell)
        corner[axis] += 1 if sign > 0 else 0
        corner[j] += dj
        corner[k] += dk
        ring.append(corner)
    return ring[::-1] if sign > 0 else ring
