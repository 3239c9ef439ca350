# SPDX-License-Identifier: MIT
"""The office's luminaires and its layouts."""
import math

from . import furniture, office
from .model import Model
from .project import luminaire_fields
from .solids import swept

CEILING = 2.8


def _panels(project):
    for row in range(3):
        for column in range(4):
            project.luminaire(f"Panel {4 * row + column + 1}", shape={"rectangle": [0.6, 1.2]},
                              position=[1.5 + 3 * column, 1.35 + 2.65 * row, CEILING - 0.01],
                              flux=5400, cct=4000, group="General")


def panels_with(**fields):
    return {f"Panel {k}": dict(fields) for k in range(1, 13)}


def ribbon(length, width, swing, steps=16):
    """A wave-shaped outline along y, the same width everywhere: not convex."""
    left, right = [], []
    for i in range(steps + 1):
        y = length * (i / steps - 0.5)
        phase = 2 * math.pi * 1.5 * i / steps
        x, slope = swing * math.sin(phase), swing * 2 * math.pi * 1.5 / length * math.cos(phase)
        n = math.hypot(1.0, slope)
        left.append([round(x - width / 2 / n, 4), round(y + width / 2 * slope / n, 4)])
        right.append([round(x + width / 2 / n, 4), round(y - width / 2 * slope / n, 4)])
    return right + left[::-1]


def ring_mesh():
    """A wavy ring lying in its xy plane, 0.5 m across: a luminous mesh, closed and wound outward."""
    points, frames, radii, count = [], [], [], 40
    for i in range(count):
        a = 2 * math.pi * i / count
        radial = (math.cos(a), math.sin(a), 0.0)
        points.append((0.25 * radial[0], 0.25 * radial[1], 0.05 * math.cos(3 * a)))
        frames.append((radial, (0.0, 0.0, 1.0)))
        radii.append(0.030 + 0.008 * math.cos(2 * a))
    # u x v points against the sweep for (radial, up); take (up, radial), which runs along it.
    return swept(points, [(v, u) for u, v in frames], radii, 10, closed=True)


def _pendants():
    fields = panels_with(on=False)
    for i, (x, y, count) in enumerate(office.ISLANDS, 1):
        length = count * office.PITCH - 0.5
        fields[f"Ribbon {i}"] = luminaire_fields(
            {"polygon": ribbon(length, 0.34, 0.22)}, [x, y, 2.05], round(2300 * length, -2), "Pendants", cct=3500)
    for k, (x, y) in enumerate([(2.6, 0.95), (5.0, 0.95), (7.4, 0.95), (11.0, 1.9)], 1):
        fields[f"Ring {k}"] = luminaire_fields(
            {"mesh": "ring.obj"}, [x, y, 2.1], 1800, "Rings", cct=3000, rotation=[0, 0, 30 * k])
    return fields


def _washers_and_task_lights():
    fields = panels_with(dimming=0.12)
    for k in range(6):
        fields[f"Washer {k + 1}"] = luminaire_fields(
            {"rectangle": [1.4, 0.08]}, [1.6 + 1.76 * k, 0.75, 2.74], 2600, "Wall washers", cct=3500,
            rotation=[-40, 0, 0])
    for k in range(3):
        fields[f"Washer {k + 7}"] = luminaire_fields(
            {"rectangle": [0.08, 1.4]}, [0.75, 2.4 + 1.8 * k, 2.74], 2600, "Wall washers", cct=3500,
            rotation=[0, 40, 0])
    for name, x, y, turn, _ in office.desk_places():
        # The lamp's head stands at (-0.36, 0) on the desk; the light is 4 mm under it.
        dx, dy = (0.0, 0.36) if turn == -90 else (0.0, -0.36)
        fields[f"Task light {name.split()[1]}"] = luminaire_fields(
            {"rectangle": [0.40, 0.05]}, [x + dx, y + dy, furniture.DESK_HEIGHT + 0.408], 420, "Task lights",
            cct=3000, rotation=[0, 0, 90])
    return fields


def light(project):
    """Adds luminaires and layouts; returns further files of the project, {name: Model}."""
    _panels(project)
    project.layout("Panels")
    project.layout("Pendants", luminaires=_pendants())
    project.layout("Wall washers and task lights", luminaires=_washers_and_task_lights())
    ring = Model()
    ring.add("Ring", "light", ring_mesh())
    return {"ring.obj": ring}
