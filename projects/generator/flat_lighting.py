# SPDX-License-Identifier: MIT
"""The flat's luminaires and its layouts."""
from . import home
from .model import Model

SHADE = (0.20, 0.15, 0.26)       # floor lamp: lower and upper radius, height
BEDSIDE = (0.11, 0.08, 0.16)


def _luminaires(project):
    add = project.luminaire
    add("Ceiling living room", shape={"disk": 0.25}, position=[2.4, 2.3, 2.585], flux=2600, cct=3000, group="Ceiling")
    add("Ceiling bedroom", shape={"disk": 0.20}, position=[7.2, 2.2, 2.585], flux=1900, cct=3000, group="Ceiling")
    add("Pendant", shape={"sphere": 0.14}, position=[4.5, 0.58, 1.62], flux=900, cct=2700, group="Dining")
    add("Floor lamp", shape={"mesh": "shade.obj"}, position=[0.42, 1.55, 1.38], flux=850, cct=2700, group="Lamps")
    for k, y in enumerate((1.24, 3.46), 1):
        add(f"Bedside {k}", shape={"mesh": "bedside_shade.obj"}, position=[8.92, y, 0.68], flux=320, cct=2700, group="Bedside")
    add("Bookcase light", shape={"tube": [1.5, 0.008]}, position=[1.0, 0.34, 2.06], flux=420, cct=3000, group="Lamps")


def light(project):
    """Adds luminaires and layouts; returns further files of the project."""
    _luminaires(project)
    off = {"on": False}
    project.layout("Everyday")
    project.layout("Ceiling lights only", luminaires={
        name: off for name in ("Pendant", "Floor lamp", "Bedside 1", "Bedside 2", "Bookcase light")})
    project.layout("Evening", luminaires={
        "Ceiling living room": off, "Ceiling bedroom": off, "Pendant": {"dimming": 0.6},
        "Bedside 2": off, "Bookcase light": {"dimming": 0.5}})
    project.layout("Pendant over the coffee table", luminaires={
        "Ceiling living room": {"dimming": 0.2}, "Ceiling bedroom": off,
        "Pendant": {"position": [1.85, 2.9, 1.75], "flux": 1500}})
    shade, bedside = Model(), Model()
    shade.add("Shade", "light", home.shade(*SHADE))
    bedside.add("Shade", "light", home.shade(*BEDSIDE))
    return {"shade.obj": shade, "bedside_shade.obj": bedside}
