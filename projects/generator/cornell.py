# SPDX-License-Identifier: MIT
"""The Cornell box at the size of a room: the classic measurements divided by 200, metres.

The front is open, as in the original. x runs from the red wall to the green one as the camera
sees them, y into the box.
"""
from .model import Model
from .project import Project, luminaire_fields
from .shell import Shell
from .solids import prism

WIDTH, DEPTH, HEIGHT = 2.78, 2.796, 2.744
SUNK = -0.002  # blocks stand 2 mm in the floor, so that no two faces coincide

# Footprints of the published measurements (x mirrored, z as y), in units of the original.
SHORT_BLOCK = [(130, 65), (82, 225), (240, 272), (290, 114)]
TALL_BLOCK = [(423, 247), (265, 296), (314, 456), (472, 406)]


def _footprint(points):
    return [((556 - x) / 200, z / 200) for x, z in points]


def _geometry():
    shell = Shell()
    shell.room((0, 0, 0), (WIDTH, DEPTH, HEIGHT))
    shell.paint("white")
    shell.paint("red", "-x")
    shell.paint("green", "+x")
    shell.paint(None, "-y")
    model = Model()
    for material, part in shell.parts().items():
        model.add("Box", material, part)
    model.add("Short block", "block", _wound(SHORT_BLOCK, 0.825))
    model.add("Tall block", "block", _wound(TALL_BLOCK, 1.65))
    return model, shell


def _wound(points, height):
    outline = _footprint(points)
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, outline[1:] + outline[:1]))
    return prism(outline if area > 0 else outline[::-1], SUNK, height)


def make():
    model, shell = _geometry()
    project = Project("Cornell box", "cornell.obj", exposure=1.0)
    project.material("white", [0.74, 0.74, 0.72])
    project.material("red", [0.57, 0.05, 0.05])
    project.material("green", [0.11, 0.42, 0.09])
    project.material("block", [0.73, 0.73, 0.71])
    project.luminaire("Ceiling light", shape={"rectangle": [0.65, 0.525]},
                      position=[WIDTH / 2, 1.398, HEIGHT - 0.01], flux=2600, rgb=[1.0, 0.87, 0.70], group="Ceiling")
    project.layout("Classic")
    project.layout("Light moved", luminaires={
        "Ceiling light": {"position": [0.75, 0.8, 2.0], "rotation": [0, -25, 0]}})
    project.layout("Coloured", luminaires={
        "Ceiling light": {"dimming": 0.12},
        "Cool ball": luminaire_fields({"sphere": 0.12}, [2.25, 0.75, 2.1], 900, "Accent", rgb=[0.35, 0.6, 1.0]),
        "Warm tube": luminaire_fields({"tube": [1.2, 0.02]}, [0.12, 1.7, 1.5], 900, "Accent",
                                      rotation=[0, 0, 90], rgb=[1.0, 0.55, 0.2])})
    project.camera("Classic", [1.39, -4.0, 1.365], [1.39, 0.0, 1.365], 39.3)
    project.camera("Inside", [1.39, 0.08, 1.37], [1.39, 2.0, 1.1], 80)
    project.work_plane("Above the blocks", [0.0, 0.0, 1.7], [WIDTH, 0, 0], [0, DEPTH, 0], [14, 14], "paper")
    project.work_plane("Floor in front", [0.0, 0.0, 0.01], [WIDTH, 0, 0], [0, 0.3, 0], [28, 3], "paper")
    return {"project": project, "model": model, "shell": shell, "title": "Cornell box, room-sized",
            "open_edges": True}
