# SPDX-License-Identifier: MIT
"""A flat of two furnished rooms joined by a doorway: living room 5.2 x 4.2 m, bedroom 3.8 x 4.2 m."""
import random

from . import flat_lighting, furniture, home, joinery, paintings
from .model import Model
from .project import Project
from .shell import Shell
from .solids import box, frame

LIVING, BEDROOM, HEIGHT = (0.0, 5.2), (5.32, 9.12), 2.6
DEPTH = 4.2
DOORWAY = (1.3, 2.2, 2.05)  # y from, y to, height
ENTRANCE_X, DOOR_SIZE, DOOR_RECESS = 2.75, (0.92, 2.05), 0.07
WINDOWS = [(2.9, 2.2, 0.25, 2.0), (7.3, 1.5, 0.90, 1.35)]  # x of the middle, width, sill, height
RECESS = 0.26
TABLE = (4.5, 0.58)  # the dining table; flat_lighting hangs its pendant above


def _shell():
    shell = Shell()
    for x0, x1 in (LIVING, BEDROOM):
        shell.room((x0, 0, 0), (x1, DEPTH, HEIGHT))
    shell.room((LIVING[1], DOORWAY[0], 0), (BEDROOM[0], DOORWAY[1], DOORWAY[2]))
    for x, width, sill, height in WINDOWS:
        shell.room((x - width / 2, DEPTH, sill), (x + width / 2, DEPTH + RECESS, sill + height))
    half = DOOR_SIZE[0] / 2
    shell.room((ENTRANCE_X - half, -DOOR_RECESS, 0), (ENTRANCE_X + half, 0, DOOR_SIZE[1]))
    shell.paint("wall")
    shell.paint("wall_bedroom", low=(BEDROOM[0] - 0.01, -1, 0), high=(BEDROOM[1], DEPTH + 0.01, HEIGHT))
    shell.paint("oak_floor", "-z", (-1, -1, -0.1), (10, DEPTH, 0.1))
    shell.paint("ceiling", "+z", (0, 0, 2.5), (10, DEPTH, 3))
    shell.paint("pane", "+y", (0, DEPTH + 0.1, 0), (10, DEPTH + 1, HEIGHT))
    return shell


def _put(model, name, pieces, x, y, z=0.0, turn=0.0):
    model.add_all(name, pieces, lambda part: part.turned(rz=turn).moved(x, y, z))


def _doors_and_windows(model):
    for k, (x, width, sill, height) in enumerate(WINDOWS, 1):
        place = joinery.on_wall("+y", x, DEPTH)
        model.add_all(f"Window {k}", joinery.window(width, height, sill, RECESS), place)
        span = width + 0.9
        model.add_all(f"Curtain rail {k}", home.curtain_rail(span + 0.1, 2.42), place)
        for side in (-1, 1):
            model.add_all(f"Curtain {k}", home.curtain(0.62, 0.03, 2.415),
                          lambda part, s=side: part.moved(x + s * (span / 2 - 0.31), DEPTH))
    model.add_all("Entrance door", joinery.door(*DOOR_SIZE, DOOR_RECESS), joinery.on_wall("-y", ENTRANCE_X, 0.0))
    y0, y1, top = DOORWAY
    for x, out in ((LIVING[1], -1), (BEDROOM[0], 1)):  # architraves on either side, 1 cm thick
        lining = joinery.architrave(y1 - y0, top)
        turn = 90 if out > 0 else -90
        _put(model, "Doorway", lining, x, (y0 + y1) / 2, turn=turn)
    leaf = [("door", box((0.0, 0.0, 0.008), (0.86, 0.04, 2.03)))] + [
        (m, p) for m, p in joinery.handle(0.78, 0.0)]
    _put(model, "Door leaf", leaf, BEDROOM[0] + 0.035, y0 - 0.03, turn=-68)


def _living_room(model, rng):
    _put(model, "Rug", home.rug(2.3, 1.7), 2.05, 2.95, turn=0)
    _put(model, "Sofa", home.sofa(2.1, 3), 0.03, 2.85, turn=90)
    for y, turn, material in ((2.05, 60, "cushion_green"), (3.62, 118, "cushion_ochre")):
        model.add_all("Cushion", home.cushion(material), lambda part, y=y, turn=turn: part.turned(rx=-22).turned(rz=turn).moved(0.62, y, 0.64))
    _put(model, "Armchair", home.sofa(0.86, 1), 1.85, 1.25, turn=158)
    _put(model, "Coffee table", home.low_table(1.0, 0.6, 0.40), 1.85, 2.9, z=0.010, turn=90)
    _put(model, "Vase", home.vase(0.26, 0.07), 1.80, 3.12, z=0.41)
    _put(model, "Magazines", [("book_cream", box((-0.11, -0.15, -0.002), (0.11, 0.15, 0.018))),
                              ("book_blue", box((-0.10, -0.14, 0.016), (0.09, 0.13, 0.030)))], 1.88, 2.66, z=0.41, turn=17)
    _put(model, "Television board", home.drawers(1.4, 0.48, 1), LIVING[1], 3.02, turn=-90)
    _put(model, "Television", home.television(1.25), LIVING[1] - 0.22, 3.02, z=0.48, turn=-90)
    _put(model, "Bookcase", home.bookcase(1.7, 2.0, 5, rng), 1.0, 0.0, turn=180)
    _put(model, "Dining table", home.round_table(0.48, 0.74), *TABLE)
    for k, (x, y, turn) in enumerate([(3.86, 0.50, 85), (4.40, 1.12, 10)], 1):
        _put(model, f"Dining chair {k}", home.dining_chair(), x, y, turn=turn)
    _put(model, "Fruit bowl", [("ceramic", home.bowl())], *TABLE, z=0.74)
    _put(model, "Floor lamp", home.floor_lamp(1.38), 0.42, 1.55)
    model.add_all("Plant", furniture.plant(rng, height=1.4), lambda part: part.moved(4.96, 3.97))
    for k, (y, width, height) in enumerate([(2.45, 0.6, 0.8), (3.25, 0.6, 0.8)], 1):
        model.add_all(f"Print {k}", _print(width, height, 1.55, f"print_{k}"), joinery.on_wall("-x", 0.0, y))


