# SPDX-License-Identifier: MIT
"""Checks of the samples as they lie on disk.

- each is what the generator makes today;
- every solid is closed and wound outward, every room closed and wound inward;
- no triangle is degenerate and no two faces of different solids coincide (they would flicker);
- materials and textures exist; what a layout names exists or is complete;
- luminaires, cameras and calculation points are in the room's air and not inside a solid.
"""
import json
import math
import tempfile
from pathlib import Path

from . import lamp_points, overlap
from .images import png_pixels
from .vectors import add, cross, dot, length, sub

MEGABYTES = 20.0


def check(name, sample, root):
    folder = root / name
    project = json.loads((folder / f"{name}.soffit").read_text(encoding="utf-8"))
    solids = read_components(folder / f"{name}.obj")
    rooms = [s for s in solids if s.volume < 0.0 or not s.closed()]
    furniture = [s for s in solids if s.volume > 0.0 and s.closed()]
    faults = []
    faults += _matches_generator(name, sample, folder)
    faults += _rooms(rooms, sample.get("open_edges", False))
    faults += [f"degenerate triangle in {s.label}" for s in solids if s.degenerate()]
    faults += overlap.coincident_faces(solids)
    faults += _names(project, folder, solids)
    places = Places(sample["shell"], furniture)
    faults += _points(project, places, folder)
    size = sum(f.stat().st_size for f in root.rglob("*") if f.is_file()) / 1e6
    if size > MEGABYTES:
        faults.append(f"projects/ is {size:.1f} MB, at most {MEGABYTES:.0f} are allowed")
    return [f"{name}: {fault}" for fault in faults]


class Component:
    """Triangles joined by edges."""

    def __init__(self, label, triangles):
        self.label, self.triangles = label, triangles
        points = [p for t in triangles for p in t]
        self.low = tuple(min(p[k] for p in points) for k in range(3))
        self.high = tuple(max(p[k] for p in points) for k in range(3))
        self.volume = sum(dot(a, cross(b, c)) for a, b, c in triangles) / 6.0

    def closed(self):
        edges = {}
        for a, b, c in self.triangles:
            for edge in ((a, b), (b, c), (c, a)):
                edges[edge] = edges.get(edge, 0) + 1
        return all(count == 1 and edges.get((b, a)) == 1 for (a, b), count in edges.items())

    def degenerate(self):
        return any(length(cross(sub(b, a), sub(c, a))) < 1e-8 for a, b, c in self.triangles)

    def contains(self, p):
        if any(not self.low[k] < p[k] < self.high[k] for k in range(3)):
            return False
        direction = (0.1234567, 0.0765432, 0.9893521)
        return sum(_crosses(p, direction, t) for t in self.triangles) % 2 == 1


def _crosses(p, d, triangle):
    a, b, c = triangle
    e, f = sub(b, a), sub(c, a)
    h = cross(d, f)
    det = dot(e, h)
    if abs(det) < 1e-14:
        return False
    s = sub(p, a)
    u = dot(s, h) / det
    q = cross(s, e)
    v = dot(d, q) / det
    return u >= 0 and v >= 0 and u + v <= 1 and dot(f, q) / det > 0


def read_components(path):
    vertices, faces, label = [], [], ""
    for line in path.read_text(encoding="ascii").splitlines():
        words = line.split()
        if words[:1] == ["o"]:
            label = words[1]
        elif words[:1] == ["v"]:
            vertices.append(tuple(float(w) for w in words[1:4]))
        elif words[:1] == ["f"]:
            faces.append((label, tuple(vertices[int(w.split("/")[0]) - 1] for w in words[1:4])))
    parent = list(range(len(faces)))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    owner = {}
    for i, (_, (a, b, c)) in enumerate(faces):
        for edge in ((a, b), (b, c), (c, a)):
            key = min(edge, edge[::-1])
            parent[root(i)] = root(owner.setdefault(key, i))
    groups = {}
    for i, face in enumerate(faces):
        groups.setdefault(root(i), []).append(face)
    return [Component(group[0][0], [t for _, t in group]) for group in groups.values()]


