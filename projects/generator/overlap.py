# SPDX-License-Identifier: MIT
"""Faces of different solids that lie in one plane and overlap."""
from .vectors import cross, dot, length, sub, unit

APART = 0.0004  # metres between planes that count as one
TOUCH = 1e-5    # metres by which faces must overlap


def coincident_faces(solids):
    planes = {}
    for s, solid in enumerate(solids):
        for a, b, c in solid.triangles:
            n = cross(sub(b, a), sub(c, a))
            if length(n) < 1e-12:
                continue
            n = unit(n)
            if next(x for x in n[::-1] if abs(x) > 1e-6) < 0.0:
                n = (-n[0], -n[1], -n[2])
            key = tuple(round(x, 3) + 0.0 for x in n)
            planes.setdefault(key, []).append((dot(n, a), s, (a, b, c)))
    faults = set()
    for normal, faces in planes.items():
        u = unit(cross(normal, (1.0, 0.0, 0.0) if abs(normal[0]) < 0.9 else (0.0, 1.0, 0.0)))
        v = cross(normal, u)
        flat = sorted(((d, s, [(dot(p, u), dot(p, v)) for p in t], t[0]) for d, s, t in faces),
                      key=lambda face: face[0])
        for group in _runs(flat):
            faults |= {tuple(sorted((solids[i].label, solids[j].label))) + (tuple(round(x, 2) for x in where),)
                       for i, j, where in _overlaps(group)}
    return [f"faces of {a} and {b} coincide near {where}" for a, b, where in sorted(faults)]


def _runs(faces):
    """Groups of faces whose planes are less than APART from the next."""
    group = []
    for face in faces:
        if group and face[0] - group[-1][0] > APART:
            yield group
            group = []
        group.append(face)
    if group:
        yield group


def _overlaps(group):
    if len({s for _, s, _, _ in group}) < 2:
        return
    boxed = sorted((min(p[0] for p in t), max(p[0] for p in t), min(p[1] for p in t), max(p[1] for p in t), s, t,
                    corner) for _, s, t, corner in group)
    active = []
    for face in boxed:
        active = [other for other in active if other[1] > face[0] + TOUCH]
        for other in active:
            if (other[4] != face[4] and other[2] < face[3] - TOUCH and face[2] < other[3] - TOUCH
                    and _intersect(other[5], face[5])):
                yield other[4], face[4], face[6]
        active.append(face)


def _intersect(p, q):
    """Whether two triangles in the plane overlap by more than TOUCH (separating axes)."""
    for t in (p, q):
        for k in range(3):
            ax, ay = t[k]
            bx, by = t[(k + 1) % 3]
            nx, ny = by - ay, ax - bx
            norm = (nx * nx + ny * ny) ** 0.5
            sp = [(x * nx + y * ny) / norm for x, y in p]
            sq = [(x * nx + y * ny) / norm for x, y in q]
            if max(sp) < min(sq) + TOUCH or max(sq) < min(sp) + TOUCH:
                return False
    return True
