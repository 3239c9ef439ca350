# SPDX-License-Identifier: MIT
"""Closed solids, wound outward: what furniture is made of.

Every function returns a Part whose edges are each used twice, once in either direction.
"""
import math
from itertools import product

from .vectors import add, cross, dot, length, rotated, scaled, sub, unit


class Part:
    """Triangles over shared vertices.

    crease_deg  faces that meet at less than this angle share a shading normal; 0 is flat
    uvs         texture coordinates per triangle corner, or None
    """

    def __init__(self, vertices, triangles, crease_deg=0.0, uvs=None):
        self.vertices = vertices
        self.triangles = triangles
        self.crease_deg = crease_deg
        self.uvs = uvs

    def moved(self, x=0.0, y=0.0, z=0.0):
        return self.mapped(lambda p: add(p, (x, y, z)))

    def turned(self, rx=0.0, ry=0.0, rz=0.0):
        return self.mapped(lambda p: rotated(p, rx, ry, rz))

    def mapped(self, function):
        """The part with each vertex moved; `function` must keep the orientation."""
        return Part([function(p) for p in self.vertices], self.triangles, self.crease_deg, self.uvs)


def _convex(vertices, faces, crease_deg=0.0):
    """A convex solid from faces (vertex indices in either sense), wound away from its middle."""
    middle = scaled((sum(v[0] for v in vertices), sum(v[1] for v in vertices),
                     sum(v[2] for v in vertices)), 1.0 / len(vertices))
    triangles = []
    for face in faces:
        a, b, c = (vertices[i] for i in face[:3])
        if dot(cross(sub(b, a), sub(c, a)), sub(a, middle)) < 0.0:
            face = face[::-1]
        triangles += [(face[0], face[k], face[k + 1]) for k in range(1, len(face) - 1)]
    return Part(vertices, triangles, crease_deg)


def box(low, high):
    """An axis-parallel box, 12 triangles."""
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1])
               for x in (low[0], high[0])]
    return _convex(corners, [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6),
                             (0, 2, 6, 4), (1, 3, 7, 5)])


def chamfered_box(low, high, chamfer=0.004):
    """A box with its edges cut off at 45 degrees, 44 triangles."""
    index, vertices = {}, []
    for corner in product((0, 1), repeat=3):
        for axis in range(3):
            point = []
            for k in range(3):
                inset = 0.0 if k == axis else chamfer
                point.append(high[k] - inset if corner[k] else low[k] + inset)
            index[corner, axis] = len(vertices)
            vertices.append(tuple(point))
    faces = [[index[corner, axis] for axis in range(3)] for corner in product((0, 1), repeat=3)]
    for axis, side in product(range(3), (0, 1)):
        j, k = (axis + 1) % 3, (axis + 2) % 3
        ring = []
        for cj, ck in ((0, 0), (1, 0), (1, 1), (0, 1)):
            corner = [side] * 3
            corner[j], corner[k] = cj, ck
            ring.append(index[tuple(corner), axis])
        faces.append(ring)
    for axis in range(3):  # the edges along `axis`
        j, k = (axis + 1) % 3, (axis + 2) % 3
        for cj, ck in product((0, 1), repeat=2):
            ends = []
            for end in (0, 1):
                corner = [end] * 3
                corner[j], corner[k] = cj, ck
                ends.append(tuple(corner))
            faces.append([index[ends[0], j], index[ends[1], j], index[ends[1], k], index[ends[0], k]])
    return _convex(vertices, faces)


def rounded_box(low, high, radius, segments=1):
    """A box with round edges: every quarter circle has 2 * segments facets (108 triangles for 1)."""
    half = [(high[k] - low[k]) / 2 for k in range(3)]
    middle = tuple((high[k] + low[k]) / 2 for k in range(3))
    steps = [math.tan(math.pi / 4 * i / segments) for i in range(segments + 1)]
    breaks = []
    for h in half:
        flat = h - radius
        breaks.append([-flat - radius * s for s in reversed(steps)] + [flat + radius * s for s in steps])

    def on_surface(p):
        core = tuple(max(-(half[k] - radius), min(half[k] - radius, p[k])) for k in range(3))
        return add(add(core, scaled(unit(sub(p, core)), radius)), middle)

    index, vertices, triangles = {}, [], []

    def vertex(key):
        if key not in index:
            index[key] = len(vertices)
            vertices.append(on_surface(tuple(breaks[k][key[k]] for k in range(3))))
        return index[key]

    last = 2 * segments + 1
    for axis, side in product(range(3), (0, last)):
        j, k = (axis + 1) % 3, (axis + 2) % 3
        for a, b in product(range(last), repeat=2):
            ring = []
            for da, db in ((0, 0), (1, 0), (1, 1), (0, 1)):
                key = [side] * 3
                key[j], key[k] = a + da, b + db
                ring.append(vertex(tuple(key)))
            if side == 0:
                ring.reverse()
            triangles += [(ring[0], ring[1], ring[2]), (ring[0], ring[2], ring[3])]
    return Part(vertices, triangles, crease_deg=50.0)


