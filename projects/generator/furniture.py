# SPDX-License-Identifier: MIT
"""Office furniture as lists of (material, Part).

Local frame: on the floor, the user looks toward +y. Pieces that touch sink 2 mm or more into each
other, so that no two faces coincide.
"""
from .solids import box, chamfered_box, cylinder, rounded_box, sphere

DESK_WIDTH, DESK_DEPTH, DESK_HEIGHT = 1.19, 0.70, 0.72


def desk():
    """Middle of the footprint at the origin, the user's edge at -y."""
    w, d, h = DESK_WIDTH / 2, DESK_DEPTH / 2, DESK_HEIGHT
    pieces = [("desk_top", chamfered_box((-w, -d, h - 0.025), (w, d, h), 0.004))]
    for side in (-1, 1):
        x = side * (w - 0.06)
        pieces += [
            ("steel", box((x - 0.03, -0.30, 0.002), (x + 0.03, 0.30, 0.032))),
            ("steel", box((x - 0.025, -0.04, 0.028), (x + 0.025, 0.04, h - 0.04))),
            ("steel", box((x - 0.02, -0.27, h - 0.05), (x + 0.02, 0.27, h - 0.022)))]
    pieces.append(("steel", box((-w + 0.07, 0.19, h - 0.30), (w - 0.07, 0.205, h - 0.055))))
    pieces.append(("steel", box((-w + 0.10, 0.22, h - 0.135), (w - 0.10, 0.30, h - 0.08))))
    return pieces


def pedestal():
    """Three drawers on a plinth, for under a desk; its middle at the origin, fronts at -y."""
    w, d = 0.20, 0.26
    pieces = [("steel", box((-w + 0.03, -d + 0.03, 0.002), (w - 0.03, d - 0.03, 0.05))),
              ("cabinet", box((-w, -d, 0.046), (w, d, 0.58)))]
    for z0, z1 in ((0.052, 0.300), (0.304, 0.436), (0.440, 0.574)):
        pieces.append(("cabinet", box((-w + 0.004, -d - 0.016, z0), (w - 0.004, -d + 0.002, z1))))
        pieces.append(("steel", box((-0.06, -d - 0.034, z1 - 0.05), (0.06, -d - 0.014, z1 - 0.04))))
    return pieces


def chair():
    """Its column at the origin; the backrest at -y."""
    pieces = [("plastic", cylinder(0.055, 0.052, 0.115, 8)), ("steel", cylinder(0.024, 0.11, 0.43, 8)),
              ("plastic", box((-0.11, -0.13, 0.405), (0.11, 0.11, 0.445)))]
    for k in range(5):
        arm = box((-0.02, 0.04, 0.062), (0.02, 0.285, 0.088))
        castor = box((-0.018, 0.248, 0.004), (0.018, 0.302, 0.068))
        for part in (arm, castor):
            pieces.append(("plastic", part.turned(rz=18 + 72 * k)))
    pieces.append(("seat", rounded_box((-0.24, -0.22, 0.44), (0.24, 0.24, 0.51), 0.03)))
    back = rounded_box((-0.22, -0.03, 0.0), (0.22, 0.03, 0.52), 0.028)
    back = back.mapped(lambda p: (p[0], p[1] + 0.35 * p[0] * p[0], p[2]))  # hollowed for the sitter
    pieces.append(("seat", back.turned(rx=10).moved(0.0, -0.235, 0.58)))
    pieces.append(("plastic", box((-0.03, -0.03, 0.0), (0.03, 0.0, 0.34)).turned(rx=8).moved(0, -0.235, 0.42)))
    pieces.append(("plastic", box((-0.028, -0.26, 0.425), (0.028, -0.10, 0.438))))
    for side in (-1, 1):
        x = side * 0.245
        pieces.append(("plastic", box((x - 0.035, -0.13, 0.66), (x + 0.035, 0.12, 0.685))))
        pieces.append(("plastic", box((x - 0.012, -0.03, 0.47), (x + 0.012, 0.03, 0.664))))
    return pieces


