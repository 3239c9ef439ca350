# SPDX-License-Identifier: MIT
"""Doors, windows and what hangs on walls.

Local frame: on a wall, the room lies toward -y, x runs along the wall, the wall's face is y = 0.
Pieces sink 2 mm into the wall. `on_wall` puts them on one of a room's four walls.
"""
from .solids import box, chamfered_box, frame, prism, rod

TURN = {"+y": 0, "-x": 90, "-y": 180, "+x": -90}  # the side of the room on which the wall lies


def on_wall(side, x, y):
    """A placement: local origin at (x, y, 0) on the wall at this side of the room."""
    return lambda part: part.turned(rz=TURN[side]).moved(x, y)


def window(width, height, sill, recess, blind=0.0):
    """The fittings of a recess of this depth behind the wall; blind: the share that is lowered."""
    middle = sill + height / 2
    back = recess  # the pane's plane; the frame stands in front of it
    pieces = [("window_frame", frame(width + 0.004, height + 0.004, 0.06, 0.06).moved(
        y=back - 0.058, z=middle))]
    pieces.append(("window_frame", box((-0.025, back - 0.05, sill + 0.05),
                                       (0.025, back + 0.003, sill + height - 0.05))))
    pieces.append(("sill", chamfered_box((-width / 2 - 0.05, -0.06, sill - 0.028),
                                         (width / 2 + 0.05, 0.02, sill + 0.004), 0.004)))
    pieces.append(("window_frame", box((-0.09, back - 0.075, middle - 0.06), (-0.07, back - 0.055, middle + 0.06)).moved(
        x=0.10)))
    if blind > 0.0:
        bottom = sill + height - 0.08 - blind * (height - 0.12)
        pieces += [("blind", box((-width / 2 + 0.02, 0.05, sill + height - 0.09),
                                 (width / 2 - 0.02, 0.12, sill + height - 0.01))),
                   ("blind", box((-width / 2 + 0.03, 0.082, bottom), (width / 2 - 0.03, 0.086, sill + height - 0.08))),
                   ("steel", box((-width / 2 + 0.028, 0.078, bottom - 0.02), (width / 2 - 0.028, 0.090, bottom + 0.004)))]
    return pieces


def door(width, height, recess):
    """Lining, leaf and handle for a recess whose back is the wall behind the leaf."""
    w = width / 2
    outline = [(-w - 0.07, -0.002), (-w + 0.02, -0.002), (-w + 0.02, height - 0.02), (w - 0.02, height - 0.02),
               (w - 0.02, -0.002), (w + 0.07, -0.002), (w + 0.07, height + 0.07), (-w - 0.07, height + 0.07)]
    lining = prism(outline, 0.0, recess + 0.024).turned(rx=90).moved(y=recess + 0.004)
    leaf = box((-w + 0.018, recess - 0.035, 0.006), (w - 0.018, recess + 0.002, height - 0.018))
    return [("door_frame", lining), ("door", leaf)] + handle(w - 0.09, recess - 0.035)


def architrave(width, height):
    """The frame round an open doorway on one side of its wall."""
    w = width / 2
    outline = [(-w - 0.07, -0.002), (-w - 0.002, -0.002), (-w - 0.002, height + 0.002), (w + 0.002, height + 0.002),
               (w + 0.002, -0.002), (w + 0.07, -0.002), (w + 0.07, height + 0.07), (-w - 0.07, height + 0.07)]
    return [("door_frame", prism(outline, 0.0, 0.014).turned(rx=90).moved(y=0.002))]


def double_door(width, height, recess):
    """Two leaves with bar handles in a recess, closed."""
    pieces = []
    for side in (-1, 1):
        inner, outer = sorted((side * 0.003, side * (width / 2 + 0.002)))
        pieces.append(("door", box((inner, recess - 0.05, 0.006), (outer, recess + 0.003, height + 0.002))))
        x = side * 0.09
        pieces.append(("steel", box((x - 0.012, recess - 0.11, 0.85), (x + 0.012, recess - 0.09, 1.55))))
        for z in (0.95, 1.45):
            pieces.append(("steel", box((x - 0.008, recess - 0.095, z - 0.008), (x + 0.008, recess - 0.048, z + 0.008))))
    return pieces


def handle(x, y):
    """A lever handle on a leaf whose face is at y."""
    return [("steel", box((x - 0.02, y - 0.008, 0.95), (x + 0.02, y + 0.002, 1.15))),
            ("steel", rod((x, y - 0.045, 1.06), (x, y - 0.004, 1.06), 0.007, 6)),
            ("steel", rod((x + 0.008, y - 0.046, 1.06), (x - 0.12, y - 0.046, 1.06), 0.009, 6))]


def board(width, height, bottom, face="whiteboard", edge="steel"):
    """A framed board."""
    middle = bottom + height / 2
    return [(edge, frame(width, height, 0.02, 0.027).moved(y=-0.025, z=middle)),
            (face, box((-width / 2 + 0.015, -0.015, bottom + 0.015), (width / 2 - 0.015, 0.0015, bottom + height - 0.015)))]


def baseboard(length, height=0.06, thickness=0.012):
    """From x = 0 along the wall."""
    return [("baseboard", box((0.0, -thickness, -0.002), (length, 0.002, height)))]