class Places:
    CELL = 0.4  # metres; solids are listed by the cells of the plan that they touch

    def __init__(self, shell, furniture):
        self.shell, self.near = shell, {}
        for solid in furniture:
            for i in range(self._cell(solid.low[0]), self._cell(solid.high[0]) + 1):
                for j in range(self._cell(solid.low[1]), self._cell(solid.high[1]) + 1):
                    self.near.setdefault((i, j), []).append(solid)

    def _cell(self, x):
        return math.floor(x / self.CELL)

    def fault(self, p):
        """Why p is not a good place, or None."""
        if not self.shell.contains(p):
            return "is outside the room"
        solids = self.near.get((self._cell(p[0]), self._cell(p[1])), [])
        inside = next((s.label for s in solids if s.contains(p)), None)
        return f"is inside {inside}" if inside else None


def _matches_generator(name, sample, folder):
    import generate
    with tempfile.TemporaryDirectory() as scratch:
        generate.write(name, sample, Path(scratch))
        made = {f.name: f.read_bytes() for f in Path(scratch).iterdir()}
    found = {f.name: f.read_bytes() for f in folder.iterdir() if f.name != "README.md"}
    faults = [f"{file} is not made by the generator" for file in found.keys() - made.keys()]
    faults += [f"{file} is missing; run projects/generate.py" for file in made.keys() - found.keys()]
    for file in sorted(made.keys() & found.keys()):
        same = (png_pixels(made[file]) == png_pixels(found[file]) if file.endswith(".png")
                else made[file] == found[file])
        if not same:
            faults.append(f"{file} differs from what the generator makes; run projects/generate.py")
    return faults


def _rooms(rooms, may_be_open):
    faults = []
    for room in rooms:
        if not room.closed() and not may_be_open:
            faults.append(f"{room.label} is not closed, or shares an edge with another solid")
    if len(rooms) != 1:
        faults.append(f"one room shell was expected, found {[r.label for r in rooms]}")
    return faults


def _names(project, folder, solids):
    faults = []
    text = (folder / project["geometry"][0]["file"]).read_text(encoding="ascii")
    used = {line.split()[1] for line in text.splitlines() if line.startswith("usemtl")}
    faults += [f"material {m} is not in the project" for m in used - project["materials"].keys()]
    faults += [f"material {m} is not used" for m in project["materials"].keys() - used]
    for name, material in project["materials"].items():
        if any(not 0.0 <= c <= 0.9 for c in material["diffuse"]) and "diffuse_map" not in material:
            faults.append(f"material {name}: no such surface is that bright")
        for key in ("diffuse_map", "normal_map"):
            if key in material and not (folder / material[key]).is_file():
                faults.append(f"material {name}: {material[key]} is missing")
    base = {l["name"] for l in project["luminaires"]}
    if len(project["layouts"]) < 3:
        faults.append("fewer than three layouts")
    for layout in project["layouts"]:
        for name, fields in layout.get("luminaires", {}).items():
            if name not in base and not {"shape", "position", "flux"} <= fields.keys():
                faults.append(f"layout {layout['name']}: {name} is neither in the base nor complete")
    if not solids:
        faults.append("no geometry")
    return faults


def _points(project, places, folder):
    faults = []
    for camera in project["cameras"]:
        if "Classic" not in camera["name"] and (why := places.fault(camera["position"])):
            faults.append(f"camera {camera['name']} {why}")
    for plane in project["work_planes"]:
        nu, nv = plane["grid"]
        for i in range(nu):
            for j in range(nv):
                p = add(plane["origin"], [plane["u"][k] * (i + 0.5) / nu + plane["v"][k] * (j + 0.5) / nv
                                          for k in range(3)])
                if why := places.fault(p):
                    faults.append(f"work plane {plane['name']}: point {[round(c, 3) for c in p]} {why}")
    base = {l["name"]: l for l in project["luminaires"]}
    for layout in project["layouts"]:
        lit = {name: dict(fields) for name, fields in base.items()}
        for name, edits in layout.get("luminaires", {}).items():
            lit.setdefault(name, {}).update(edits)
        for name, fields in lit.items():
            for p in lamp_points.points(fields, folder) if fields["on"] else []:
                if why := places.fault(p):
                    faults.append(f"layout {layout['name']}: {name} at {[round(c, 3) for c in p]} {why}")
                    break
    return faults
