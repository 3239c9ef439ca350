# SPDX-License-Identifier: MIT
"""A sample's geometry: named objects of named materials, written as Wavefront OBJ and MTL."""
import math

from .vectors import cross, dot, length, sub, unit


class Model:
    def __init__(self):
        self.objects = []  # (name, material, Part)

    def add(self, name, material, part):
        self.objects.append((name, material, part))

    def add_all(self, name, pieces, place=lambda part: part):
        """pieces: (material, Part) of one thing, each put in its place."""
        for material, part in pieces:
            self.add(name, material, place(part))

    def triangle_count(self):
        return sum(len(part.triangles) for _, _, part in self.objects)

    def write(self, path, title, materials, mtl_name):
        """materials: {name: project material}, for the MTL file beside it."""
        with open(path, "w", encoding="ascii", newline="\n") as out:
            out.write(f"# {title}. Metres, z up. Made by projects/generate.py. CC0.\nmtllib {mtl_name}\n")
            _write_objects(out, self.objects)
        with open(path.with_name(mtl_name), "w", encoding="ascii", newline="\n") as out:
            for name in sorted({material for _, material, _ in self.objects}):
                out.write(f"newmtl {name}\nKd {' '.join(number(c) for c in materials[name]['diffuse'])}\n")
                if "diffuse_map" in materials[name]:
                    out.write(f"map_Kd {materials[name]['diffuse_map']}\n")


def number(value):
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def triple(point):
    return " ".join(number(c) for c in point)


class _Pool:
    """Lines that are written once and numbered from 1."""

    def __init__(self, out, keyword):
        self.out, self.keyword, self.numbers = out, keyword, {}

    def __call__(self, text):
        if text not in self.numbers:
            self.numbers[text] = len(self.numbers) + 1
            self.out.write(f"{self.keyword} {text}\n")
        return self.numbers[text]


def _write_objects(out, objects):
    normals, uvs = _Pool(out, "vn"), _Pool(out, "vt")
    base, last = 1, None
    for name, material, part in objects:
        if name != last:
            out.write(f"o {name.replace(' ', '_')}\n")
            last = name
        out.write(f"usemtl {material}\n")
        for vertex in part.vertices:
            out.write(f"v {triple(vertex)}\n")
        corner_normals = shading_normals(part)
        faces = []
        for t, triangle in enumerate(part.triangles):
            words = []
            for c, vertex in enumerate(triangle):
                uv = "" if part.uvs is None else uvs(f"{number(part.uvs[t][c][0])} {number(part.uvs[t][c][1])}")
                words.append(f"{base + vertex}/{uv}/{normals(triple(corner_normals[t][c]))}")
            faces.append(f"f {' '.join(words)}\n")
        out.writelines(faces)
        base += len(part.vertices)


def shading_normals(part):
    """Unit normals per triangle corner: faces round a vertex that meet at less than the crease
    angle are averaged by area."""
    areas = []
    for a, b, c in part.triangles:
        p = part.vertices[a]
        areas.append(cross(sub(part.vertices[b], p), sub(part.vertices[c], p)))
    flat = [unit(n) for n in areas]
    if part.crease_deg == 0.0:
        return [(n, n, n) for n in flat]
    around = {}
    for t, triangle in enumerate(part.triangles):
        for vertex in triangle:
            around.setdefault(vertex, []).append(t)
    limit = math.cos(math.radians(part.crease_deg))
    result = []
    for t, triangle in enumerate(part.triangles):
        corners = []
        for vertex in triangle:
            near = [areas[o] for o in around[vertex] if dot(flat[o], flat[t]) >= limit]
            total = tuple(sum(n[k] for n in near) for k in range(3))
            corners.append(unit(total) if length(total) > 0.0 else flat[t])
        result.append(corners)
    return result
