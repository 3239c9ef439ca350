# SPDX-License-Identifier: MIT
"""An open-plan office, 12 x 8 x 2.8 m, 30 workstations in four islands, windows on the long side."""
import random

from . import furniture, joinery, office_lighting
from .model import Model
from .project import Project
from .shell import Shell
from .solids import box, chamfered_box, cylinder

SIZE = (12.0, 8.0, 2.8)
PITCH = 1.2  # a desk and its gap, along the island
ISLANDS = [(1.95, 4.2, 4), (4.85, 4.2, 4), (7.75, 4.2, 4), (10.4, 4.8, 3)]  # x, y of the middle, desks a side
WINDOWS = [1.7, 4.6, 7.4, 10.3]
WINDOW_SIZE, SILL, RECESS = (2.0, 1.45), 0.9, 0.24
DOOR_Y, DOOR_SIZE, DOOR_RECESS = 1.1, (1.0, 2.1), 0.08


def _shell():
    shell = Shell()
    shell.room((0, 0, 0), SIZE)
    shell.paint("wall")
    shell.paint("carpet", "-z", (0, 0, -0.1), (SIZE[0], SIZE[1], 0.1))
    shell.paint("ceiling", "+z", (0, 0, 2.7), SIZE)
    half, height = WINDOW_SIZE[0] / 2, WINDOW_SIZE[1]
    for x in WINDOWS:
        shell.room((x - half, SIZE[1], SILL), (x + half, SIZE[1] + RECESS, SILL + height))
    shell.paint("pane", "+y", (0, SIZE[1] + 0.1, 0), (SIZE[0], SIZE[1] + 1, SIZE[2]))
    y0, y1 = DOOR_Y - DOOR_SIZE[0] / 2, DOOR_Y + DOOR_SIZE[0] / 2
    shell.room((SIZE[0], y0, 0), (SIZE[0] + DOOR_RECESS, y1, DOOR_SIZE[1]))
    return shell


def _workstation(model, name, place, rng):
    """place: from the desk's frame to the room."""
    model.add_all(name, furniture.desk(), place)
    h = furniture.DESK_HEIGHT

    def put(pieces, x, y, z=h, turn=0.0):
        model.add_all(name, pieces, lambda part: place(part.turned(rz=turn).moved(x, y, z)))

    put(furniture.pedestal(), 0.30, -0.02, z=0.0)
    put(furniture.monitor(), -0.05, 0.16, turn=rng.uniform(-12, 12))
    put(furniture.keyboard(), -0.08, -0.12, turn=rng.uniform(-4, 4))
    put(furniture.mouse(), 0.24, -0.13, turn=rng.uniform(-20, 20))
    put(furniture.task_lamp(), -0.36, 0.0)
    if rng.random() < 0.55:
        put(furniture.paper_stack(), 0.43, -0.02, turn=rng.uniform(-15, 15))
    if rng.random() < 0.4:
        put(furniture.mug(), 0.40, -0.25)
    seat = furniture.chair()
    put(seat, rng.uniform(-0.06, 0.04), -0.62 + rng.uniform(-0.05, 0.03), z=0.0, turn=rng.uniform(-22, 22))


def desk_places():
    """(name, placement, island, x, y, turn) of each desk."""
    places = []
    for i, (x, y, count) in enumerate(ISLANDS, 1):
        for k in range(count):
            for side, turn in ((-1, -90), (1, 90)):
                px = x + side * (furniture.DESK_DEPTH / 2 + 0.02)
                py = y + (k - (count - 1) / 2) * PITCH
                places.append((f"Desk {len(places) + 1}", px, py, turn, i))
    return places


def _islands(model, rng):
    for name, x, y, turn, _ in desk_places():
        _workstation(model, name, lambda part, x=x, y=y, turn=turn: part.turned(rz=turn).moved(x, y), rng)
    for i, (x, y, count) in enumerate(ISLANDS, 1):
        half = count * PITCH / 2
        for k in range(count):
            y0 = y - half + k * PITCH + 0.01
            model.add(f"Screen {i}", "screen_fabric",
                      chamfered_box((x - 0.014, y0, 0.60), (x + 0.014, y0 + PITCH - 0.02, 1.12), 0.004))
        for side in (-1, 1) if count == 4 else (1,):  # the short island is open toward the entrance
            _partition(model, f"Partition {i}", x, y + side * (half + 0.06))


def _partition(model, name, x, y):
    """A free-standing wall across an island's end, 1.5 m wide and 1.35 m high, on two feet."""
    model.add(name, "screen_fabric", chamfered_box((x - 0.75, y - 0.02, 0.05), (x + 0.75, y + 0.02, 1.35), 0.005))
    for side in (-1, 1):
        foot = x + side * 0.6
        model.add(name, "steel", box((foot - 0.03, y - 0.08, 0.002), (foot + 0.03, y + 0.08, 0.024)))
        model.add(name, "steel", box((foot - 0.02, y - 0.012, 0.02), (foot + 0.02, y + 0.012, 0.07)))


