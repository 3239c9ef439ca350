# SPDX-License-Identifier: MIT
"""The gallery's luminaires, their static heads, and its layouts."""
from . import sculptures
from .model import Model
from .photometry import spot_ies
from .project import luminaire_fields
from .solids import box, cylinder
from .vectors import add, aim_rotation, rotated, sub

FRONT = 3.04  # height of a spot's front
HEAD_RADIUS, HEAD_LENGTH, GAP = 0.048, 0.13, 0.004

# Name, place on a track, aim, beam, lumens.
SPOTS = [
    ("Picture 1 left", (1.35, 4.7), (1.45, 6.0, 1.5), "wide", 620),
    ("Picture 1 right", (2.25, 4.7), (2.15, 6.0, 1.5), "wide", 620),
    ("Picture 2", (5.0, 4.7), (5.0, 6.0, 1.5), "wide", 800),
    ("Picture 3", (8.2, 4.7), (8.2, 6.0, 1.5), "wide", 800),
    ("Picture 4 left", (1.35, 1.3), (1.45, 0.0, 1.5), "wide", 620),
    ("Picture 4 right", (2.25, 1.3), (2.15, 0.0, 1.5), "wide", 620),
    ("Picture 5", (5.0, 1.3), (5.0, 0.0, 1.5), "wide", 800),
    ("Picture 6", (8.2, 1.3), (8.2, 0.0, 1.5), "wide", 900),
    ("Picture 7", (3.4, 3.0), (4.9, 3.0, 1.5), "wide", 900),
    ("Picture 8", (6.6, 3.0), (5.1, 3.0, 1.5), "wide", 900),
    ("Picture 9 left", (8.9, 1.3), (10.0, 2.75, 1.5), "wide", 1000),
    ("Picture 9 right", (8.9, 4.7), (10.0, 3.25, 1.5), "wide", 1000),
    ("Knot left", (0.8, 1.3), (1.9, 3.0, 1.35), "narrow", 200),
    ("Knot right", (3.4, 4.1), (1.9, 3.0, 1.35), "narrow", 200),
    ("Column left", (6.6, 2.1), (7.4, 4.2, 1.35), "narrow", 200),
    ("Column right", (9.3, 4.7), (7.4, 4.2, 1.35), "narrow", 170),
    ("Pebble left", (6.6, 3.9), (7.4, 1.8, 1.1), "narrow", 200),
    ("Pebble right", (9.3, 1.3), (7.4, 1.8, 1.1), "narrow", 170),
]


def _rotation(place, aim):
    return aim_rotation(sub(aim, (*place, FRONT)))


def heads():
    """The static body behind each spot's front and the adapter that holds it on the track."""
    for name, place, aim, _, _ in SPOTS:
        rotation = _rotation(place, aim)
        middle = add((*place, FRONT), rotated((0, 0, GAP + HEAD_LENGTH / 2), *rotation))
        body = cylinder(HEAD_RADIUS, GAP, GAP + HEAD_LENGTH, 16).turned(*rotation).moved(*place, FRONT)
        # The adapter spans from the head's middle to the track, both of which it enters.
        low = (min(middle[0], place[0]) - 0.012, min(middle[1], place[1]) - 0.012, middle[2])
        high = (max(middle[0], place[0]) + 0.012, max(middle[1], place[1]) + 0.012, 3.175)
        yield f"Spot {name}", [("track", body), ("track", box(low, high))]


def _spot(place, aim, beam, lumens, **more):
    return luminaire_fields({"disk": 0.04}, (*place, FRONT), lumens, rotation=_rotation(place, aim),
                            distribution={"ies": f"spot_{beam}.ies"}, **more)


def _tubes():
    fields = {f"Spot {spot[0]}": {"on": False} for spot in SPOTS}
    k = 0
    for y in (0.85, 5.15):
        for i in range(5):
            k += 1
            fields[f"Tube {k}"] = luminaire_fields({"tube": [1.5, 0.013]}, [1.6 + 1.7 * i, y, 3.02], 2000, "Tubes", cct=4000)
    for y in (2.1, 3.9):
        k += 1
        fields[f"Tube {k}"] = luminaire_fields({"tube": [1.5, 0.013]}, [9.15, y, 3.02], 2000, "Tubes", cct=4000,
                                               rotation=[0, 0, 90])
    return fields


def _evening():
    fields = {}
    for name, *_ in SPOTS:
        picture = name.startswith("Picture")
        fields[f"Spot {name}"] = {"dimming": 0.12 if picture else 1.0, "colour": {"cct": 2700}}
    fields["Neon"] = luminaire_fields({"mesh": "neon.obj"}, [0.12, 3.0, 2.76], 700, "Neon", rotation=[0, 90, 0],
                                      rgb=[1.0, 0.22, 0.42])
    fields["Cove"] = luminaire_fields({"rectangle": [0.05, 2.7]}, [5.0, 3.0, 2.63], 1100, "Cove", rotation=[180, 0, 0],
                                      rgb=[0.3, 0.5, 1.0])
    return fields


def _neon_mesh():
    """A knotted glass tube, 0.5 m across, lying in its xy plane."""
    return sculptures.knot(2, 5, 0.17, 0.05, 0.010, 120, 6)


def _files():
    neon = Model()
    neon.add("Neon", "light", _neon_mesh())
    return {"neon.obj": neon, "spot_narrow.ies": spot_ies("Narrow spot", 12, 0.5),
            "spot_wide.ies": spot_ies("Wide spot", 38, 1.0)}


def _layouts(project):
    project.layout("Track spots")
    project.layout("Tubes", luminaires=_tubes())
    project.layout("Spots and tubes", luminaires={
        **{name: {**fields, "dimming": 0.3} for name, fields in _tubes().items() if name.startswith("Tube")}})
    project.layout("Evening", luminaires=_evening())


def _spots(project):
    for name, place, aim, beam, lumens in SPOTS:
        group = "Pictures" if name.startswith("Picture") else "Sculptures"
        fields = _spot(place, aim, beam, lumens, group=group, cct=4000)
        project.luminaires.append({"name": f"Spot {name}", **fields})


def light(project):
    """Adds luminaires and layouts; returns further files of the project."""
    _spots(project)
    _layouts(project)
    return _files()