def _print(width, height, middle, material):
    return [("black", frame(width, height, 0.02, 0.027).moved(y=-0.025, z=middle)),
            (material, box((-width / 2 + 0.015, -0.012, middle - height / 2 + 0.015),
                           (width / 2 - 0.015, 0.0015, middle + height / 2 - 0.015)))]


def _bedroom(model):
    head = BEDROOM[1]
    _put(model, "Bed", home.bed(1.6, 2.0), head, 2.35, turn=-90)
    for k, y in enumerate((1.24, 3.46), 1):
        _put(model, f"Bedside table {k}", home.bedside_table(), head, y, turn=-90)
        _put(model, f"Bedside lamp {k}", home.table_lamp(0.22), head - 0.2, y, z=0.46)
    _put(model, "Wardrobe", home.wardrobe(2.0, 2.25, 3), 7.7, 0.0, turn=180)
    _put(model, "Chest of drawers", home.drawers(1.1, 0.82, 3), BEDROOM[0], 3.05, turn=90)
    _put(model, "Mirror", [("oak", frame(0.6, 0.9, 0.03, 0.032).moved(y=-0.03, z=1.45)),
                           ("mirror", box((-0.28, -0.012, 1.02), (0.28, 0.0015, 1.88)))], BEDROOM[0], 3.05, turn=90)
    _put(model, "Bedroom vase", home.vase(0.32, 0.08), BEDROOM[0] + 0.2, 3.36, z=0.82)
    _put(model, "Bedside rug", [("rug_plain", box((-0.5, -0.35, -0.002), (0.5, 0.35, 0.012)))], 6.5, 2.3)


def _materials(project):
    for name, diffuse in {
            "wall": [0.76, 0.74, 0.70], "wall_bedroom": [0.60, 0.66, 0.68], "ceiling": 0.84, "oak_floor": [0.38, 0.26, 0.16],
            "pane": 0.04, "window_frame": 0.70, "sill": 0.70, "door": 0.70, "door_frame": 0.72, "steel": 0.42,
            "sofa": [0.20, 0.24, 0.28], "cushion_green": [0.16, 0.26, 0.16], "cushion_ochre": [0.52, 0.33, 0.08],
            "oak": [0.44, 0.30, 0.18], "linen": 0.76, "duvet": [0.42, 0.50, 0.58], "cupboard": [0.70, 0.69, 0.66],
            "book_red": [0.38, 0.06, 0.05], "book_blue": [0.07, 0.14, 0.32], "book_cream": [0.66, 0.60, 0.48],
            "book_green": [0.08, 0.22, 0.12], "book_dark": 0.05, "black": 0.04, "screen": 0.03, "ceramic": [0.66, 0.60, 0.52],
            "curtain": [0.62, 0.58, 0.50], "rug_plain": [0.50, 0.44, 0.36], "mirror": 0.10, "pot": [0.46, 0.22, 0.13],
            "soil": [0.06, 0.045, 0.035], "leaf": [0.07, 0.20, 0.05], "print_1": [0.62, 0.28, 0.16],
            "print_2": [0.14, 0.30, 0.36]}.items():
        project.material(name, diffuse)
    project.material("rug", 1.0, diffuse_map="rug.png")


def make():
    rng = random.Random(4)
    model, shell = Model(), _shell()
    for material, part in shell.parts().items():
        model.add("Rooms", material, part)
    _doors_and_windows(model)
    _living_room(model, rng)
    _bedroom(model)
    project = Project("Flat", "flat.obj", exposure=0.4, white_balance=3200)
    _materials(project)
    files = flat_lighting.light(project)
    files["rug.png"] = paintings.rug(690, 510)
    project.camera("Living room", [4.95, 2.1, 1.55], [0.9, 2.2, 0.95], 62)
    project.camera("From the sofa", [0.7, 3.9, 1.5], [4.6, 0.9, 0.95], 62)
    project.camera("Bedroom", [5.55, 3.95, 1.6], [8.6, 1.6, 0.75], 62)
    project.camera("Through the doorway", [3.1, 1.55, 1.55], [8.0, 2.05, 1.0], 50)
    project.work_plane("Living room", [1.0, 0.5, 0.75], [4.0, 0, 0], [0, 3.6, 0], [16, 14], "home.living")
    project.work_plane("Bedroom", [5.8, 0.7, 0.75], [3.2, 0, 0], [0, 3.4, 0], [13, 14], "home.bedroom")
    return {"project": project, "model": model, "shell": shell, "title": "Flat", "files": files}