def monitor():
    """On a desk at z = 0, its middle at the origin, the screen faces -y."""
    return [("plastic", box((-0.11, -0.08, -0.002), (0.11, 0.09, 0.010))),
            ("plastic", box((-0.025, 0.028, 0.006), (0.025, 0.046, 0.30))),
            ("plastic", chamfered_box((-0.27, 0.0, 0.12), (0.27, 0.032, 0.46), 0.006)),
            ("screen", box((-0.262, -0.002, 0.130), (0.262, 0.004, 0.452)))]


def keyboard():
    return [("plastic", box((-0.22, -0.07, -0.002), (0.22, 0.07, 0.018))),
            ("key", box((-0.21, -0.06, 0.012), (0.21, 0.06, 0.024)))]


def mouse():
    return [("plastic", box((-0.03, -0.05, -0.002), (0.03, 0.05, 0.03)))]


def paper_stack():
    return [("paper", box((-0.105, -0.148, -0.002), (0.105, 0.148, 0.022)))]


def mug():
    return [("mug", cylinder(0.040, -0.002, 0.095, 10))]


def task_lamp():
    """A lamp's stand and head without its light; the head's middle stands at y = 0, z = 0.42."""
    return [("steel", box((-0.05, 0.17, -0.002), (0.05, 0.27, 0.016))),
            ("steel", box((-0.008, 0.212, 0.01), (0.008, 0.228, 0.436))),
            ("steel", box((-0.007, -0.01, 0.4225), (0.007, 0.215, 0.4335))),
            ("steel", box((-0.21, -0.035, 0.412), (0.21, 0.035, 0.4245)))]


def sideboard(width, height, doors):
    """Its back at y = 0 (sunk into the wall), fronts at -y, its left end at x = 0."""
    pieces = [("steel", box((0.02, -0.38, -0.002), (width - 0.02, 0.001, 0.06))),
              ("cabinet", box((0.002, -0.42, 0.055), (width - 0.002, 0.002, height - 0.02))),
              ("desk_top", chamfered_box((0.001, -0.43, height - 0.022), (width - 0.001, 0.003, height), 0.003))]
    step = width / doors
    for k in range(doors):
        x0, x1 = k * step + 0.006, (k + 1) * step - 0.004
        pieces.append(("cabinet", box((x0, -0.438, 0.06), (x1, -0.418, height - 0.026))))
        x = x1 - 0.05 if k % 2 == 0 else x0 + 0.04
        pieces.append(("steel", box((x, -0.456, height * 0.55), (x + 0.012, -0.436, height * 0.55 + 0.14))))
    return pieces


def plant(rng, height=1.1, leaves=30):
    """A pot with long leaves, thin closed spindles; stands on the floor."""
    pieces = [("pot", cylinder(0.13, 0.002, 0.32, 12, top_radius=0.18)),
              ("soil", cylinder(0.16, 0.30, 0.325, 12)),
              ("leaf", cylinder(0.012, 0.31, 0.31 + 0.6 * (height - 0.31), 6))]
    for k in range(leaves):
        turn = 137.508 * k
        at = 0.36 + (height - 0.45) * 0.75 * k / leaves
        pieces.append(("leaf", leaf(rng.uniform(0.24, 0.38), 0.045).turned(
            ry=-rng.uniform(25, 70)).turned(rz=turn + rng.uniform(-9, 9)).moved(z=at)))
    return pieces


def leaf(length, half_width):
    """A flat closed spindle along +x with a fold along its middle, 8 triangles."""
    part = sphere(1.0, 4, 2)
    return part.mapped(lambda p: (length * (0.5 + 0.5 * p[2]), half_width * p[1],
                                  -0.004 * p[0] - 0.25 * half_width * abs(p[1])))