def _walls(model):
    for k, x in enumerate(WINDOWS):
        blind = (0.25, 0.0, 0.55, 0.15)[k]
        model.add_all(f"Window {k + 1}", joinery.window(*WINDOW_SIZE, SILL, RECESS, blind),
                      joinery.on_wall("+y", x, SIZE[1]))
    model.add_all("Door", joinery.door(*DOOR_SIZE, DOOR_RECESS), joinery.on_wall("+x", SIZE[0], DOOR_Y))
    model.add_all("Whiteboard", joinery.board(2.4, 1.2, 0.95), joinery.on_wall("-x", 0.0, 4.2))
    model.add_all("Pin board", joinery.board(1.4, 1.0, 1.2, "cork", "desk_top"), joinery.on_wall("+x", SIZE[0], 5.4))
    model.add("Clock", "whiteboard", cylinder(0.16, 0.0, 0.035, 24).turned(ry=-90).moved(SIZE[0] + 0.002, 1.1, 2.40))
    for k in range(6):
        model.add_all(f"Sideboard {k + 1}", furniture.sideboard(1.2, 1.05, 2),
                      joinery.on_wall("-y", 1.9 + (k + 1) * 1.21, 0.0))
    for k in range(2):
        model.add_all(f"Cabinet {k + 1}", furniture.sideboard(0.9, 1.95, 2), joinery.on_wall("-y", 0.95 + k * 0.91, 0.0))


def _equipment(model, rng):
    for k, (x, y) in enumerate([(0.4, 7.55), (11.6, 7.55), (10.2, 0.42)]):
        model.add_all(f"Plant {k + 1}", furniture.plant(rng, height=1.5), lambda part, x=x, y=y: part.moved(x, y))
    copier = [("cabinet", chamfered_box((-0.32, -0.30, 0.03), (0.32, 0.30, 0.95), 0.01)),
              ("plastic", chamfered_box((-0.31, -0.29, 0.946), (0.31, 0.29, 1.08), 0.02)),
              ("plastic", box((-0.26, -0.27, 0.002), (0.26, 0.27, 0.034))),
              ("screen", box((0.05, -0.309, 0.86), (0.25, -0.298, 0.93)))]
    model.add_all("Copier", copier, lambda part: part.turned(rz=180).moved(9.75 - 0.45, 0.45))
    for k in range(5):
        x = 2.5 + 1.37 * k
        model.add_all(f"Archive box {k + 1}", [("cardboard", box((x, 0.08, 1.048), (x + 0.30, 0.33, 1.36)))])


def _materials(project):
    project.material("wall", 0.72)
    project.material("ceiling", 0.84)
    project.material("carpet", [0.16, 0.17, 0.19])
    project.material("pane", 0.04)
    project.material("window_frame", 0.62)
    project.material("sill", 0.66)
    project.material("blind", [0.66, 0.65, 0.61])
    project.material("door", [0.42, 0.30, 0.19])
    project.material("door_frame", 0.62)
    project.material("desk_top", [0.55, 0.46, 0.35])
    project.material("steel", 0.46)
    project.material("cabinet", [0.63, 0.63, 0.61])
    project.material("plastic", 0.06)
    project.material("key", 0.10)
    project.material("screen", 0.03)
    project.material("seat", [0.07, 0.13, 0.22])
    project.material("screen_fabric", [0.28, 0.36, 0.33])
    project.material("paper", 0.78)
    project.material("mug", [0.70, 0.16, 0.10])
    project.material("whiteboard", 0.80)
    project.material("cork", [0.40, 0.27, 0.16])
    project.material("cardboard", [0.42, 0.30, 0.18])
    project.material("pot", 0.55)
    project.material("soil", [0.06, 0.045, 0.035])
    project.material("leaf", [0.07, 0.20, 0.05])


def make():
    rng = random.Random(12)
    model, shell = Model(), _shell()
    for material, part in shell.parts().items():
        model.add("Room", material, part)
    _walls(model)
    _islands(model, rng)
    _equipment(model, rng)
    project = Project("Open-plan office", "office.obj", exposure=0.0, white_balance=4000)
    _materials(project)
    files = office_lighting.light(project)
    project.camera("Entrance", [11.75, 1.3, 1.7], [5.2, 4.4, 0.85], 56)
    project.camera("Window corner", [0.45, 7.0, 1.75], [7.5, 2.2, 0.75], 60)
    project.camera("Aisle", [3.35, 0.8, 1.6], [3.4, 6.0, 1.0], 60)
    project.camera("Workplace", [6.15, 3.3, 1.35], [8.0, 4.9, 0.95], 62)
    project.work_plane("Desks", [0.58, 0.52, 0.75], [11, 0, 0], [0, 7, 0], [22, 14], "office.writing")
    for i, (x, y, count) in enumerate(ISLANDS, 1):
        length = count * PITCH
        project.work_plane(f"Island {i}", [x - 0.72, y - length / 2, 0.75], [1.44, 0, 0], [0, length, 0],
                           [6, 4 * count], "office.writing")
    project.work_plane("Aisle", [0.8, 0.8, 0.05], [10.4, 0, 0], [0, 0.6, 0], [26, 3], "circulation")
    return {"project": project, "model": model, "shell": shell, "title": "Open-plan office", "files": files}
