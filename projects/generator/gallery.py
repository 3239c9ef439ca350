# SPDX-License-Identifier: MIT
"""A gallery, 10 x 6 x 3.2 m: hung pictures, sculptures on plinths, a glossy floor, tracks."""
from . import gallery_lighting, joinery, paintings, sculptures
from .model import Model
from .project import Project
from .shell import Shell
from .solids import box, chamfered_box, frame, textured

SIZE = (10.0, 6.0, 3.2)
EYE = 1.55  # middle of the pictures
DOOR_Y, DOOR_SIZE, DOOR_RECESS = 3.0, (1.9, 2.35), 0.12
FREE_WALL = ((4.92, 1.6, -0.006), (5.08, 4.4, 2.6))  # its chamfer lies below the floor

# Wall, x, y of the middle, width, height, pixels across; in the order of paintings.PAINTINGS.
PICTURES = [
    ("+y", 1.8, 6.0, 1.50, 0.95, 320), ("+y", 5.0, 6.0, 1.05, 1.05, 300), ("+y", 8.2, 6.0, 1.10, 1.10, 300),
    ("-y", 1.8, 0.0, 1.40, 0.90, 280), ("-y", 5.0, 0.0, 1.00, 1.20, 240), ("-y", 8.2, 0.0, 1.35, 0.90, 280),
    ("+x", 4.92, 3.0, 0.90, 1.30, 200), ("-x", 5.08, 3.0, 1.60, 1.00, 280), ("+x", 10.0, 3.0, 1.80, 1.25, 320)]
PLINTHS = [(1.9, 3.0, 1.05, "bronze"), (7.4, 4.2, 0.95, "marble"), (7.4, 1.8, 0.90, "plaster")]
TRACKS = [((0.6, 1.3), (9.4, 1.3)), ((0.6, 4.7), (9.4, 4.7)), ((3.4, 1.7), (3.4, 4.3)), ((6.6, 1.7), (6.6, 4.3))]


def _shell():
    shell = Shell()
    shell.room((0, 0, 0), SIZE)
    shell.room((-DOOR_RECESS, DOOR_Y - DOOR_SIZE[0] / 2, 0), (0, DOOR_Y + DOOR_SIZE[0] / 2, DOOR_SIZE[1]))
    shell.paint("wall")
    shell.paint("ceiling", "+z", (0, 0, 3), (SIZE[0], SIZE[1], 4))
    shell.paint("floor", "-z")
    return shell


def _pictures(model):
    for k, (side, x, y, width, height, _) in enumerate(PICTURES, 1):
        canvas = box((-width / 2 + 0.022, -0.018, EYE - height / 2 + 0.022),
                     (width / 2 - 0.022, 0.0015, EYE + height / 2 - 0.022))
        pieces = [("frame_dark" if k % 2 else "frame_oak", frame(width, height, 0.03, 0.042).moved(y=-0.04, z=EYE)),
                  (f"picture_{k}", textured(canvas, 0, 2))]
        model.add_all(f"Picture {k}", pieces, joinery.on_wall(side, x, y))


def _sculptures(model):
    made = [sculptures.standing_knot(), sculptures.twisted_column(), sculptures.pebble()]
    for k, ((x, y, height, material), part) in enumerate(zip(PLINTHS, made), 1):
        model.add(f"Plinth {k}", "plinth", chamfered_box((x - 0.24, y - 0.24, -0.006), (x + 0.24, y + 0.24, height), 0.003))
        model.add(f"Sculpture {k}", material, part.moved(x, y, height))


def _fittings(model):
    model.add("Free wall", "wall", chamfered_box(*FREE_WALL, 0.004))
    place = joinery.on_wall("-x", 0.0, DOOR_Y)
    model.add_all("Entrance", joinery.double_door(*DOOR_SIZE, DOOR_RECESS), place)
    for x, y, turn in ((3.65, 3.0, 90), (8.75, 3.0, 90)):
        bench = [("oak", chamfered_box((-0.80, -0.21, 0.40), (0.80, 0.21, 0.45), 0.006))]
        for side in (-1, 1):
            bench.append(("steel", box((side * 0.6 - 0.025, -0.17, -0.002), (side * 0.6 + 0.025, 0.17, 0.405))))
        model.add_all("Bench", bench, lambda part, x=x, y=y, turn=turn: part.turned(rz=turn).moved(x, y))
    for (x0, y0), (x1, y1) in TRACKS:
        model.add("Track", "track", box((x0 - 0.018, y0 - 0.018, SIZE[2] - 0.032), (x1 + 0.018, y1 + 0.018, SIZE[2] + 0.002)))
    for name, pieces in gallery_lighting.heads():
        model.add_all(name, pieces)


def _materials(project):
    project.material("wall", 0.78)
    project.material("ceiling", 0.70)
    project.material("floor", [0.30, 0.285, 0.26], specular=0.04, roughness=0.25)
    project.material("frame_dark", 0.05)
    project.material("frame_oak", [0.38, 0.25, 0.14])
    project.material("plinth", 0.76)
    project.material("bronze", [0.20, 0.12, 0.06], specular=0.25, roughness=0.5)
    project.material("marble", [0.74, 0.72, 0.68], specular=0.04, roughness=0.4)
    project.material("plaster", [0.66, 0.58, 0.50])
    project.material("oak", [0.42, 0.29, 0.17])
    project.material("steel", 0.12)
    project.material("track", 0.06)
    project.material("door", 0.16)
    for k in range(1, len(PICTURES) + 1):
        project.material(f"picture_{k}", 1.0, diffuse_map=f"picture_{k}.png")


def _cameras_and_planes(project):
    project.camera("Entrance", [0.35, 1.0, 1.65], [4.8, 3.9, 1.35], 58)
    project.camera("Far corner", [9.6, 5.5, 1.7], [5.6, 1.9, 1.15], 58)
    project.camera("Sculpture", [3.15, 1.45, 1.5], [1.7, 3.4, 1.25], 55)
    project.camera("Along the pictures", [9.55, 4.0, 1.6], [3.0, 5.6, 1.4], 55)
    for k, (side, x, y, width, height, _) in enumerate(PICTURES, 1):
        # 5 cm in front of the wall (the frame stands out 4 cm); u x v points into the room.
        out = {"+y": (0, -1), "-y": (0, 1), "+x": (-1, 0), "-x": (1, 0)}[side]
        along = (-out[1], out[0])
        origin = [round(c, 4) for c in (x + 0.05 * out[0] - along[0] * width / 2,
                                        y + 0.05 * out[1] - along[1] * width / 2, EYE - height / 2)]
        project.work_plane(f"Picture {k}", origin, [along[0] * width, along[1] * width, 0], [0, 0, height],
                           [7, 5], "museum.display")
    for name, y in (("Walk along pictures 1 to 3", 4.7), ("Walk along pictures 4 to 6", 0.4)):
        project.work_plane(name, [0.5, y, 0.01], [9, 0, 0], [0, 0.9, 0], [30, 3], "circulation")


def make():
    model, shell = Model(), _shell()
    for material, part in shell.parts().items():
        model.add("Room", material, part)
    _fittings(model)
    _pictures(model)
    _sculptures(model)
    project = Project("Gallery", "gallery.obj", exposure=0.1, white_balance=4000)
    _materials(project)
    files = gallery_lighting.light(project)
    for k, (_, _, _, width, height, pixels) in enumerate(PICTURES, 1):
        files[f"picture_{k}.png"] = paintings.painting(k - 1, pixels, round(pixels * height / width))
    _cameras_and_planes(project)
    return {"project": project, "model": model, "shell": shell, "title": "Gallery", "files": files}