def lathe(profile, sides, crease_deg=40.0):
    """A solid of revolution about z. profile: (radius, z) from the lower to the upper end on the
    axis; both ends have radius 0, all others more."""
    rings, vertices, triangles = [], [], []
    for radius, z in profile:
        if radius == 0.0:
            rings.append([len(vertices)] * sides)
            vertices.append((0.0, 0.0, z))
        else:
            rings.append(list(range(len(vertices), len(vertices) + sides)))
            vertices += [(radius * math.cos(2 * math.pi * i / sides),
                          radius * math.sin(2 * math.pi * i / sides), z) for i in range(sides)]
    for lower, upper in zip(rings, rings[1:]):
        for i in range(sides):
            j = (i + 1) % sides
            if lower[i] != lower[j]:
                triangles.append((lower[i], lower[j], upper[j]))
            if upper[i] != upper[j]:
                triangles.append((lower[i], upper[j], upper[i]))
    return Part(vertices, triangles, crease_deg)


def cylinder(radius, z0, z1, sides=12, top_radius=None):
    """A cylinder or frustum along z, 4 * sides - 4 triangles."""
    top = radius if top_radius is None else top_radius
    ring = [(math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides))
            for i in range(sides)]
    vertices = [(radius * c, radius * s, z0) for c, s in ring] + [(top * c, top * s, z1) for c, s in ring]
    triangles = []
    for i in range(sides):
        j = (i + 1) % sides
        triangles += [(i, j, sides + j), (i, sides + j, sides + i)]
    for i in range(1, sides - 1):
        triangles += [(0, i + 1, i), (sides, sides + i, sides + i + 1)]
    return Part(vertices, triangles, crease_deg=50.0)


def rod(start, end, radius, sides=8):
    """A cylinder from point to point."""
    axis = sub(end, start)
    tilt = math.degrees(math.acos(axis[2] / length(axis)))
    turn = math.degrees(math.atan2(axis[1], axis[0])) if abs(axis[0]) + abs(axis[1]) > 1e-9 else 0.0
    return cylinder(radius, 0.0, length(axis), sides).turned(ry=tilt, rz=turn).moved(*start)


def sphere(radius, sides=16, bands=8):
    profile = [(0.0 if i in (0, bands) else radius * math.sin(math.pi * i / bands),
                -radius * math.cos(math.pi * i / bands)) for i in range(bands + 1)]
    return lathe(profile, sides, crease_deg=80.0)


def prism(outline, z0, z1, crease_deg=0.0):
    """A simple polygon in x, y (counter-clockwise) raised from z0 to z1."""
    n = len(outline)
    vertices = [(x, y, z0) for x, y in outline] + [(x, y, z1) for x, y in outline]
    triangles = []
    for a, b, c in ear_clipped(outline):
        triangles += [(a, c, b), (n + a, n + b, n + c)]
    for i in range(n):
        j = (i + 1) % n
        triangles += [(i, j, n + j), (i, n + j, n + i)]
    return Part(vertices, triangles, crease_deg)


def ear_clipped(outline):
    """Triangles (indices) of a simple counter-clockwise polygon."""
    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    left, triangles = list(range(len(outline))), []
    while len(left) > 3:
        for k in range(len(left)):
            i, j, m = left[k - 1], left[k], left[(k + 1) % len(left)]
            a, b, c = outline[i], outline[j], outline[m]
            others = (outline[o] for o in left if o not in (i, j, m))
            if turn(a, b, c) > 1e-12 and not any(
                    turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0 for p in others):
                triangles.append((i, j, m))
                del left[k]
                break
        else:
            raise ValueError("the outline crosses itself")
    return triangles + [tuple(left)]


def frame(width, height, border, depth):
    """A rectangular frame in the xz plane round the origin, from y = 0 to y = depth, 32 triangles."""
    def ring(w, h, y):
        return [(-w, y, -h), (w, y, -h), (w, y, h), (-w, y, h)]

    w, h = width / 2, height / 2
    vertices = (ring(w, h, 0.0) + ring(w - border, h - border, 0.0) +
                ring(w - border, h - border, depth) + ring(w, h, depth))
    triangles = []
    for band in range(4):  # outer front, inner front, inner back, outer back, and round again
        for i in range(4):
            a, b = 4 * band + i, 4 * band + (i + 1) % 4
            c, d = (b + 4) % 16, (a + 4) % 16
            triangles += [(a, b, c), (a, c, d)]
    return Part(vertices, triangles)


def swept(points, frames, radii, sides, closed=False, crease_deg=60.0):
    """A tube round a curve. frames: (u, v) unit vectors across the curve at each point with u x v
    along it; radii: per point. Open ends are capped."""
    count, vertices, triangles = len(points), [], []
    for point, (u, v), radius in zip(points, frames, radii):
        for i in range(sides):
            angle = 2 * math.pi * i / sides
            vertices.append(add(point, add(scaled(u, radius * math.cos(angle)),
                                           scaled(v, radius * math.sin(angle)))))
    for k in range(count if closed else count - 1):
        a, b = k * sides, ((k + 1) % count) * sides
        for i in range(sides):
            j = (i + 1) % sides
            triangles += [(a + i, a + j, b + j), (a + i, b + j, b + i)]
    if not closed:
        end = (count - 1) * sides
        for i in range(1, sides - 1):
            triangles += [(0, i + 1, i), (end, end + i, end + i + 1)]
    return Part(vertices, triangles, crease_deg)


def textured(part, u_axis, v_axis):
    """The part with texture coordinates that run from 0 to 1 over its extent along two axes."""
    low = [min(p[k] for p in part.vertices) for k in range(3)]
    high = [max(p[k] for p in part.vertices) for k in range(3)]
    uvs = [tuple((p[k] - low[k]) / (high[k] - low[k]) for k in (u_axis, v_axis)) for p in part.vertices]
    return Part(part.vertices, part.triangles, part.crease_deg,
                [tuple(uvs[i] for i in triangle) for triangle in part.triangles])
